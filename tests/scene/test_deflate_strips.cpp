// Strips of a zlib stream: zlib itself reads them as one.
#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include <zlib.h>

#include "scene/files/deflate_strips.hpp"
#include "scene/render/threads.hpp"

using namespace kreda;

namespace {

using Bytes = std::vector<unsigned char>;

/// Waves that repeat far apart, so that a strip has something to refer to, and a grain.
Bytes waves(std::size_t count) {
    Bytes bytes(count);
    std::uint32_t grain = 1;
    for (std::size_t i = 0; i < count; ++i) {
        grain = grain * 1664525u + 1013904223u;
        bytes[i] = static_cast<unsigned char>(i % 3001 / 17 + (grain >> 30));
    }
    return bytes;
}

Bytes joined(const std::vector<Bytes>& parts) {
    Bytes all;
    for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

Bytes inflated(const Bytes& stream, std::size_t count) {
    Bytes bytes(count + 1);
    uLongf size = bytes.size();
    REQUIRE(uncompress(bytes.data(), &size, stream.data(), stream.size()) == Z_OK);
    bytes.resize(size);
    return bytes;
}

}  // namespace

TEST_CASE("strips together are a stream that zlib inflates to the same bytes: none, one, full and cut strips") {
    constexpr std::size_t kStrip = 1 << 18;
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, kStrip - 1, kStrip, kStrip + 1, 3 * kStrip}) {
        const Bytes bytes = waves(count);
        CHECK(inflated(joined(scene::deflate_strips(bytes)), count) == bytes);
    }
}

TEST_CASE("strips do not depend on the threads, and are hardly longer than one stream") {
    const Bytes bytes = waves(1000000);
    Bytes with_one, with_three;
    {
        const scene::ThreadLimit limit(1);
        with_one = joined(scene::deflate_strips(bytes));
    }
    {
        const scene::ThreadLimit limit(3);
        with_three = joined(scene::deflate_strips(bytes));
    }
    CHECK(with_one == with_three);
    uLongf size = compressBound(bytes.size());
    Bytes whole(size);
    REQUIRE(compress2(whole.data(), &size, bytes.data(), bytes.size(), 6) == Z_OK);
    CHECK(with_one.size() < size + size / 100 + 64);  // a percent: each strip ends a block early
}
