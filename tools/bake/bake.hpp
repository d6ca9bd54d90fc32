// What `kreda bake` writes: the maps of an environment as files for people and other programs.
#pragma once

#include <string>
#include <vector>

#include "lighting/environment/environment.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/progress.hpp"
#include "raster/image.hpp"
#include "scene/environment.hpp"

namespace kreda::tools {

struct BakeRequest {
    std::string name;  ///< the image's file, or the sky, as the user wrote it
    scene::EnvironmentSettings environment;
    lighting::EnvironmentRepairs repairs;  ///< what was wrong with the image
    lighting::BrdfKind brdf;
};

/// All maps: turned and brightened as the request says; without that they are those that rendering reads, bit for bit.
[[nodiscard]] lighting::EnvironmentMaps bake_all(const BakeRequest& request, const lighting::Progress& progress = {});

/// A level as a picture: its six faces side by side, +x, -x, +y, -y, +z, -z, each as OpenGL stores it.
[[nodiscard]] raster::Image strip_of(const lighting::CubeMap& map, int level);

/// 64 x 64: red A, green B, blue E_avg; to the right sqrt(n.v) from 0 to 1, downwards roughness from 0 to 1.
[[nodiscard]] raster::Image picture_of(const lighting::BrdfMap& map);

/// A map as a file.
struct BakedFile {
    std::string file;         ///< "prefiltered_3.exr"
    std::string title;        ///< for people
    float roughness = -1.0f;  ///< of a prefiltered level; -1: none
    raster::Image picture;
};

/// environment.exr, prefiltered_1.exr ..., irradiance.exr, brdf_map.exr.
[[nodiscard]] std::vector<BakedFile> baked_files(const lighting::EnvironmentMaps& maps);

/// Nine coefficients a colour, where they come from, and what each file holds.
[[nodiscard]] std::string sh9_json(const BakeRequest& request, const lighting::EnvironmentMaps& maps,
                                   const std::vector<BakedFile>& files);

/// Every map as a panorama like the image it came from, in one picture. Encoded for a PNG.
[[nodiscard]] raster::Image bake_sheet(const BakeRequest& request, const lighting::EnvironmentMaps& maps);

}  // namespace kreda::tools
