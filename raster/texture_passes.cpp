#include "raster/texture_passes.hpp"

#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

/// Where a batch is looked up: its uv and levels as bare arrays.
struct Places {
    const float* u;
    const float* v;
    const float* level;
};

// `texels` and `out` are parameters of their own because only `__restrict` tells the compiler that what is written does
// not change the texels; without it no loop is vectorized.

KREDA_BATCH_LOOP void nearest_channel(const Places& places, int lanes, const TextureView& view,
                                      const float* __restrict texels, int channel, float* __restrict out) {
    const Places p = places;
    TextureView t = view;
    t.texels = texels;
    for (int i = 0; i < lanes; ++i) out[i] = sample_nearest(t, p.u[i], p.v[i], channel);
}

KREDA_BATCH_LOOP void bilinear_channel(const Places& places, int lanes, const TextureView& view,
                                       const float* __restrict texels, int channel, float* __restrict out) {
    const Places p = places;
    TextureView t = view;
    t.texels = texels;
    for (int i = 0; i < lanes; ++i) out[i] = sample_bilinear(t, p.u[i], p.v[i], channel);
}

KREDA_BATCH_LOOP void trilinear_channel(const Places& places, int lanes, const TextureView& view,
                                        const float* __restrict texels, int channel, float* __restrict out) {
    const Places p = places;
    TextureView t = view;
    t.texels = texels;
    for (int i = 0; i < lanes; ++i) out[i] = sample_trilinear(t, p.u[i], p.v[i], p.level[i], channel);
}

KREDA_BATCH_LOOP void levels(const Fragments& f, int lanes, int width, int height, float* __restrict level) {
    const int w = width;
    const int h = height;
    for (int i = 0; i < lanes; ++i) {
        level[i] = level_of_detail({f.du_dx.at(i), f.dv_dx.at(i)}, {f.du_dy.at(i), f.dv_dy.at(i)}, w, h);
    }
}

void sample_channel(const Fragments& fragments, const Channel& level, const TextureView& view, TextureFilter filter,
                    int channel, float* out) {
    const Places places{fragments.u.value, fragments.v.value, level.value};
    const int lanes = lanes_for(fragments.count);
    switch (filter) {
        case TextureFilter::nearest:
            return nearest_channel(places, lanes, view, view.texels, channel, out);
        case TextureFilter::bilinear:
            return bilinear_channel(places, lanes, view, view.texels, channel, out);
        case TextureFilter::trilinear:
            return trilinear_channel(places, lanes, view, view.texels, channel, out);
    }
}

}  // namespace

void find_levels(const Fragments& fragments, const Texture& texture, Channel& level) {
    levels(fragments, lanes_for(fragments.count), texture.width, texture.height, level.value);
}

void sample_color(const Fragments& fragments, const Channel& level, const Texture& texture, TextureFilter filter,
                  TextureWrap wrap, Channel3& out) {
    KREDA_EXPECT(texture.channels == 3);
    const TextureView view = view_of(texture, wrap);
    sample_channel(fragments, level, view, filter, 0, out.x);
    sample_channel(fragments, level, view, filter, 1, out.y);
    sample_channel(fragments, level, view, filter, 2, out.z);
}

void sample_value(const Fragments& fragments, const Channel& level, const Texture& texture, TextureFilter filter,
                  TextureWrap wrap, Channel& out) {
    KREDA_EXPECT(texture.channels == 1);
    sample_channel(fragments, level, view_of(texture, wrap), filter, 0, out.value);
}

}  // namespace kreda::raster
