#include "tools/bake/bake.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include <nlohmann/json.hpp>

#include "lighting/environment/bake_cost.hpp"
#include "raster/film.hpp"
#include "scene/files/scene_keys.hpp"
#include "tools/draw/draw.hpp"
#include "tools/stages/stage_page.hpp"

namespace kreda::tools {

namespace {

using lighting::CubeMap;
using raster::Image;

/// What the files are made of.
lighting::EnvironmentNeeds all_maps(const lighting::BrdfKind& brdf) {
    lighting::EnvironmentNeeds needs;
    needs.mirror = needs.blurred = needs.irradiance = true;
    needs.brdf = {brdf};
    return needs;
}

float roughness_of_level(int level) {
    return std::sqrt(lighting::alpha_of_level(level));
}

std::string roughness_text(int level) {
    char text[24];
    std::snprintf(text, sizeof text, "%.3f", double{roughness_of_level(level)});
    return text;
}

std::string word_of(const char* key, int index) {
    return std::string(scene::find_key("material", key)->words[static_cast<std::size_t>(index)]);
}

nlohmann::ordered_json settings_json(const BakeRequest& request) {
    const scene::EnvironmentSettings& environment = request.environment;
    return {{"rotation", environment.rotation_deg},
            {"intensity", environment.intensity},
            {"samples", environment.samples},
            {"distribution", word_of("distribution", static_cast<int>(request.brdf.distribution))},
            {"geometry", word_of("geometry", static_cast<int>(request.brdf.geometry))}};
}

nlohmann::ordered_json file_json(const BakedFile& file) {
    nlohmann::ordered_json entry{
        {"file", file.file}, {"holds", file.title}, {"width", file.picture.width}, {"height", file.picture.height}};
    if (file.roughness >= 0.0f) entry["roughness"] = file.roughness;
    return entry;
}

/// A small panorama, columns and rows as in lighting/environment/environment_image.hpp, of what `look(direction)`
/// gives.
template <class Look>
Image panorama(Look look) {
    constexpr int kWidth = 320, kHeight = 160;
    Image picture = raster::make_image(kWidth, kHeight, 3);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const glm::vec2 point{(static_cast<float>(x) + 0.5f) / kWidth, (static_cast<float>(y) + 0.5f) / kHeight};
            picture.set_rgb(x, y, look(lighting::equirect_direction(point)));
        }
    }
    return picture;
}

/// The mean radiance becomes a middle grey, whatever the environment.
raster::FilmSettings film_for(const lighting::Sh9& sh9) {
    const glm::vec3 mean = sh9.c[0] * (1.0f / raster::kPi);
    const float luminance = 0.2126f * mean.x + 0.7152f * mean.y + 0.0722f * mean.z;
    raster::FilmSettings film;
    film.exposure = luminance > 0.0f ? 0.4f / luminance : 1.0f;
    film.tone_map = raster::ToneMap::reinhard;
    return film;
}

}  // namespace

lighting::EnvironmentMaps bake_all(const BakeRequest& request, const lighting::Progress& progress) {
    const scene::EnvironmentSettings& environment = request.environment;
    const lighting::EnvironmentNeeds needs = all_maps(request.brdf);
    const int size = environment_size(environment);
    const std::vector<double> maps_work = lighting::bake_work(size, needs, environment.samples);
    const std::vector<lighting::Progress> steps = lighting::progress_of_steps(
        progress, {environment_cost(environment).operations(), std::accumulate(maps_work.begin(), maps_work.end(), 0.0),
                   lighting::irradiance_cost(size, lighting::IrradianceForm::sh9).operations()});
    const CubeMap radiance = environment_cube(environment, placement_of(environment), steps[0]);
    lighting::EnvironmentMaps maps = bake_environment(radiance, needs, environment.samples, steps[1]);
    maps.sh9 = lighting::project_to_sh9(radiance);
    if (progress) progress(1.0);
    return maps;
}

Image strip_of(const CubeMap& map, int level) {
    const int size = map.levels[static_cast<std::size_t>(level)].size;
    Image strip = raster::make_image(lighting::kCubeFaces * size, size, 3);
    for (int face = 0; face < lighting::kCubeFaces; ++face) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) strip.set_rgb(face * size + x, y, map.texel(level, face, x, y));
        }
    }
    return strip;
}

