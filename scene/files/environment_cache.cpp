#include "scene/files/environment_cache.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <span>

#include "lighting/environment/environment_image.hpp"
#include "scene/error.hpp"
#include "scene/files/hash_of_bytes.hpp"
#include "scene/files/map_file.hpp"
#include "scene/files/trim_maps.hpp"
#include "scene/files/whole_file.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;
using lighting::CubeMap;
using lighting::EnvironmentMaps;
using lighting::EnvironmentNeeds;

std::uint64_t hash_of(std::span<const float> floats, std::uint64_t seed = 0) {
    return hash_of_bytes(std::as_bytes(floats), seed);
}

/// A small image with something else in every texel.
raster::Image test_image() {
    raster::Image image = raster::make_image(16, 8, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<float>(i * 37 % 101) / 10.0f;
    return image;
}

std::array<float, 27> numbers_of(const lighting::Sh9& sh9) {
    std::array<float, 27> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = sh9.c[i / 3][static_cast<int>(i % 3)];
    return numbers;
}

/// What the formulas of all maps make of a small environment: takes some milliseconds.
std::uint64_t hash_of_formulas() {
    const CubeMap radiance = lighting::cube_from_equirect(test_image(), 8);
    lighting::PrefilterSettings prefilter;
    prefilter.samples = 64;
    lighting::IrradianceSettings irradiance;
    irradiance.size = 4;
    std::uint64_t hash = hash_of(lighting::prefilter(radiance, prefilter).texels);
    hash = hash_of(lighting::irradiance_map(radiance, irradiance).texels, hash);
    return hash_of(numbers_of(lighting::project_to_sh9(radiance)), hash);
}

std::string source_text(const EnvironmentSettings& settings) {
    if (!settings.image) return "sky " + hash_text(hash_of(lighting::cube_from_sky(settings.sky, 16).texels));
    const raster::Image& image = *settings.image;
    return "image " + std::to_string(image.width) + " x " + std::to_string(image.height) + " x " +
           std::to_string(image.channels) + " " + hash_text(hash_of(image.values));
}

std::string sizes_text(const std::vector<int>& sizes) {
    std::string text = "texels a side";
    for (const int size : sizes) text += " " + std::to_string(size);
    return text;
}

/// Finds and keeps the maps of one environment in one folder.
class Cache {
public:
    Cache(const EnvironmentSettings& settings, const EnvironmentNeeds& needs, std::string folder)
        : folder_(std::move(folder)), cube_size_(environment_size(settings)) {
        prefilter_ = prefilter_settings(needs, settings.samples);
        if (needs.any()) source_ = source_text(settings) + ", formulas " + hash_text(hash_of_formulas());
    }

    /// Fill in what is there; what is missing is the result.
    EnvironmentNeeds find(const EnvironmentNeeds& needs, EnvironmentMaps& maps) const {
        EnvironmentNeeds missing = needs;
        if (needs.mirror || needs.blurred) {
            maps.prefiltered = lighting::make_cube_map(prefilter_sizes(cube_size_, prefilter_));
            if (read(prefiltered_key(), maps.prefiltered.texels)) missing.mirror = missing.blurred = false;
        }
        if (needs.irradiance && find_irradiance(needs.form, maps)) missing.irradiance = false;
        missing.brdf.clear();
        for (const lighting::BrdfKind& kind : needs.brdf) {
            lighting::BrdfMap map{kind.distribution, kind.geometry, {}};
            map.texels.resize(std::size_t(4) * lighting::kBrdfMapSize * lighting::kBrdfMapSize);
            if (read(brdf_key(kind), map.texels))
                maps.brdf.push_back(std::move(map));
            else
                missing.brdf.push_back(kind);
        }
        return missing;
    }

    /// Throws UserError.
    void keep(const EnvironmentNeeds& baked, const EnvironmentMaps& maps) const {
        make_folder();
        if (baked.mirror || baked.blurred) write(prefiltered_key(), maps.prefiltered.texels);
        if (baked.irradiance && maps.sh9) write(irradiance_key(baked.form), numbers_of(*maps.sh9));
        if (baked.irradiance && !maps.sh9) write(irradiance_key(baked.form), maps.irradiance.texels);
        for (const lighting::BrdfKind& kind : baked.brdf) write(brdf_key(kind), find_brdf(maps, kind)->texels);
        trim_maps(folder_, kept_maps_limit());
    }

private:
    struct Key {
        std::string map;   ///< the first word of the file's name
        std::string text;  ///< everything the map depends on
    };

    [[nodiscard]] Key prefiltered_key() const {
        return {prefilter_.blurred ? "prefiltered" : "environment",
                source_ + ", " + sizes_text(prefilter_sizes(cube_size_, prefilter_)) + ", " +
                    std::to_string(prefilter_.blurred ? prefilter_.samples : 0) + " samples"};
    }

    [[nodiscard]] Key irradiance_key(lighting::IrradianceForm form) const {
        const std::string from = ", from a cube of " + std::to_string(cube_size_);
        if (form == lighting::IrradianceForm::sh9) return {"sh9", source_ + from};
        return {"irradiance", source_ + from + ", " + sizes_text({lighting::IrradianceSettings{}.size})};
    }

    [[nodiscard]] Key brdf_key(const lighting::BrdfKind& kind) const {
        const auto sample = lighting::compute_brdf_map(kind.distribution, kind.geometry, 4);
        return {"brdf", "formulas " + hash_text(hash_of(sample.texels)) + ", " + sizes_text({lighting::kBrdfMapSize}) +
                            ", " + std::to_string(lighting::kBrdfMapSamples) + " samples"};
    }

    bool find_irradiance(lighting::IrradianceForm form, EnvironmentMaps& maps) const {
        if (form == lighting::IrradianceForm::map) {
            maps.irradiance = lighting::make_cube_map({lighting::IrradianceSettings{}.size});
            return read(irradiance_key(form), maps.irradiance.texels);
        }
        std::array<float, 27> numbers;
        if (!read(irradiance_key(form), numbers)) return false;
        maps.sh9.emplace();
        for (std::size_t i = 0; i < numbers.size(); ++i) maps.sh9->c[i / 3][static_cast<int>(i % 3)] = numbers[i];
        return true;
    }

    [[nodiscard]] static std::string full_text(const Key& key) {
        return std::string("kreda map 1, ") + (std::endian::native == std::endian::little ? "little" : "big") +
               "-endian, " + key.map + ": " + key.text;
    }

    [[nodiscard]] std::string path(const Key& key) const {
        const std::string text = full_text(key);
        const std::string name = key.map + "-" + hash_text(hash_of_bytes(std::as_bytes(std::span(text)))) + ".map";
        return (fs::path(folder_) / name).string();
    }

    [[nodiscard]] bool read(const Key& key, std::span<float> floats) const {
        const bool is_there = read_map_file(path(key), full_text(key), floats);
        if (is_there) mark_as_used(path(key));
        return is_there;
    }

    void write(const Key& key, std::span<const float> floats) const {
        write_map_file(path(key), full_text(key), floats);
    }

    /// A new folder tells git and backup programs that nothing in it is worth keeping; one that is somebody's own does
    /// not: their work may lie there.
    void make_folder() const {
        std::error_code failed;
        const bool is_new = fs::create_directories(folder_, failed);
        if (failed) throw UserError(Place{folder_}, "this folder cannot be made: " + failed.message());
        if (!is_new) return;
        const auto write_text = [&](const char* name, const std::string& text) {
            write_whole_file((fs::path(folder_) / name).string(), {std::as_bytes(std::span(text))});
        };
        write_text(".gitignore", "*\n");
        write_text("CACHEDIR.TAG",
                   "Signature: 8a477f597d28d172789f06886806bc55\n# Maps that kreda baked. Delete them at will.\n");
    }

    std::string folder_;
    int cube_size_;
    lighting::PrefilterSettings prefilter_;
    std::string source_;
};

int count_of(const EnvironmentNeeds& needs) {
    return (needs.mirror || needs.blurred ? 1 : 0) + (needs.irradiance ? 1 : 0) + static_cast<int>(needs.brdf.size());
}

/// Baked maps take their places among those that were found.
void add_maps(const EnvironmentNeeds& baked, EnvironmentMaps&& from, EnvironmentMaps& to) {
    if (baked.mirror || baked.blurred) to.prefiltered = std::move(from.prefiltered);
    if (baked.irradiance) to.irradiance = std::move(from.irradiance);
    if (baked.irradiance) to.sh9 = from.sh9;
    for (lighting::BrdfMap& map : from.brdf) to.brdf.push_back(std::move(map));
}

}  // namespace

std::string cache_folder_of(const std::string& scene_file) {
    if (scene_file.empty()) return "";
    return (fs::path(scene_file).parent_path() / kCacheFolder).string();
}

PreparedEnvironment cached_environment(const EnvironmentSettings& settings, const EnvironmentNeeds& needs,
                                       const std::string& folder, const lighting::Progress& progress,
                                       CacheReport& report) {
    const Cache cache(settings, needs, folder);
    EnvironmentMaps found;
    const EnvironmentNeeds missing = cache.find(needs, found);
    report.baked = count_of(missing);
    report.found = count_of(needs) - report.baked;
    PreparedEnvironment prepared =
        prepare_environment(settings, missing, report.baked > 0 ? progress : lighting::Progress{});
    prepared.needs = needs;
    add_maps(missing, std::move(prepared.maps), found);
    prepared.maps = std::move(found);
    add_light_table(settings, prepared.maps);
    if (report.baked == 0) return prepared;
    try {
        cache.keep(missing, prepared.maps);
    } catch (const UserError& error) { report.why_not_kept = error.what(); }
    return prepared;
}

}  // namespace kreda::scene
