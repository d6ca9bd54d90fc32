// Copies past the cache against the plain loop; where large blocks of memory begin.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "raster/copy_past_cache.hpp"

using namespace kreda;

TEST_CASE("a copy past the cache writes its floats and nothing else") {
    std::vector<float> from(200), to(200);
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<float>(i + 1);
    int wrong = 0;
    for (int offset = 0; offset < 20; ++offset) {  // every place within a cache line, for source and target
        for (int count = 0; count < 100; ++count) {
            std::fill(to.begin(), to.end(), -1.0f);
            raster::copy_past_cache(from.data() + offset, count, to.data() + 2 * offset);
            raster::finish_copies();
            for (int i = 0; i < 200; ++i) {
                const bool inside = i >= 2 * offset && i < 2 * offset + count;
                const float want = inside ? from[static_cast<std::size_t>(i - offset)] : -1.0f;
                wrong += to[static_cast<std::size_t>(i)] != want;
            }
        }
    }
    CHECK(wrong == 0);
}

#if !defined(KREDA_SANITIZED)
TEST_CASE("large blocks of memory begin with a cache line") {
    for (const std::size_t megabytes : {1, 3, 4, 5, 25}) {
        CAPTURE(megabytes);
        const std::vector<float> block(megabytes * 1024 * 1024 / sizeof(float) + 1);
        CHECK(reinterpret_cast<std::uintptr_t>(block.data()) % 64 == 0);
    }
}
#endif
