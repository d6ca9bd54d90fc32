// What an explanation says of a shadow is what the picture was drawn by: faces, a triangle, texels of a filter.
#include <memory>
#include <random>

#include <doctest/doctest.h>

#include "drawn_map.hpp"
#include "hard_cases.hpp"
#include "shadows/exact.hpp"
#include "shadows/filter_taps.hpp"
#include "shadows/light_ray.hpp"
#include "shadows/planar.hpp"
#include "shadows/volume.hpp"

using namespace kreda;
using namespace kreda::shadows;
using namespace kreda::tests;

namespace {

ShadowScene drawn_room(const ShadowLight& light) {
    ShadowScene scene;
    add_room(scene);
    scene.light = light;
    scene.draw();
    return scene;
}

/// Does this one triangle of the occluder lie between the light and p?
bool stands_between(const ShadowScene& scene, const PlanarCause& cause, const glm::vec3& p) {
    const Occluder& all = scene.occluders[cause.occluder];
    const std::vector<Occluder> one{{all.positions, all.indices.subspan(3 * cause.triangle, 3), all.clockwise}};
    const glm::dvec4 light = homogeneous(scene.light);
    return shadows_point(light_ray(light, p), gather_triangles(one).front(), light, p);
}

/// A table of half side 8 in y = 0, and half a unit above it a tile that covers x and z in -0.4 .. 0.4.
raster::Mesh tile_over_table() {
    raster::Mesh mesh;
    for (const auto& [half, y] : {std::pair{8.0f, 0.0f}, std::pair{0.4f, 0.5f}}) {
        mesh.positions.insert(mesh.positions.end(),
                              {{-half, y, -half}, {-half, y, half}, {half, y, half}, {half, y, -half}});
    }
    mesh.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    mesh.parts = {{"tile over table", 0, 4, -1}};
    return mesh;
}

LightView straight_down() {
    LightBounds seen;
    seen.least = {-1.0f, 0.0f, -1.0f};
    seen.greatest = {1.0f, 0.5f, 1.0f};
    seen.empty = false;
    return directional_view({0.0f, -1.0f, 0.0f}, seen, seen, 64, 0);
}

/// visit(points, factor): places on the table as the filters see them, and the factor that the picture has there.
template <class Visit>
void at_places(const ShadowMap& map, Visit visit) {
    const auto position = std::make_unique<raster::Channel3>(), normal = std::make_unique<raster::Channel3>();
    const auto shadow = std::make_unique<raster::Channel>();
    const auto points = std::make_unique<MapPoints>();
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-0.7f, 0.7f);
    for (int k = 0; k < 300; ++k) {
        const glm::vec3 p(place(random), 0.0f, place(random));
        for (int i = 0; i < raster::lanes_for(1); ++i) {
            position->set(i, p);
            normal->set(i, {0.0f, 1.0f, 0.0f});
        }
        shadow_factors(map, *position, *normal, 1, *shadow);
        locate(map, *position, *normal, raster::lanes_for(1), *points);
        visit(*points, shadow->at(0));
    }
}

}  // namespace

TEST_CASE("causes: of the faces over a sample the exits behind it less the entries are its counter") {
    for (const ShadowLight& light : {point_light({2, 3, 2}), directional_light({-1, -1.3f, -0.6f})}) {
        const ShadowScene scene = drawn_room(light);
        const VisibleSamples samples = scene.frame.samples();
        const VolumeFaces faces = make_volume_faces(casters_of(scene), scene.light, samples);
        const std::vector<std::int32_t> counters = count_volumes(faces, samples);
        int in_shadow = 0;
        for (std::size_t i = 0; i < counters.size(); i += 7) {
            if (!scene.is_seen(i)) continue;
            int counter = 0;
            const int x = static_cast<int>(i) % scene.viewport.width, y = static_cast<int>(i) / scene.viewport.width;
            for (const FaceCrossing& face : faces_over(faces, samples, x, y)) {
                if (face.is_behind) counter += face.is_entry ? -face.weight : face.weight;
            }
            CHECK(counter == counters[i]);
            in_shadow += counter > 0;
        }
        CHECK(in_shadow > 50);
    }
}

