// Whole pictures of sets of options, each drawn once, and environments, each baked once: pictures by oracles take long.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "scene/render/render.hpp"
#include "tools/measure/picture.hpp"
#include "tools/tune/terms.hpp"

namespace kreda::tools {

struct DrawnSets {
    /// Maps and how long they took.
    struct Baked {
        std::shared_ptr<const scene::PreparedEnvironment> maps;
        double ms = 0.0;
    };
    std::map<std::vector<int>, Picture> pictures;  ///< by the options chosen, one a term
    std::vector<Baked> baked;
    scene::RenderBuffers buffers;
};

/// The scene's picture; its bake_ms are those of the maps, also where they were baked before.
[[nodiscard]] Picture draw_with_baked(DrawnSets& drawn, scene::Scene scene, int threads);

/// The picture of a set, as it was when it was drawn first. Throws UserError where the options do not go together.
[[nodiscard]] const Picture& picture_of_set(DrawnSets& drawn, const SceneSource& source, const std::vector<Term>& terms,
                                            const std::vector<int>& chosen, int threads);

}  // namespace kreda::tools
