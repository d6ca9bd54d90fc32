// WebP files, as far as OpenImageIO does not tell what stands in them.
#pragma once

#include <string>
#include <string_view>

namespace kreda::scene {

[[nodiscard]] bool is_webp(std::string_view bytes);

/// The same file that says of itself that it has no alpha. OpenImageIO multiplies WebP's colours by alpha in 8 bits,
/// where they cannot be got back; of this file it gives the colours that were stored. Alpha is lost.
[[nodiscard]] std::string webp_without_alpha(std::string_view bytes);

/// As EXIF counts, 1 to 8; 1 where the file has no EXIF data.
[[nodiscard]] int webp_orientation(std::string_view bytes);

}  // namespace kreda::scene