Image picture_of(const lighting::BrdfMap& map) {
    constexpr int kSize = lighting::kBrdfMapSize;
    Image picture = raster::make_image(kSize, kSize, 3);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const float* texel = &map.texels[static_cast<std::size_t>(4 * (y * kSize + x))];
            picture.set_rgb(x, y, {texel[0], texel[1], texel[2]});
        }
    }
    return picture;
}

std::vector<BakedFile> baked_files(const lighting::EnvironmentMaps& maps) {
    std::vector<BakedFile> files;
    files.push_back({"environment.exr", "radiance, the mirror's level", 0.0f, strip_of(maps.prefiltered, 0)});
    for (int level = 1; level <= maps.prefiltered.last_level(); ++level) {
        files.push_back({"prefiltered_" + std::to_string(level) + ".exr",
                         "radiance as a surface of roughness " + roughness_text(level) + " mirrors it",
                         roughness_of_level(level), strip_of(maps.prefiltered, level)});
    }
    files.push_back(
        {"irradiance.exr", "irradiance on a plane that faces each direction", -1.0f, strip_of(maps.irradiance, 0)});
    files.push_back({"brdf_map.exr", "R: scale A, G: bias B of F0, B: mean of A + B; x = sqrt(n.v), y = roughness",
                     -1.0f, picture_of(maps.brdf[0])});
    return files;
}

std::string sh9_json(const BakeRequest& request, const lighting::EnvironmentMaps& maps,
                     const std::vector<BakedFile>& files) {
    nlohmann::ordered_json root;
    root["environment"] = request.name;
    const raster::Image* image = request.environment.image.get();
    if (image) root["image"] = {{"width", image->width}, {"height", image->height}};
    root["repaired_texels"] = {{"negative", request.repairs.negative},
                               {"not_a_number", request.repairs.nan},
                               {"infinite", request.repairs.infinite},
                               {"too_bright", request.repairs.too_bright}};
    root["settings"] = settings_json(request);
    root["faces"] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    root["face_size"] = maps.prefiltered.levels[0].size;
    root["irradiance"] = "E(n) = sum of coefficients[k] basis[k], n = (x, y, z) a unit vector";
    root["basis"] = {"1", "y", "z", "x", "x y", "y z", "3 z^2 - 1", "x z", "x^2 - y^2"};
    for (const glm::vec3& c : maps.sh9->c) root["coefficients"].push_back({c.x, c.y, c.z});
    for (const BakedFile& file : files) root["files"].push_back(file_json(file));
    return root.dump(2) + "\n";
}

Image bake_sheet(const BakeRequest& request, const lighting::EnvironmentMaps& maps) {
    const raster::FilmSettings film = film_for(*maps.sh9);
    std::vector<Image> pictures;
    std::vector<std::string> titles;
    const auto add = [&](const std::string& title, const Image& picture) {
        titles.push_back(title);
        pictures.push_back(picture);
    };
    for (int level = 0; level <= maps.prefiltered.last_level(); ++level) {
        const Image seen = panorama([&](const glm::vec3& d) { return sample_level(maps.prefiltered, level, d); });
        add(level == 0 ? "environment" : "roughness " + roughness_text(level), develop(seen, film));
    }
    const auto white = [](const glm::vec3& E) { return E * raster::kInvPi; };
    add("irradiance / pi",
        develop(panorama([&](const glm::vec3& d) { return white(sample_level(maps.irradiance, 0, d)); }), film));
    add("nine coefficients / pi",
        develop(panorama([&](const glm::vec3& d) { return white(irradiance_of_sh9(*maps.sh9, d)); }), film));
    Image brdf = picture_of(maps.brdf[0]);
    std::fill_n(brdf.plane(2), brdf.plane_size(), 0.0f);
    add("BRDF map: A red, B green", enlarge(develop(brdf, {}), 2));
    return contact_sheet(request.name + ": its maps", pictures, titles);
}

}  // namespace kreda::tools
