// A number that tells the contents of files apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace kreda::scene {

/// XXH64 of the bytes: 64 bits that tell contents apart, at several bytes a nanosecond; no secret is safe with it.
/// `seed`: the hash of what came before. Source: Collet, "xxHash fast digest algorithm", specification 0.1.1.
[[nodiscard]] std::uint64_t hash_of_bytes(std::span<const std::byte> bytes, std::uint64_t seed = 0);

/// A hash as it stands in names and files: 16 hexadecimal digits.
[[nodiscard]] std::string hash_text(std::uint64_t hash);

}  // namespace kreda::scene
