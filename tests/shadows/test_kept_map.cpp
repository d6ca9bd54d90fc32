// A map that is drawn again keeps the tiles that stay empty: it must equal one that is drawn for the first time.
#include <algorithm>

#include <doctest/doctest.h>

#include <glm/ext/matrix_transform.hpp>

#include "raster/shapes.hpp"
#include "shadows/shadow_map.hpp"

using namespace kreda;
using namespace kreda::shadows;

namespace {

/// A sphere of diameter 0.5, so that it touches few of a map's tiles.
struct Caster {
    raster::Mesh mesh = raster::make_shape("sphere", 12).value();
    std::vector<raster::MeshInstance> instances{1};
    ShadowMapBuffers buffers;

    Caster() {
        instances[0].mesh = &mesh;
        instances[0].part_material = {0};
        place({0.0f, 0.0f, 0.0f});
    }
    void place(const glm::vec3& at) {
        instances[0].world_from_object = glm::scale(glm::translate(glm::mat4(1.0f), at), glm::vec3(0.25f));
    }
};

ShadowSettings map_of(int size, int radius) {
    ShadowSettings settings;
    settings.size = size;
    settings.filter = radius > 0 ? ShadowFilter::pcf : ShadowFilter::none;
    settings.radius = radius;
    return settings;
}

/// A light straight down whose picture shows x and z in -2 .. 2.
ShadowMapPlan plan_of(const ShadowSettings& settings) {
    LightBounds seen;
    seen.least = {-2.0f, -2.0f, -4.0f};
    seen.greatest = {2.0f, 2.0f, 4.0f};
    seen.empty = false;
    return {settings, {directional_view({0.0f, -1.0f, 0.0f}, seen, seen, settings.size, 0)}};
}

/// Draw into `map`, which may hold an older frame, and beside it for the first time: are all texels the same?
bool equals_first(Caster& caster, const ShadowMapPlan& plan, ShadowMap& map) {
    draw_shadow_map(caster.instances, plan, caster.buffers, map);
    ShadowMap first;
    draw_shadow_map(caster.instances, plan, caster.buffers, first);
    return map.distance == first.distance && map.is_empty == first.is_empty;
}

int empty_tiles(const ShadowMap& map) {
    return static_cast<int>(std::count(map.is_empty.begin(), map.is_empty.end(), 1));
}

}  // namespace

TEST_CASE(
    "Shadow map drawn again: a caster that moves leaves nothing behind, and nothing is missing where it comes to") {
    Caster caster;
    ShadowMap map;
    const ShadowMapPlan plan = plan_of(map_of(256, 1));
    for (const glm::vec3& at : {glm::vec3(0.0f), glm::vec3(1.5f, 0.0f, -1.5f), glm::vec3(9.0f, 0.0f, 0.0f),
                                glm::vec3(-1.5f, 0.0f, 1.5f), glm::vec3(-1.5f, 0.0f, 1.5f)}) {
        caster.place(at);
        CHECK(equals_first(caster, plan, map));
    }
    CHECK(empty_tiles(map) == 15);  // texels 16 to 48 of 256 in both directions: one tile of 4 x 4
}

TEST_CASE("Shadow map drawn again: where its texels lie elsewhere, none is taken for one that is empty already") {
    Caster caster;
    ShadowMap map;
    // Rings of 3 and 1 texels make rows of 262 of both: the memory is as large, and the tiles lie elsewhere. What was
    // in the third tile of the third row lies in tile 12 of the next frame, a number that was empty.
    const ShadowMapPlan wide_ring = plan_of(map_of(256, 2)), narrow_ring = plan_of(map_of(260, 0));
    caster.place({0.5f, 0.0f, 0.5f});
    CHECK(equals_first(caster, wide_ring, map));
    CHECK(map.stride() == 262);
    caster.place({1.5f, 0.0f, 1.5f});
    CHECK(equals_first(caster, narrow_ring, map));
    CHECK(map.stride() == 262);
    CHECK(equals_first(caster, wide_ring, map));
    CHECK(equals_first(caster, plan_of(map_of(128, 2)), map));
    map.distance.clear();
    CHECK(equals_first(caster, plan_of(map_of(128, 2)), map));
}

TEST_CASE("Shadow map drawn again: each face of a cube keeps its own empty tiles") {
    Caster caster;
    ShadowMap map;
    const auto views = cube_views({0.0f, 0.0f, 0.0f}, 0.1f, 10.0f, 128, 2);
    const ShadowMapPlan plan{map_of(128, 1), {views.begin(), views.end()}};
    for (const glm::vec3& at :
         {glm::vec3(2.0f, 0.2f, 0.2f), glm::vec3(-2.0f, 0.0f, 0.0f), glm::vec3(0.0f, 2.0f, 1.9f)}) {
        caster.place(at);
        CHECK(equals_first(caster, plan, map));
    }
}
