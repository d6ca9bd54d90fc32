// The plan: which passes a scene requires, in order, and why. The renderer walks this list
// (scene/render/walk_passes.cpp): nothing else is computed, nothing else is allocated.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lighting/batch/setup.hpp"
#include "raster/fragments.hpp"
#include "raster/triangle_setup.hpp"
#include "raster/vertex_stage.hpp"
#include "scene/plan/choose_lighting.hpp"
#include "scene/plan/pass.hpp"
#include "scene/plan/seen.hpp"
#include "scene/plan/shadow_plan.hpp"
#include "scene/plan/views.hpp"
#include "scene/plan/wanted.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

struct RenderPlan {
    raster::Viewport viewport;  ///< the sample grid
    int samples = 1;            ///< n x n samples a pixel
    raster::CullMode cull = raster::CullMode::back;
    bool two_sided = false;  ///< backs can be seen, and their normals are turned to the viewer
    raster::AttributeInterpolation interpolation = raster::AttributeInterpolation::perspective;
    ShadingFrequency frequency = ShadingFrequency::phong;
    int shading_rate = 1;                 ///< one point is lit for so many samples by so many
    bool film = true;                     ///< the picture itself is drawn
    bool bytes = false;                   ///< in 8 bits, and nothing keeps its radiance
    std::optional<Seen> seen;             ///< what the camera sees; none: nothing was left out for it
    Wanted wanted;                        ///< how far the pipeline goes
    LightingChoices lighting;             ///< which materials each of the lighting passes works on
    bool draws_objects = false;           ///< some of them are seen
    bool shows_background = false;        ///< some samples show none
    bool environment_background = false;  ///< they show the environment
    glm::vec3 background{0.0f};           ///< else this colour, linear RGB
    bool finds_sides = false;             ///< normals of seen triangles contradict their winding
    raster::VertexNeeds vertex;           ///< attributes of the vertex streams
    raster::FragmentNeeds fragment;       ///< attributes that are interpolated for each visible sample
    std::vector<raster::FragmentNeeds> fragment_of_material;  ///< the same, and what the maps of a material read
    std::vector<lighting::MaterialSetup> materials;           ///< the scene's, made ready
    bool has_lights = false;                                  ///< one that is on
    std::vector<PlannedShadow> shadows;      ///< one for each light that casts shadows onto something seen
    bool shadows_by_frame = false;           ///< they are found for all visible samples at once, before anything is lit
    bool shows_blockers = false;             ///< a view asks what blocks the light, and how wide the penumbra is
    lighting::EnvironmentNeeds environment;  ///< what must be baked before the first frame
    bool lit_by_environment = false;
    bool fog_at_vertices = false;
    bool fog_at_pixels = false;
    std::vector<const View*> views;   ///< written beside the film
    std::vector<PlannedPass> passes;  ///< in the order in which they run
    std::vector<LeftOutPass> left_out;
    std::vector<std::string> notes;  ///< what is so on purpose and may surprise: a sentence each
};

/// The first step, once the meshes are there: what is seen, and the materials whose maps must be loaded for it.
struct LoadingPlan {
    Seen seen;
    MaterialMask maps;
};
[[nodiscard]] LoadingPlan plan_loading(const Scene& scene, const PlanRequest& request);

/// The second: what is asked for requires of the scene, all of whose maps that are read are there.
[[nodiscard]] RenderPlan make_plan_for(const Scene& scene, const PlanRequest& request);

/// What the picture requires. With views: the picture and everything that they may look at, so that nothing is left
/// out.
[[nodiscard]] RenderPlan make_plan(const Scene& scene, const std::vector<const View*>& views = {});

/// Does anything in the scene write this view?
[[nodiscard]] bool can_show(const RenderPlan& plan, const Scene& scene, const View& view);

/// The plan as text for people: a line a pass with its reason, the bytes of its buffers and its cost; then their sums
/// and the notes.
[[nodiscard]] std::string describe(const RenderPlan& plan, bool with_left_out);

}  // namespace kreda::scene
