#include "scene/plan/pass_inputs.hpp"

#include <cstdint>
#include <type_traits>

namespace kreda::scene {

namespace {

/// Numbers one after another; of structures each member by itself, because the gaps between them hold anything.
struct InputBytes {
    std::string bytes;

    template <class... Numbers>
    void add(const Numbers&... numbers) {
        (add_one(numbers), ...);
    }

private:
    template <class Number>
    void add_one(const Number& number) {
        static_assert(std::has_unique_object_representations_v<Number> || std::is_floating_point_v<Number> ||
                      std::is_same_v<Number, glm::vec2> || std::is_same_v<Number, glm::vec3> ||
                      std::is_same_v<Number, glm::mat3> || std::is_same_v<Number, glm::mat4>);
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
};

void add_settings(const shadows::ShadowSettings& s, InputBytes& inputs) {
    inputs.add(s.method, s.size, s.filter, s.radius, s.light_size, s.bias, s.constant_bias, s.slope_bias, s.cull);
}

void add_view(const shadows::LightView& view, InputBytes& inputs) {
    inputs.add(view.view_from_world, view.origin, view.perspective, view.half_size, view.near, view.far);
}

void add_caster(const Object& object, InputBytes& inputs) {
    const auto mesh = reinterpret_cast<std::uintptr_t>(object.mesh.get());  // which one it is, not what it holds
    inputs.add(mesh, object.world_from_object, object.part_hidden.size());
    for (const bool hidden : object.part_hidden) inputs.add(hidden);
}

}  // namespace

std::string shadow_inputs(const Scene& scene, const PlannedShadow& shadow) {
    InputBytes inputs;
    add_settings(shadow.map.settings, inputs);
    inputs.add(shadow.source.kind, shadow.source.direction, shadow.source.position, shadow.source.outer_cone_deg);
    inputs.add(shadow.map.views.size(), shadow.casters.size());
    for (const shadows::LightView& view : shadow.map.views) add_view(view, inputs);
    for (const int caster : shadow.casters) add_caster(scene.objects[static_cast<std::size_t>(caster)], inputs);
    return std::move(inputs.bytes);
}

}  // namespace kreda::scene
