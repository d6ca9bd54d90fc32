// Bytes as letters, for pages and results that hold pictures.
#pragma once

#include <span>
#include <string>

namespace kreda::tools {

/// Base 64 with padding.    RFC 4648, section 4
[[nodiscard]] std::string base64(std::span<const unsigned char> bytes);

}  // namespace kreda::tools
