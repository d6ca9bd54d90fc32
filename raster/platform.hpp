// What the whole project needs of the compiler: a check for programmer's errors and a mark for batch loops.
#pragma once

#include <cstdio>
#include <cstdlib>

/// KREDA_EXPECT(condition): a programmer's error stops the program with its place (debug, asan and test builds).
/// It is for broken contracts between functions; what a user can get wrong is reported by scene/error.hpp.
#if !defined(NDEBUG) || defined(KREDA_CHECKS)
#define KREDA_EXPECT(condition)                                                            \
    do {                                                                                   \
        if (!(condition)) {                                                                \
            std::fprintf(stderr, "%s:%d: expected: %s\n", __FILE__, __LINE__, #condition); \
            std::abort();                                                                  \
        }                                                                                  \
    } while (false)
#else
#define KREDA_EXPECT(condition) static_cast<void>(0)
#endif

/// Marks a batch loop: a function that runs one scalar formula over a whole batch. In `release` GCC compiles it once
/// for SSE4.2, once for AVX2 and once for AVX-512, and the right one is picked when the program starts. A clone inlines
/// what it calls, so nothing compiled for a newer machine leaks into the rest of the program.
///
/// Such a function takes small structs by value, and what it needs of a large one it copies before its loop: a copy of
/// its own cannot be changed by what the loop writes. Of what it holds by reference the compiler must fear that, reads
/// it again for every point, and gives up on vectors.
#if defined(KREDA_BATCH_LOOP)
// chosen by a check of the build, see tests/vectorized
#elif defined(KREDA_MULTIVERSION)
#define KREDA_BATCH_LOOP __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), flatten))
#else
#define KREDA_BATCH_LOOP
#endif

namespace kreda::raster {

/// Loops over a batch run up to the next multiple of this: whole vector registers, no rest. What lies behind the
/// last fragment is computed and never looked at. When stepping in a debugger there is nothing behind it.
#if defined(KREDA_MULTIVERSION) || defined(__wasm_simd128__)
inline constexpr int kBatchLanes = 16;
#else
inline constexpr int kBatchLanes = 1;
#endif

/// Number of lanes a loop over `count` fragments runs.
inline int lanes_for(int count) {
    return (count + kBatchLanes - 1) / kBatchLanes * kBatchLanes;
}

}  // namespace kreda::raster
