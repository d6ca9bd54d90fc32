#include "scene/read_environment.hpp"

#include "lighting/environment_image.hpp"
#include "scene/file_key.hpp"
#include "scene/image_file.hpp"
#include "scene/toml_check.hpp"

namespace kreda::scene {

namespace {

constexpr int kLeastWidth = 4;

/// The image, repaired. What was wrong with it is a warning.
std::shared_ptr<const raster::Image> load(const Value& key, const std::string& path, std::vector<std::string>& warnings) {
    auto image = std::make_shared<raster::Image>(read_image(path));
    const std::string size = std::to_string(image->width) + " x " + std::to_string(image->height);
    if (image->width < kLeastWidth || image->height < kLeastWidth / 2) {
        throw UserError(key.place, in_quotes(key.key) + ": " + in_quotes(path) + " is " + size +
                                       " pixels; an equirectangular image is twice as wide as high, e.g. 1024 x 512");
    }
    const auto warn = [&](const std::string& what) {
        warnings.push_back(UserError(key.place, in_quotes(path) + what).what());
    };
    if (image->width != 2 * image->height) warn(" is " + size + ", not twice as wide as high; it is stretched");
    const lighting::EnvironmentRepairs repairs = lighting::repair_environment(*image);
    if (repairs.total() > 0) {
        warn(" holds texels that are no light: " + std::to_string(repairs.negative) + " negative (set to 0), " +
             std::to_string(repairs.nan) + " not a number (mean of their neighbours), " +
             std::to_string(repairs.infinite) + " infinite (set to the largest finite one)");
    }
    return image;
}

}  // namespace

EnvironmentSettings read_environment(const Value& table, const std::string& folder, std::vector<std::string>& warnings) {
    const Value* file = find(table, "file");
    const Value* sky = find(table, "sky");
    if (!file && !sky) {
        throw UserError(table.place,
                        "[environment] needs a file or a sky, e.g. file = \"studio.hdr\" or sky = \"studio\"");
    }
    if (file && sky) {
        throw UserError(file->place, "'file' and 'sky' in [environment] both give the light; remove one of them");
    }
    EnvironmentSettings settings;
    settings.on = true;
    read_word(table, "sky", settings.sky);
    read(table, "rotation", settings.rotation_deg);
    read(table, "intensity", settings.intensity);
    read_word(table, "irradiance", settings.irradiance);
    read(table, "samples", settings.samples);
    read(table, "reference", settings.reference);
    read(table, "on", settings.on);
    if (!file) return settings;
    settings.file = file->text;
    const std::string path = existing_file(*file, folder);
    if (settings.on) settings.image = load(*file, path, warnings);
    return settings;
}

}  // namespace kreda::scene
