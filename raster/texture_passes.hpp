// Looking up textures for a whole batch of points.
#pragma once

#include "raster/fragments.hpp"
#include "raster/texture.hpp"

namespace kreda::raster {

/// How a texture lies on a surface and is read.
struct TextureLookup {
    TextureFilter filter = TextureFilter::trilinear;  ///< how it is read between its texels
    TextureWrap wrap = TextureWrap::repeat;           ///< what lies beyond 0..1 of u and v
    glm::vec2 scale{1.0f};  ///< multiplies u and v: how often the picture is laid over the unit square
};

/// Level of detail of every point from the steps of its uv: what `trilinear` reads.
void set_levels(const Fragments& fragments, const Texture& texture, const TextureLookup& lookup, Channel& level);

/// A texture of 3 channels at every point's (u, v). `level` counts for trilinear alone.
void sample_color(const Fragments& fragments, const Channel& level, const Texture& texture, const TextureLookup& lookup,
                  Channel3& out);

/// A texture of 1 channel.
void sample_value(const Fragments& fragments, const Channel& level, const Texture& texture, const TextureLookup& lookup,
                  Channel& out);

}  // namespace kreda::raster
