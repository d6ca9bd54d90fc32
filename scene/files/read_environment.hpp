// The [environment] table of a scene file, and the images that it names.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lighting/environment/environment_image.hpp"
#include "scene/environment.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

struct LoadedFiles;

/// An equirectangular image, ready to be light, and what had to be mended.
struct EnvironmentImage {
    std::shared_ptr<const raster::Image> image;
    lighting::EnvironmentRepairs repairs;
    std::vector<std::string> remarks;  ///< for people: "is 100 x 90, not twice as wide as high; it is stretched"
};

/// Read as linear light (8 and 16 bits are decoded as sRGB, as textures are) and repair. An image that is too small is
/// refused at `place`, where `subject` ("'sky.hdr' ") begins the message. Throws UserError.
[[nodiscard]] EnvironmentImage read_environment_image(const std::string& path, const Place& place,
                                                      const std::string& subject);

/// Reads the table and, unless it is off, its image; what had to be repaired there is a warning. Relative paths start
/// at `folder`. files: what is kept, or nullptr. Throws UserError.
[[nodiscard]] EnvironmentSettings read_environment(const Value& table, const std::string& folder, LoadedFiles* files,
                                                   std::vector<std::string>& warnings);

}  // namespace kreda::scene
