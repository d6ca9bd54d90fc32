// Light from the environment in a whole scene: constant light, the white furnace, rotation, and only what is needed.
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/environment/environment_image.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/plan/plan_cost.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/errors_and_views.hpp"

using namespace kreda;
using namespace kreda::scene;
using kreda::tests::view_of;

namespace {

/// A ball without lamps, lit by an environment of radiance L(direction).
template <class Radiance>
Scene ball(const std::string& material, Radiance L, const std::string& environment = "") {
    Scene scene = read_scene_text(
        "[image]\nsize = [48, 48]\n[camera]\nposition = [0, 0, 4]\nprojection = \"orthographic\"\n"
        "height = 2\n[ambient]\ncolor = [0, 0, 0]\n[environment]\nsky = \"gradient\"\n" +
            environment + "[[object]]\nmesh = \"sphere\"\ndetail = 96\nmaterial = \"m\"\n[[material]]\nname = \"m\"\n" +
            material,
        "test", "");
    raster::Image image = raster::make_image(64, 32, 3);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 64; ++x) {
            image.set_rgb(x, y,
                          L(lighting::equirect_direction({(float(x) + 0.5f) / 64.0f, (float(y) + 0.5f) / 32.0f})));
        }
    }
    scene.environment.image = std::make_shared<raster::Image>(image);
    return scene;
}

glm::vec3 even(const glm::vec3&) {
    return {0.5f, 1.0f, 2.0f};
}

const std::string kWhiteMetal =
    "model = \"cook_torrance\"\nalbedo = [1, 1, 1]\nmetallic = 1\ngeometry = \"smith_correlated\"\n";

}  // namespace

TEST_CASE("environment: even light makes a white Lambert ball as bright as itself") {
    for (const char* form : {"map", "sh9"}) {
        CAPTURE(form);
        const Scene scene =
            ball("model = \"lambert\"\ndiffuse = [1, 1, 1]\n", even, "irradiance = \"" + std::string(form) + "\"\n");
        const glm::vec3 seen = render(scene).rgb(30, 20);
        // The sum over the texels rounds in float, and their solid angles are those of a cube: 1e-3 for its cosine sum.
        for (int c = 0; c < 3; ++c) CHECK(seen[c] == doctest::Approx(even({})[c]).epsilon(1e-3));
    }
}

TEST_CASE("environment: a white metal in even light loses only what single scattering loses") {
    // Directional albedo of GGX with Smith's correlated G at n.v = 1: E(1) of roughness 0.3 and 1 (quadrature; the last
    // is 1 - ln 2).
    const struct {
        const char* roughness;
        double E;
    } rows[] = {{"0.3", 0.99070}, {"1", 0.30685282}};
    for (const auto& row : rows) {
        CAPTURE(row.roughness);
        const std::string material = kWhiteMetal + "roughness = " + row.roughness + "\n";
        const Scene scene = ball(material, even);
        CHECK(render(scene).at(1, 24, 24) == doctest::Approx(row.E).epsilon(4e-3));  // the map's own error
        const Scene compensated = ball(material + "energy_compensation = \"kulla_conty\"\n", even);
        CHECK(render(compensated).at(1, 24, 24) == doctest::Approx(1.0).epsilon(4e-3));
    }
}

TEST_CASE("environment: in even light the split sum is the integral") {
    for (const std::string& material :
         {kWhiteMetal + "roughness = 0.5\n",
          std::string("model = \"cook_torrance\"\nalbedo = [0.8, 0.4, 0.2]\nroughness = 0.4\n")}) {
        CAPTURE(material);
        const raster::Image split = view_of(ball(material, even), "environment_specular");
        const raster::Image exact = view_of(ball(material, even, "reference = 4096\n"), "environment_specular");
        for (const int x : {24, 32, 38}) {
            CAPTURE(x);
            for (int c = 0; c < 3; ++c) {
                CHECK(split.at(c, x, 24) == doctest::Approx(exact.at(c, x, 24)).epsilon(1e-2));
            }
        }
    }
}

