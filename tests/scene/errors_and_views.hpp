// What tests of scenes ask again and again: what an error says, and the numbers of a view.
#pragma once

#include <string>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "scene/render/render.hpp"

namespace kreda::tests {

[[nodiscard]] inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The words of the UserError that the action throws.
[[nodiscard]] std::string message_of(const auto& action) {
    try {
        action();
    } catch (const scene::UserError& error) { return error.what(); }
    return "no error";
}

/// The numbers of a view of this scene.
[[nodiscard]] inline raster::Image view_of(const scene::Scene& scene, const char* name) {
    scene::RenderBuffers buffers;
    const scene::View* view = scene::find_view(name);
    REQUIRE(view);
    render(scene, make_plan(scene, {view}), buffers);
    return buffers.views[0];
}

}  // namespace kreda::tests