TEST_CASE("causes: a planar shadow has a triangle where it is dark and the triangle stands in the light's way") {
    for (const ShadowLight& light : {point_light({2, 3, 2}), directional_light({-1, -1.3f, -0.6f})}) {
        const ShadowScene scene = drawn_room(light);
        const glm::dvec4 plane = plane_of(scene.occluders[0]).value();
        const VisibleSamples samples = scene.frame.samples();
        std::vector<float> shadow(scene.sample_count());
        planar_shadow(scene.occluders, plane, scene.light, samples, shadow);
        const std::uint32_t floor_triangles = scene.instances[0].mesh->triangle_count();
        int dark = 0, beside = 0;
        for (std::size_t i = 0; i < shadow.size(); i += 3) {
            if (!scene.is_seen(i) || scene.set.triangle(scene.frame.triangle[i]).source >= floor_triangles) continue;
            const int x = static_cast<int>(i) % scene.viewport.width, y = static_cast<int>(i) / scene.viewport.width;
            const auto cause = planar_cause(scene.occluders, plane, scene.light, samples, x, y);
            CHECK(cause.has_value() == (shadow[i] == 0.0f));
            if (!cause) continue;
            ++dark;
            beside += !stands_between(scene, *cause, scene.frame.position[i]);
        }
        CHECK(dark > 100);
        CHECK(beside <= dark / 20);  // next to the triangle's edges, where a snap of 1/256 sample decides
    }
}

TEST_CASE("causes: the texels that pcf compares have the picture's factor for their mean") {
    const raster::Mesh mesh = tile_over_table();
    for (const int radius : {0, 1, 3}) {
        ShadowSettings settings;
        settings.size = 64;
        settings.filter = radius == 0 ? ShadowFilter::none : ShadowFilter::pcf;
        settings.radius = radius;
        const ShadowMap map = draw_map(mesh, straight_down(), settings);
        int half_lit = 0;
        at_places(map, [&](const MapPoints& points, float factor) {
            const std::vector<FilterTap> taps = box_taps(map, points, radius);
            CHECK(taps.size() == static_cast<std::size_t>((2 * radius + 1) * (2 * radius + 1)));
            double lit = 0.0;
            for (const FilterTap& tap : taps) {
                CHECK(tap.lit == (tap.stored < tap.compared ? 0.0f : 1.0f));
                lit += tap.lit;
            }
            CHECK(factor == doctest::Approx(lit / static_cast<double>(taps.size())).epsilon(1e-6));
            half_lit += factor > 0.0f && factor < 1.0f;
        });
        CHECK((half_lit > 10) == (radius > 0));
    }
}

TEST_CASE("causes: the cells that pcss read find the blocker and have the picture's factor for their mean") {
    const raster::Mesh mesh = tile_over_table();
    ShadowSettings settings;
    settings.size = 64;
    settings.filter = ShadowFilter::pcss;
    settings.light_size = 0.5f;
    const LightView view = straight_down();
    const ShadowMap map = draw_map(mesh, view, settings);
    int blocked = 0, half_lit = 0;
    at_places(map, [&](const MapPoints& points, float factor) {
        const SoftTaps soft = soft_taps(map, points);
        double blocks = 0.0, lit = 0.0, area = 0.0;
        for (const FilterTap& cell : soft.search) blocks += cell.lit;
        for (const FilterTap& cell : soft.filter) {
            lit += cell.lit;
            area += cell.weight;
        }
        CHECK(soft.blocked == (blocks > 0.0));
        if (!soft.blocked) {
            CHECK(factor == 1.0f);
            return;
        }
        ++blocked;
        CHECK(soft.blocker == doctest::Approx(points.distance.at(0) - 0.5).epsilon(0.01));  // the tile alone blocks
        CHECK(factor == doctest::Approx(lit / area).epsilon(1e-5));
        half_lit += factor > 0.0f && factor < 1.0f;
    });
    CHECK(blocked > 80);  // the tile is a third of the places
    CHECK(half_lit > 20);
}
