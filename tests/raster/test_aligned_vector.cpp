// Copies past the cache against the plain loop; where aligned vectors begin.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "raster/aligned_vector.hpp"
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

TEST_CASE("an aligned vector begins with a cache line, whatever its size") {
    for (const std::size_t floats : {1, 3, 100, 1'000'000, 1'048'576, 7'000'000}) {
        CAPTURE(floats);
        raster::AlignedVector<float> block(floats, 1.0f);
        CHECK(reinterpret_cast<std::uintptr_t>(block.data()) % raster::kCacheLine == 0);
        block.push_back(2.0f);  // moves what is there
        CHECK(reinterpret_cast<std::uintptr_t>(block.data()) % raster::kCacheLine == 0);
        CHECK((block.front() == 1.0f && block[floats - 1] == 1.0f && block.back() == 2.0f));
    }
}