TEST_CASE("environment: a turn by 90 degrees turns the light") {
    const auto from_right = [](const glm::vec3& d) { return glm::vec3(d.x > 0.0f ? d.x : 0.0f); };
    const auto from_front = [](const glm::vec3& d) { return glm::vec3(d.z > 0.0f ? d.z : 0.0f); };
    const std::string material = "model = \"cook_torrance\"\nroughness = 0.4\n";
    // Counter-clockwise seen from above, +x goes to -z; by -90 degrees it goes to +z.
    const raster::Image turned = render(ball(material, from_right, "rotation = -90\n"));
    const raster::Image front = render(ball(material, from_front));
    const raster::Image right = render(ball(material, from_right));
    CHECK(turned.at(0, 24, 24) == doctest::Approx(front.at(0, 24, 24)).epsilon(0.02));  // 64 texels around the image
    CHECK(turned.at(0, 38, 24) == doctest::Approx(front.at(0, 38, 24)).epsilon(0.02));
    CHECK(right.at(0, 24, 24) < 0.5f * front.at(0, 24, 24));
}

TEST_CASE("environment: intensity multiplies it") {
    const std::string material = "model = \"lambert\"\n";
    const float once = render(ball(material, even)).at(1, 24, 24);
    CHECK(render(ball(material, even, "intensity = 3\n")).at(1, 24, 24) == doctest::Approx(3.0 * once).epsilon(1e-6));
}

TEST_CASE("environment: the background shows the direction behind each sample") {
    Scene scene = ball("", [](const glm::vec3& d) { return 0.5f * d + glm::vec3(0.5f); });
    scene.image.environment_background = true;
    scene.camera.projection = raster::Projection::perspective;
    scene.camera.vertical_fov_deg = 90.0f;
    scene.objects.clear();
    const raster::Image seen = render(scene);
    for (const int x : {4, 24, 44}) {
        for (const int y : {4, 24, 44}) {
            CAPTURE(x);
            CAPTURE(y);
            const glm::vec3 d =
                glm::normalize(glm::vec3((float(x) + 0.5f) / 24.0f - 1.0f, 1.0f - (float(y) + 0.5f) / 24.0f, -1.0f));
            const glm::vec3 expected = 0.5f * d + glm::vec3(0.5f);
            CHECK(glm::distance(seen.rgb(x, y), expected) < 0.02f);  // half a texel of 64 around, seen through a cube's
        }
    }
}

TEST_CASE("environment: only what the scene requires is baked") {
    const auto needs = [](const Scene& scene) { return make_plan(scene).environment; };
    CHECK_FALSE(needs(ball("model = \"unlit\"\n", even)).any());
    const lighting::EnvironmentNeeds lambert = needs(ball("model = \"lambert\"\n", even));
    CHECK(lambert.irradiance);
    CHECK_FALSE(lambert.blurred);
    CHECK_FALSE(lambert.mirror);
    CHECK(lambert.brdf.empty());
    const lighting::EnvironmentNeeds metal = needs(ball("model = \"cook_torrance\"\n", even));
    CHECK(metal.blurred);
    CHECK(metal.brdf.size() == 1);
    const lighting::EnvironmentNeeds reference = needs(ball("model = \"cook_torrance\"\n", even, "reference = 16\n"));
    CHECK(reference.mirror);
    CHECK_FALSE(reference.blurred);
    CHECK_FALSE(reference.irradiance);
    CHECK_FALSE(needs(ball("model = \"cook_torrance\"\n", even, "on = false\n")).any());
}

