// The plots of reflection models: their numbers are those of the formulas, and energy is kept where it must be.
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/brdf/lobe_plots.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::tools;

namespace {

const LobeModel& model_named(std::string_view name) {
    for (const LobeModel& model : lobe_models()) {
        if (model.name == name) return model;
    }
    FAIL("no such model");
    return lobe_models().front();
}

}  // namespace

TEST_CASE("lobes: Lambert is even and gives back m_D") {
    const Reflector lambert = make_reflector(model_named("lambert"), 1.0f);
    for (const double theta : {0.0, 30.0, 80.0}) {
        CHECK(brdf(lambert, direction(theta), direction(-20.0, 70.0)) == doctest::Approx(0.8 / std::numbers::pi));
        // Midpoints of 192 x 384 cells, of which those at the horizon are cut: 1e-4 of the whole.
        CHECK(reflectance(lambert, theta) == doctest::Approx(0.8).epsilon(1e-3));
    }
    CHECK(brdf(lambert, direction(20.0), direction(91.0)) == 0.0);
}

TEST_CASE("lobes: Phong's highlight under a lamp overhead holds 2 / (h + 2) of the light") {
    // The integral of cos^h(theta) cos(theta) over the hemisphere is 2 pi / (h + 2); the lamp is pi times s.
    for (const float roughness : plotted_roughnesses()) {
        const Reflector phong = make_reflector(model_named("phong"), roughness);
        const double h = double(phong.material.phong.shininess);
        const double wanted = 0.3 + 0.5 * 2.0 / (h + 2.0);
        CHECK(reflectance(phong, 0.0) == doctest::Approx(wanted).epsilon(1e-3));
    }
}

TEST_CASE("lobes: models that keep energy give back at most what they get") {
    int conserving = 0;
    for (const LobeModel& model : lobe_models()) {
        if (!model.conserves) continue;
        ++conserving;
        for (const float roughness : {0.2f, 0.3f, 0.5f, 0.8f, 1.0f}) {
            const Reflector reflector = make_reflector(model, roughness);
            for (const double theta : {0.0, 30.0, 60.0, 80.0, 88.0}) {
                CAPTURE(model.name);
                CAPTURE(roughness);
                CAPTURE(theta);
                const double R = reflectance(reflector, theta, 96);
                CHECK(R <= 1.0 + 2e-3);  // the quadrature's own error, measured between 96 and 384 steps
                CHECK(R > 0.2);
            }
        }
    }
    CHECK(conserving == 5);
}

TEST_CASE("lobes: a smooth white metal gives back nearly all and more steps change nothing that is printed") {
    const Reflector smooth = make_reflector(model_named("ggx"), 0.3f);
    CHECK(reflectance(smooth, 30.0) > 0.97);
    CHECK(reflectance(smooth, 30.0) == doctest::Approx(reflectance(smooth, 30.0, 384)).epsilon(5e-4));
}

TEST_CASE("lobes: physical models do not care which direction is the lamp's") {
    for (const char* name : {"lambert", "ggx", "beckmann", "facets_blinn_phong", "facets_gaussian"}) {
        const Reflector reflector = make_reflector(model_named(name), 0.5f);
        for (const double phi : {0.0, 70.0, 180.0}) {
            const glm::dvec3 a = direction(20.0), b = direction(65.0, phi);
            CAPTURE(name);
            CHECK(brdf(reflector, a, b) == doctest::Approx(brdf(reflector, b, a)).epsilon(1e-5));  // floats
        }
    }
}

TEST_CASE("brdf command: without gnuplot it writes the numbers and says what is missing") {
    const TempFolder folder;
    const Outcome outcome =
        run_program("/usr/bin/env", {"PATH=/nowhere", KREDA_PROGRAM, "brdf", "ggx", "-o", "out"}, folder.path.string());
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.find("no figures, the numbers alone: gnuplot is not installed") != std::string::npos);
    CHECK(names_in(folder.file("out")) == std::vector<std::string>{"ggx.csv", "reflectance.csv"});
}

TEST_CASE("brdf command: writes numbers and a figure") {
    const TempFolder folder;
    const Outcome outcome = run_kreda({"brdf", "lambert", "-o", "out"}, folder.path.string());
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    const std::string csv = bytes_of(folder.file("out/lambert.csv"));
    CHECK(csv.find("lambert,1,30,-60,0.254648\n") != csv.npos);  // 0.8 / pi
    CHECK(bytes_of(folder.file("out/reflectance.csv")).find("lambert,1,60,0.7999") != std::string::npos);
    if (outcome.err.find("gnuplot") != std::string::npos) {
        MESSAGE("SKIPPED: gnuplot is not installed");
        return;
    }
    const raster::Image figure = scene::read_image(folder.file("out/lambert.png"));
    CHECK(figure.width == 1100);
    CHECK(names_in(folder.file("out")) == std::vector<std::string>{"lambert.csv", "lambert.png", "reflectance.csv"});
    const Outcome unknown = run_kreda({"brdf", "gxg"}, folder.path.string());
    CHECK(unknown.exit_code == 2);
    CHECK(unknown.err.find("did you mean 'ggx'?") != std::string::npos);
}
