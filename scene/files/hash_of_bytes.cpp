#include "scene/files/hash_of_bytes.hpp"

#include <array>
#include <bit>
#include <cstdio>
#include <cstring>

namespace kreda::scene {

namespace {

constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87;
constexpr std::uint64_t kPrime2 = 0xC2B2AE3D27D4EB4F;
constexpr std::uint64_t kPrime3 = 0x165667B19E3779F9;
constexpr std::uint64_t kPrime4 = 0x85EBCA77C2B2AE63;
constexpr std::uint64_t kPrime5 = 0x27D4EB2F165667C5;

/// The number that begins at `bytes`, in the order of this machine: files that keep such hashes stay on it.
template <typename Number>
std::uint64_t number_at(const std::byte* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

std::uint64_t round_of(std::uint64_t sum, std::uint64_t number) {
    return std::rotl(sum + number * kPrime2, 31) * kPrime1;
}

/// Four sums side by side take 32 bytes at a time; `bytes` keeps the rest, fewer than 32.
std::uint64_t hash_of_stripes(std::span<const std::byte>& bytes, std::uint64_t seed) {
    std::array<std::uint64_t, 4> sums = {seed + kPrime1 + kPrime2, seed + kPrime2, seed, seed - kPrime1};
    for (; bytes.size() >= 32; bytes = bytes.subspan(32)) {
        for (std::size_t i = 0; i < 4; ++i) sums[i] = round_of(sums[i], number_at<std::uint64_t>(&bytes[8 * i]));
    }
    std::uint64_t hash =
        std::rotl(sums[0], 1) + std::rotl(sums[1], 7) + std::rotl(sums[2], 12) + std::rotl(sums[3], 18);
    for (const std::uint64_t sum : sums) hash = (hash ^ round_of(0, sum)) * kPrime1 + kPrime4;
    return hash;
}

/// The last bytes: by eight, by four, one by one.
std::uint64_t add_rest(std::uint64_t hash, std::span<const std::byte> bytes) {
    for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
        hash = std::rotl(hash ^ round_of(0, number_at<std::uint64_t>(bytes.data())), 27) * kPrime1 + kPrime4;
    }
    if (bytes.size() >= 4) {
        hash = std::rotl(hash ^ (number_at<std::uint32_t>(bytes.data()) * kPrime1), 23) * kPrime2 + kPrime3;
        bytes = bytes.subspan(4);
    }
    for (const std::byte byte : bytes) {
        hash = std::rotl(hash ^ (std::to_integer<std::uint64_t>(byte) * kPrime5), 11) * kPrime1;
    }
    return hash;
}

}  // namespace

std::uint64_t hash_of_bytes(std::span<const std::byte> bytes, std::uint64_t seed) {
    const std::uint64_t length = bytes.size();
    std::uint64_t hash = length >= 32 ? hash_of_stripes(bytes, seed) : seed + kPrime5;
    hash = add_rest(hash + length, bytes);
    hash = (hash ^ (hash >> 33)) * kPrime2;
    hash = (hash ^ (hash >> 29)) * kPrime3;
    return hash ^ (hash >> 32);
}

std::string hash_text(std::uint64_t hash) {
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

}  // namespace kreda::scene
