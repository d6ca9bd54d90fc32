#include "raster/texture_passes.hpp"

#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

/// Where a batch is looked up: its uv and levels as bare arrays.
struct Places {
    const float* u;
    const float* v;
    const float* level;
    glm::vec2 scale;
};

// `texels` and `out` are parameters of their own because only `__restrict` tells the compiler that what is written does
// not change the texels; without it no loop is vectorized.

KREDA_BATCH_LOOP void nearest_channel(Places p, int lanes, const TextureView& view, const float* __restrict texels,
                                      int channel, float* __restrict out) {
    TextureView t = view;
    t.texels = texels;
    for (int i = 0; i < lanes; ++i) out[i] = sample_nearest(t, p.u[i] * p.scale.x, p.v[i] * p.scale.y, channel);
}

KREDA_BATCH_LOOP void bilinear_channel(Places p, int lanes, const TextureView& view, const float* __restrict texels,
                                       int channel, float* __restrict out) {
    TextureView t = view;
    t.texels = texels;
    for (int i = 0; i < lanes; ++i) out[i] = sample_bilinear(t, p.u[i] * p.scale.x, p.v[i] * p.scale.y, channel);
}

KREDA_BATCH_LOOP void trilinear_channel(Places p, int lanes, const TextureView& view, const float* __restrict texels,
                                        int channel, float* __restrict out) {
    TextureView t = view;
    t.texels = texels;
    for (int i = 0; i < lanes; ++i)
        out[i] = sample_trilinear(t, p.u[i] * p.scale.x, p.v[i] * p.scale.y, p.level[i], channel);
}

KREDA_BATCH_LOOP void levels(const Fragments& f, int lanes, glm::vec2 scale, int w, int h, float* __restrict level) {
    for (int i = 0; i < lanes; ++i) {
        const glm::vec2 step_x(f.du_dx.at(i) * scale.x, f.dv_dx.at(i) * scale.y);
        const glm::vec2 step_y(f.du_dy.at(i) * scale.x, f.dv_dy.at(i) * scale.y);
        level[i] = level_of_detail(step_x, step_y, w, h);
    }
}

void sample_channel(const Fragments& fragments, const Channel& level, const TextureView& view,
                    const TextureLookup& lookup, int channel, float* out) {
    const Places places{fragments.u.value, fragments.v.value, level.value, lookup.scale};
    const int lanes = lanes_for(fragments.count);
    switch (lookup.filter) {
        case TextureFilter::nearest: return nearest_channel(places, lanes, view, view.texels, channel, out);
        case TextureFilter::bilinear: return bilinear_channel(places, lanes, view, view.texels, channel, out);
        case TextureFilter::trilinear: return trilinear_channel(places, lanes, view, view.texels, channel, out);
    }
}

}  // namespace

void set_levels(const Fragments& fragments, const Texture& texture, const TextureLookup& lookup, Channel& level) {
    levels(fragments, lanes_for(fragments.count), lookup.scale, texture.width, texture.height, level.value);
}

void sample_color(const Fragments& fragments, const Channel& level, const Texture& texture, const TextureLookup& lookup,
                  Channel3& out) {
    KREDA_EXPECT(texture.channels == 3);
    const TextureView view = view_of(texture, lookup.wrap);
    sample_channel(fragments, level, view, lookup, 0, out.x);
    sample_channel(fragments, level, view, lookup, 1, out.y);
    sample_channel(fragments, level, view, lookup, 2, out.z);
}

void sample_value(const Fragments& fragments, const Channel& level, const Texture& texture, const TextureLookup& lookup,
                  Channel& out) {
    KREDA_EXPECT(texture.channels == 1);
    sample_channel(fragments, level, view_of(texture, lookup.wrap), lookup, 0, out.value);
}

}  // namespace kreda::raster
