#include "lighting/environment/texel_taps.hpp"

#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

/// Four floats at once, written so that the compiler makes each line one vector operation.
struct Texel {
    float c[4];
};

inline Texel weighted(const float* texels, const TapChannels& taps, int i) {
    const float* a = texels + taps.first[i];
    const float* b = a + taps.next_row[i];
    const float w_00 = taps.w_00.at(i), w_10 = taps.w_10.at(i), w_01 = taps.w_01.at(i), w_11 = taps.w_11.at(i);
    Texel sum;
    for (int c = 0; c < 4; ++c) sum.c[c] = (w_00 * a[c] + w_10 * a[c + 4]) + (w_01 * b[c] + w_11 * b[c + 4]);
    return sum;
}

KREDA_BATCH_LOOP void read_one_level(const float* texels, int lanes, const TapChannels& taps, float* result) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: the four floats of a texel are the vector
        const Texel sum = weighted(texels, taps, i);
        for (int c = 0; c < 4; ++c) result[4 * i + c] = sum.c[c];
    }
}

KREDA_BATCH_LOOP void read_two_levels(const float* texels, int lanes, const TapChannels* taps, float* result) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: the four floats of a texel are the vector
        const Texel finer = weighted(texels, taps[0], i);
        const Texel coarser = weighted(texels, taps[1], i);
        for (int c = 0; c < 4; ++c) result[4 * i + c] = finer.c[c] + coarser.c[c];
    }
}

}  // namespace

void read_taps(const float* texels, int lanes, int levels, TapScratch& scratch) {
    if (levels == 1) return read_one_level(texels, lanes, scratch.taps[0], scratch.texel);
    read_two_levels(texels, lanes, scratch.taps, scratch.texel);
}

KREDA_BATCH_LOOP void split_texels(int lanes, const TapScratch& scratch, raster::Channel3& colors) {
    for (int i = 0; i < lanes; ++i) {
        const float* texel = scratch.texel + 4 * i;
        colors.set(i, {texel[0], texel[1], texel[2]});
    }
}

}  // namespace kreda::lighting
