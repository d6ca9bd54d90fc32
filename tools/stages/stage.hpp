// The stages of a picture, each a picture and the numbers behind it: what `kreda stages` writes.
// Nothing is drawn by a second renderer: the stages of shading are the views that the passes wrote
// (scene/plan/views.hpp), those of geometry are the frame's own triangles and fragments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "raster/image.hpp"
#include "scene/render/frame.hpp"

namespace kreda::tools {

struct Stage {
    std::string name;                     ///< file name without number and ending: "light_2_specular"
    std::string title;                    ///< a few words
    std::string meaning;                  ///< a sentence
    std::string legend;                   ///< what the colours stand for, where they need it
    raster::Image picture;                ///< three channels, encoded for a PNG, as large as the scene's picture
    raster::Image values;                 ///< the numbers at every pixel, one channel each
    std::vector<std::string> components;  ///< what the channels of values are called
};

using StageVisitor = std::function<void(const Stage&)>;

/// Draw the scene and hand over one stage after another, in the order of the pipeline. threads: 0 for one a core.
void for_each_stage(const scene::Scene& scene, const StageVisitor& visit, int threads = 0);

// The two halves.
void visit_geometry_stages(const scene::Frame& frame, const StageVisitor& visit);
void visit_light_stages(const scene::Frame& frame, const StageVisitor& visit);

/// The scene with this light on and all others off; an index beyond the last light turns all off.
[[nodiscard]] scene::Scene with_only_light(const scene::Scene& scene, std::size_t light);

/// A rectangle of pixels of the picture.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

/// A few pixels drawn large, three times (coverage, triangles, final colour): sample centres, snapped vertices, edges
/// and which of them are top or left. A picture is at most width x height.
[[nodiscard]] std::vector<Stage> zoom_stages(const scene::Scene& scene, const PixelRectangle& part, int width,
                                             int height, int threads = 0);

/// A colour for a triangle's number; neighbours differ. Linear RGB.
[[nodiscard]] glm::vec3 color_of_number(std::uint32_t number);

}  // namespace kreda::tools
