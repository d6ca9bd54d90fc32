#include "scene/files/hash_of_bytes.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>

using kreda::scene::hash_of_bytes;

namespace {

std::uint64_t hash_of(const std::string& text, std::uint64_t seed = 0) {
    return hash_of_bytes(std::as_bytes(std::span(text)), seed);
}

}  // namespace

TEST_CASE("hash of bytes: the numbers that xxHash's own documents give for XXH64") {
    CHECK(hash_of("") == 0xEF46DB3751D8E999);
    CHECK(hash_of("a") == 0xD24EC4F1A98C6E5B);
    CHECK(hash_of("abc") == 0x44BC2CF5AD770999);
    CHECK(hash_of("xxhash", 20141025) == 13067679811253438005u);
    CHECK(hash_of("Nobody inspects the spammish repetition") == 0xFBCEA83C8A378BF1);  // 39 bytes: a stripe, and 7 more
}

TEST_CASE("hash of bytes: each bit of each byte matters, for any length") {
    for (std::size_t length = 1; length < 80; ++length) {
        std::vector<std::byte> bytes(length, std::byte(0x5a));
        const std::uint64_t before = hash_of_bytes(bytes);
        for (std::size_t i = 0; i < 8 * length; ++i) {
            bytes[i / 8] ^= std::byte(1 << (i % 8));
            CHECK(hash_of_bytes(bytes) != before);
            bytes[i / 8] ^= std::byte(1 << (i % 8));
        }
    }
}
