// Views of a scene side by side: each as `kreda render --view` writes it, with its name on it.
#pragma once

#include <string_view>
#include <vector>

#include "examples/panel.hpp"
#include "scene/render/render.hpp"

namespace kreda::examples {

/// The picture as a display shows it, in linear RGB again: the scene has its own exposure and tone map.
[[nodiscard]] Image shown(const scene::Scene& scene, const Image& radiance);

/// A view and what is written on it.
struct NamedView {
    std::string_view view;
    std::string_view caption;
    float gain = 1.0f;  ///< multiplies its values
};

/// Draw the scene once and take these views of it, which it must have.
/// With the buffers of another picture of the same scene its environment is not baked again.
[[nodiscard]] std::vector<Panel> view_panels(const scene::Scene& scene, const std::vector<NamedView>& views,
                                             scene::RenderBuffers buffers = {});

}  // namespace kreda::examples
