// Files that appear whole or not at all, also when several programs write the same one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace kreda::scene {

/// Bytes that stand one after another in a file.
using Bytes = std::span<const std::byte>;

/// Write under a name that no other process uses, then rename: a reader never sees half a file, and a failure leaves
/// the old one alone. Throws UserError.
void write_whole_file(const std::string& path, const std::vector<Bytes>& parts);

}  // namespace kreda::scene
