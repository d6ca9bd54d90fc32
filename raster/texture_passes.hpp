// Looking up textures for a whole batch of points.
#pragma once

#include "raster/fragments.hpp"
#include "raster/texture.hpp"

namespace kreda::raster {

/// Level of detail of every point from the steps of its uv: what `trilinear` reads.
void find_levels(const Fragments& fragments, const Texture& texture, Channel& level);

/// A texture of 3 channels at every point's (u, v). `level` counts for trilinear alone.
void sample_color(const Fragments& fragments, const Channel& level, const Texture& texture, TextureFilter filter,
                  TextureWrap wrap, Channel3& out);

/// A texture of 1 channel.
void sample_value(const Fragments& fragments, const Channel& level, const Texture& texture, TextureFilter filter,
                  TextureWrap wrap, Channel& out);

}  // namespace kreda::raster
