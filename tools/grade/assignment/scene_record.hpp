// A drawn scene, pixel by pixel: what the stages of an assignment are given.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/render/frame.hpp"
#include "tools/explain/probe.hpp"

namespace kreda::tools {

/// The surface that a pixel shows.
struct SeenPoint {
    glm::ivec2 pixel{0};
    Cover cover;  ///< the nearest triangle over the pixel's centre
    SourceTriangle source;
    glm::vec3 weights{0.0f};   ///< of its corners, perspective-correct
    glm::vec3 position{0.0f};  ///< world space
    glm::vec3 normal{0.0f};    ///< world space, interpolated: not of unit length
};

struct SceneRecord {
    std::string name;                        ///< the scene file's, without its ending
    const scene::Frame& frame;               ///< alive while the record is read
    std::vector<std::vector<Cover>> covers;  ///< every triangle over each pixel, row by row, in drawing order
    std::vector<SeenPoint> points;           ///< one for each pixel that shows a surface, row by row

    [[nodiscard]] const scene::Scene& scene() const {
        return frame.scene;
    }
};

/// Draw the scene (one sample a pixel) and look at it. Returns the film: linear radiance.
raster::Image record_scene(const scene::Scene& scene, const std::string& name,
                           const std::function<void(const SceneRecord&)>& look);

/// At most `most` of the points, evenly spread.
[[nodiscard]] std::vector<SeenPoint> some_points(const SceneRecord& record, std::size_t most);

}  // namespace kreda::tools
