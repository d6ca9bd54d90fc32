#include "tools/tune/drawn_sets.hpp"

#include <algorithm>

#include "scene/plan/plan.hpp"

namespace kreda::tools {

Picture draw_with_baked(DrawnSets& drawn, scene::Scene scene, int threads) {
    const lighting::EnvironmentNeeds needs = make_plan(scene).environment;
    if (!needs.any()) return draw_picture(scene, drawn.buffers, threads);
    const auto found = std::find_if(drawn.baked.begin(), drawn.baked.end(), [&](const DrawnSets::Baked& baked) {
        return serves(*baked.maps, scene.environment, needs);
    });
    if (found == drawn.baked.end()) {
        Picture picture = draw_picture(scene, drawn.buffers, threads);
        drawn.baked.push_back({drawn.buffers.environment, picture.bake_ms});
        return picture;
    }
    scene.environment.prepared = found->maps;
    Picture picture = draw_picture(scene, drawn.buffers, threads);
    picture.bake_ms = found->ms;
    return picture;
}

const Picture& picture_of_set(DrawnSets& drawn, const SceneSource& source, const std::vector<Term>& terms,
                              const std::vector<int>& chosen, int threads) {
    const auto found = drawn.pictures.find(chosen);
    if (found != drawn.pictures.end()) return found->second;
    Picture picture = draw_with_baked(drawn, read_with(source, settings_of(terms, chosen)), threads);
    return drawn.pictures.emplace(chosen, std::move(picture)).first->second;
}

}  // namespace kreda::tools
