#include "scene/files/read_environment.hpp"

#include "scene/files/file_key.hpp"
#include "scene/files/image_color.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/key_tables.hpp"
#include "scene/files/loaded_files.hpp"

namespace kreda::scene {

namespace {

constexpr int kLeastWidth = 4;

std::string size_text(const raster::Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

std::string repairs_text(const lighting::EnvironmentRepairs& repairs) {
    std::string list;
    const auto say = [&](std::size_t count, const char* what) {
        if (count > 0) list += (list.empty() ? "" : ", ") + std::to_string(count) + what;
    };
    say(static_cast<std::size_t>(repairs.negative), " negative (set to 0)");
    say(static_cast<std::size_t>(repairs.nan), " not a number (mean of their neighbours)");
    say(static_cast<std::size_t>(repairs.infinite), " infinite (set to the largest finite one)");
    say(static_cast<std::size_t>(repairs.too_bright), " too bright (set to 1e9)");
    return "holds texels that are no light: " + list;
}

/// What was done to an image, and what was made of its channels and numbers.
std::vector<std::string> remarks_of(const StoredImage& stored) {
    std::vector<std::string> remarks = stored.remarks;
    const ColorChannels channels = color_channels(stored.channels, stored.alpha);
    if (!channels.found.empty()) remarks.push_back(channels.found + "; " + channels.made);
    const std::string encoding = encoding_remark(stored);
    if (!encoding.empty()) remarks.push_back(encoding);
    return remarks;
}

/// The image that a key names. What was wrong with it is a warning.
std::shared_ptr<const raster::Image> load(const Value& key, const std::string& path, LoadedFiles* files,
                                          std::vector<std::string>& warnings) {
    const auto read = [&](std::vector<UsedFile>& from) {
        from.push_back(use_file(path));
        return read_environment_image(path, key.place, in_quotes(key.key) + ": " + path_in_quotes(path) + " ");
    };
    const std::shared_ptr<const EnvironmentImage> loaded =
        find_or_make(files, &LoadedFiles::environments, canonical_path(path), read);
    for (const std::string& remark : loaded->remarks) {
        warnings.push_back(UserError(key.place, path_in_quotes(path) + " " + remark).what());
    }
    return loaded->image;
}

}  // namespace

EnvironmentImage read_environment_image(const std::string& path, const Place& place, const std::string& subject) {
    StoredImage stored = read_stored_image(path);
    EnvironmentImage loaded;
    loaded.remarks = remarks_of(stored);
    const ColorChannels channels = color_channels(stored.channels, stored.alpha);
    auto image = std::make_shared<raster::Image>(linear_colors(std::move(stored), channels));
    if (image->width < kLeastWidth || image->height < kLeastWidth / 2) {
        throw UserError(place, subject + "is " + size_text(*image) +
                                   " pixels; an equirectangular image is twice as wide as high, e.g. 1024 x 512");
    }
    loaded.repairs = lighting::repair_environment(*image);
    if (image->width != 2 * image->height) {
        loaded.remarks.push_back("is " + size_text(*image) + ", not twice as wide as high; it is stretched");
    }
    if (loaded.repairs.total() > 0) loaded.remarks.push_back(repairs_text(loaded.repairs));
    loaded.image = std::move(image);
    return loaded;
}

EnvironmentSettings read_environment(const Value& table, const std::string& folder, LoadedFiles* files,
                                     std::vector<std::string>& warnings) {
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
    read_keys(table, environment_keys(), settings);
    if (!file) return settings;
    if (files) files->used.push_back(use_file(path_in(folder, file->text), FileUse::presence));
    const std::string path = existing_file(*file, folder);
    if (settings.on) settings.image = load(*file, path, files, warnings);
    return settings;
}

}  // namespace kreda::scene