TEST_CASE("environment: the plan counts what is baked and the bytes of the very maps") {
    Scene scene = ball("model = \"cook_torrance\"\n", even, "samples = 64\n");
    scene.image.environment_background = true;
    const auto make_plan = [](const Scene& of) { return make_plan_for(of, PlanRequest{.prune = false}); };
    const RenderPlan plan = make_plan(scene);
    const lighting::EnvironmentMaps maps = prepare_environment(scene.environment, plan.environment).maps;
    const auto pass = [&](const RenderPlan& of, const char* name) {
        for (const PlannedPass& planned : of.passes) {
            if (planned.name == name) return planned;
        }
        FAIL(name);
        return PlannedPass{};
    };
    CHECK(pass(plan, "bake prefiltered levels").buffers.at(0).bytes == 4 * maps.prefiltered.texels.size());
    CHECK(pass(plan, "bake irradiance").buffers.at(0).bytes == 4 * maps.irradiance.texels.size());
    CHECK(pass(plan, "bake brdf map").buffers.at(0).bytes == 4 * maps.brdf[0].texels.size());
    // 64 x 32 pixels: a cube of 128 texels a side, 2 x 2 directions a texel; E: 6 x 32^2 texels from 6 x 64^2.
    CHECK(pass(plan, "bake environment").cost.count == 6u * 128 * 128 * 4);
    CHECK(pass(plan, "bake irradiance").cost.count == 6u * 32 * 32 * 6 * 64 * 64);
    CHECK(pass(plan, "bake brdf map").cost.count == 64u * 64 * 1024);
    // 64 samples at roughness 1, on the smallest level; 32, the least number, on all others.
    const std::uint64_t texels = 6u * (128 * 128 * 3 + 64 * 64 + 32 * 32 + 16 * 16 + 2 * 8 * 8);
    CHECK(pass(plan, "bake prefiltered levels").cost.count == texels * 32);
    CHECK(baking_operations(plan) > 1e8);
    CHECK(describe(plan, false).find("baking, once and kept: ") != std::string::npos);
    scene.environment.irradiance = lighting::IrradianceForm::sh9;
    CHECK(pass(make_plan(scene), "bake irradiance").buffers.at(0).bytes == 9 * 3 * sizeof(float));
    scene.environment.reference = 16;  // the mirror alone
    const RenderPlan exact = make_plan(scene);
    const auto mirror = prepare_environment(scene.environment, exact.environment).maps.prefiltered;
    CHECK(pass(exact, "bake environment").buffers.at(2).bytes == 4 * mirror.texels.size());
    CHECK(pass(exact, "environment").cost.operations_each > pass(plan, "environment").cost.operations_each);
    Scene dark = scene;
    dark.environment.on = false;
    CHECK(baking_operations(make_plan(dark)) == 0.0);
    CHECK(total_operations(make_plan(dark)) < total_operations(plan));
}

TEST_CASE("environment: only the levels that a roughness reads are baked, and they are the same to the bit") {
    const auto plan_of = [](const std::string& keys) {
        return make_plan(ball("model = \"cook_torrance\"\n" + keys, even, "samples = 64\n"));
    };
    const RenderPlan half = plan_of("roughness = 0.5\n"), mirror = plan_of("roughness = 0\n");
    // alpha = 0.25 lies on level 7 + log2 0.25 = 5, alpha = 0 (or the least there is) between the levels 0 and 1.
    CHECK(half.environment.first_level == 5);
    CHECK(half.environment.last_level == 6);
    CHECK(mirror.environment.first_level == 0);
    CHECK(mirror.environment.last_level == 1);
    const Scene scene = ball("model = \"cook_torrance\"\nroughness = 0.5\n", even, "samples = 64\n");
    lighting::EnvironmentNeeds all = half.environment;
    all.first_level = 0;
    all.last_level = lighting::kPrefilterLevels - 1;
    CHECK(covers(all, half.environment));
    CHECK_FALSE(covers(half.environment, all));
    CHECK_FALSE(covers(half.environment, mirror.environment));
    const lighting::CubeMap few = prepare_environment(scene.environment, half.environment).maps.prefiltered;
    const lighting::CubeMap full = prepare_environment(scene.environment, all).maps.prefiltered;
    REQUIRE(few.last_level() == 6);
    for (const int level : {5, 6}) {
        CHECK(few.levels[level].size == full.levels[level].size);
        const glm::vec3 d(0.3f, -0.5f, 0.8f);
        CHECK(sample_level(few, level, d) == sample_level(full, level, d));
    }
    CHECK(few.texels.size() < full.texels.size() / 20);
    const RenderPlan metal = plan_of("metallic = 1\n"), dark = plan_of("ao = 0\n");
    CHECK_FALSE(metal.environment.irradiance);
    CHECK_FALSE(dark.environment.any());
}

TEST_CASE("environment: one that is off changes no bit") {
    const Scene off = ball("model = \"cook_torrance\"\nemission = [0.1, 0.2, 0.3]\n", even, "on = false\n");
    Scene none = off;
    none.environment = {};
    CHECK(render(off).values == render(none).values);
}

TEST_CASE("environment: flat and Gouraud shading gather it at centroids and vertices") {
    for (const char* frequency : {"flat", "gouraud"}) {
        CAPTURE(frequency);
        Scene scene = ball("model = \"lambert\"\ndiffuse = [1, 1, 1]\n", even);
        scene.shading.frequency = frequency == std::string("flat") ? ShadingFrequency::flat : ShadingFrequency::gouraud;
        CHECK(render(scene).at(2, 30, 20) == doctest::Approx(2.0).epsilon(1e-3));
    }
}
