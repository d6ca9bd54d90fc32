// A file of floats that belongs to a key: the form in which baked maps are kept.
//   "KREDAMAP"; as 64-bit numbers the bytes of the key, the bytes of the floats, the hash of both; the key; the floats
// All in the byte order of the machine, which therefore stands in every key.
#pragma once

#include <span>
#include <string>

namespace kreda::scene {

/// Read exactly as many floats as there is room for. False, and the floats are worthless: no such file, another key,
/// cut off, or damaged.
[[nodiscard]] bool read_map_file(const std::string& path, const std::string& key, std::span<float> floats);

/// Throws UserError.
void write_map_file(const std::string& path, const std::string& key, std::span<const float> floats);

}  // namespace kreda::scene
