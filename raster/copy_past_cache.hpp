// Writes floats past the caches. A film is larger than they are and is not read soon; an ordinary store would first
// read the cache line that it changes.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "raster/aligned_vector.hpp"

namespace kreda::raster {

/// Copy `count` floats. Whole cache lines go straight to memory where the machine can do that (the only intrinsic of
/// the project: it moves floats and computes nothing); elsewhere this is the loop at the end. The arrays do not
/// overlap.
inline void copy_past_cache(const float* __restrict from, int count, float* __restrict to) {
    int i = 0;
#if defined(__SSE2__)
    constexpr int kFloatsPerLine = kCacheLine / sizeof(float);
    while (i < count && reinterpret_cast<std::uintptr_t>(to + i) % kCacheLine != 0) to[i] = from[i], ++i;
    for (; i + kFloatsPerLine <= count; i += kFloatsPerLine) {
        for (int k = i; k < i + kFloatsPerLine; k += 4) _mm_stream_ps(to + k, _mm_loadu_ps(from + k));
    }
#endif
    for (; i < count; ++i) to[i] = from[i];
}

/// Before another thread may read what copy_past_cache wrote.
inline void finish_copies() {
#if defined(__SSE2__)
    _mm_sfence();
#endif
}

}  // namespace kreda::raster
