// What `kreda explain` says of a pixel is what the real render did with it.
#include <cmath>
#include <cstdio>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/explain_scenes.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/explain/explain.hpp"

using namespace kreda;
using namespace kreda::tests;
using tools::Equation;
using tools::Explanation;

namespace {

const tools::Section* find_section(const Explanation& explanation, const std::string& id) {
    for (const tools::Section& section : explanation.derivation.sections) {
        if (section.id == id) return &section;
    }
    return nullptr;
}

/// The value of the last equation with this symbol.
std::vector<double> value_of(const tools::Section& section, const std::string& symbol) {
    std::vector<double> value;
    for (const tools::Item& item : section.items) {
        const auto* equation = std::get_if<Equation>(&item);
        if (equation && equation->symbol == symbol) value = equation->value;
    }
    return value;
}

glm::vec3 vector_of(const std::vector<double>& value) {
    REQUIRE(value.size() == 3);
    return glm::vec3(value[0], value[1], value[2]);
}

const tools::Table* find_table(const tools::Section& section, const std::string& name) {
    for (const tools::Item& item : section.items) {
        const auto* table = std::get_if<tools::Table>(&item);
        if (table && table->name == name) return table;
    }
    return nullptr;
}

/// Every seventeenth pixel, in a pattern that meets all columns and rows.
template <class Visit>
void for_some_pixels(const scene::Scene& scene, Visit visit) {
    for (int i = 0; i < scene.image.width * scene.image.height; i += 17) {
        visit(i % scene.image.width, i / scene.image.width);
    }
}

/// A flat square of 2 x 2 before an orthographic camera that sees 4 x 4 of the plane z = 0 in 64 x 64 pixels.
scene::Scene square_scene(const std::string& more = {}) {
    return scene::read_scene_text(
        "[image]\nsize = [64, 64]\n[camera]\nposition = [0, 0, 4]\nprojection = \"orthographic\"\nheight = 4\n" + more +
            "[[object]]\nmesh = \"plane\"\nrotate = [90, 0, 0]\n",
        "square", "");
}

}  // namespace

TEST_CASE("explain: radiance and bytes are those of the picture, in every kind of scene") {
    for (const NamedScene& named : scenes_to_explain()) {
        const scene::Scene& scene = named.scene;
        CAPTURE(named.name);
        const raster::Image film = scene::render(scene);
        const scene::ImageSettings& i = scene.image;
        const raster::Image display = develop(film, {i.exposure, i.tone_map, i.white, i.transfer, i.gamma});
        int covered = 0;
        for_some_pixels(scene, [&](int x, int y) {
            CAPTURE(x);
            CAPTURE(y);
            const Explanation explanation = tools::explain_pixel(scene, {x, y});
            covered += explanation.covered;
            REQUIRE(explanation.radiance == film.rgb(x, y));
            for (int c = 0; c < 3; ++c) {
                REQUIRE(explanation.byte[static_cast<std::size_t>(c)] == scene::byte_from_encoded(display.at(c, x, y)));
            }
        });
        CHECK((covered > 0) == !scene.objects.empty());
    }
}

TEST_CASE("explain: the lights' terms add up to the sums of the passes and these to the radiance") {
    for (const NamedScene& named : scenes_to_explain()) {
        CAPTURE(named.name);
        if (named.scene.shading.frequency != scene::ShadingFrequency::phong) continue;
        for_some_pixels(named.scene, [&](int x, int y) {
            const Explanation explanation = tools::explain_pixel(named.scene, {x, y});
            const tools::Section* last_light = find_section(explanation, "light_2");
            if (!explanation.covered || !last_light) return;
            glm::vec3 diffuse(0.0f), specular(0.0f);
            for (const char* light : {"light_0", "light_1", "light_2"}) {
                diffuse += vector_of(value_of(*find_section(explanation, light), "L_D"));
                specular += vector_of(value_of(*find_section(explanation, light), "L_S"));
            }
            // The batch adds energy compensation to the sum, after D V F; the derivation adds the two first: 1 ulp.
            const auto close = [](const glm::vec3& a, const glm::vec3& b) {
                for (int c = 0; c < 3; ++c) CHECK(a[c] == doctest::Approx(b[c]).epsilon(3e-7));
            };
            close(diffuse, vector_of(value_of(*last_light, "diffuse")));
            close(specular, vector_of(value_of(*last_light, "specular")));
            const glm::vec3 ambient = vector_of(value_of(*find_section(explanation, "surface"), "ambient"));
            close(ambient + diffuse + specular, vector_of(value_of(*find_section(explanation, "sum"), "radiance")));
        });
    }
}

TEST_CASE("explain: the environment's terms follow from the numbers that stand before them") {
    const auto near = [](const glm::vec3& a, const glm::vec3& b) {
        for (int c = 0; c < 3; ++c) CHECK(a[c] == doctest::Approx(b[c]).epsilon(2e-6));
    };
    constexpr float kPi = 3.14159265f;
    int seen = 0;
    for (const NamedScene& named : scenes_to_explain()) {
        if (!named.name.starts_with("environment, ")) continue;
        CAPTURE(named.name);
        for_some_pixels(named.scene, [&](int x, int y) {
            const Explanation explanation = tools::explain_pixel(named.scene, {x, y});
            if (!explanation.covered) return;
            ++seen;
            const tools::Section& surface = *find_section(explanation, "surface");
            const auto vector = [&](const char* symbol) { return vector_of(value_of(surface, symbol)); };
            const auto number = [&](const char* symbol) { return float(value_of(surface, symbol).at(0)); };
            const bool exact = named.scene.environment.reference > 0;
            const bool microfacets = named.scene.materials[0].model == lighting::ReflectionModel::cook_torrance;
            CHECK(value_of(surface, "E").empty() == (exact && microfacets));
            CHECK(value_of(surface, "P").empty() == (exact || !microfacets));
            if (!microfacets) near(vector("env_D"), named.scene.materials[0].phong.diffuse * vector("E") / kPi);
            if (!microfacets || exact) return;
            near(vector("k_d"), (glm::vec3(1.0f) - vector("F")) * 0.6f);  // metallic = 0.4
            near(vector("env_D"), number("ao") * vector("k_d") * vector("c") * vector("E") / kPi);
            glm::vec3 specular = vector("P") * (vector("F0") * number("A") + glm::vec3(number("B")));
            if (!value_of(surface, "F_ms").empty()) {
                specular += vector("F_ms") * (1.0f - (number("A") + number("B"))) * vector("E") / kPi;
            }
            near(vector("env_S"), number("ao") * specular);
            CHECK(number("level") == doctest::Approx(7.0 + std::log2(0.35 * 0.35)).epsilon(1e-6));
        });
    }
    CHECK(seen >= 30);
}

TEST_CASE("explain: a pixel without a surface looks along its line of sight into the environment") {
    scene::Scene scene = square_scene("[environment]\nsky = \"gradient\"\nsamples = 32\nintensity = 2\n");
    scene.image.environment_background = true;
    scene.objects.clear();
    scene.camera.projection = raster::Projection::perspective;
    scene.camera.vertical_fov_deg = 90.0f;
    const Explanation explanation = tools::explain_pixel(scene, {0, 63});
    const tools::Section& section = *find_section(explanation, "background");
    const glm::vec3 d = vector_of(value_of(section, "d"));
    CHECK(glm::distance(glm::normalize(d), glm::normalize(glm::vec3(-63.0f, -63.0f, -64.0f))) < 1e-6f);
    const glm::vec3 sky = 2.0f * lighting::gradient_sky(glm::normalize(d));
    const glm::vec3 seen = vector_of(value_of(section, "radiance"));
    for (int c = 0; c < 3; ++c) CHECK(seen[c] == doctest::Approx(sky[c]).epsilon(2e-3));  // a texel of 256 a face
}

TEST_CASE("explain: barycentric coordinates are the shares of the edge functions and put the position where it is") {
    const scene::Scene scene = scenes_to_explain()[2].scene;
    for_some_pixels(scene, [&](int x, int y) {
        const Explanation explanation = tools::explain_pixel(scene, {x, y});
        if (!explanation.covered) return;
        const tools::Section& section = *find_section(explanation, "interpolation");
        const glm::vec3 b = vector_of(value_of(section, "b"));
        CHECK(b.x + b.y + b.z == doctest::Approx(1.0).epsilon(1e-6));
        const double q[3] = {value_of(section, "q_a")[0], value_of(section, "q_b")[0], value_of(section, "q_c")[0]};
        for (int i = 0; i < 3; ++i) CHECK(b[i] == doctest::Approx(q[i] / (q[0] + q[1] + q[2])).epsilon(1e-6));
        // The position, sent through the camera again, comes out in the middle of the pixel.
        const glm::vec4 clip =
            clip_from_world(scene.camera, 24.0f / 16.0f) * glm::vec4(vector_of(value_of(section, "position")), 1.0f);
        CHECK((clip.x / clip.w + 1.0f) * 12.0f ==
              doctest::Approx(x + 0.5).epsilon(0.001));  // the snap moves corners by 1/512
        CHECK((1.0f - clip.y / clip.w) * 8.0f == doctest::Approx(y + 0.5).epsilon(0.001));
    });
}

TEST_CASE("explain: a pixel beside a square knows the edge that is nearest and how far it is") {
    // The square covers pixels 16 .. 47. The centre of pixel (10, 30) lies 5.5 pixels left of its left edge.
    const Explanation explanation = tools::explain_pixel(square_scene(), {10, 30});
    CHECK_FALSE(explanation.covered);
    const std::string text = as_text(explanation.derivation);
    CAPTURE(text);
    CHECK(text.find("is 5.5 samples away") != std::string::npos);
    CHECK(text.find("No triangle that was left out lies over it.") != std::string::npos);
}

TEST_CASE("explain: background tells what was culled and clipped and hidden") {
    const auto why = [](const scene::Scene& scene) {
        const Explanation explanation = tools::explain_pixel(scene, {32, 20});
        CHECK_FALSE(explanation.covered);
        const tools::Table* table = find_table(*find_section(explanation, "background"), "not_drawn");
        REQUIRE(table);
        REQUIRE(table->rows.size() == 1);
        return table->rows[0][1];
    };
    CHECK(why(square_scene("[shading]\ncull = \"front\"\n")).find("culled") == 0);
    CHECK(why(square_scene("near = 5\nfar = 9\n")).find("clipped: nearer than camera.near") == 0);
    CHECK(why(square_scene("near = 1\nfar = 3\n")).find("clipped: farther than camera.far") == 0);
    scene::Scene hidden = square_scene();
    hidden.objects[0].part_hidden.assign(1, true);
    CHECK(why(hidden).find("its part is hidden") == 0);
}

TEST_CASE("explain: behind the front of a closed ball lies one culled back face") {
    scene::Scene scene = scenes_to_explain()[2].scene;
    scene.objects.resize(1);
    const Explanation explanation = tools::explain_pixel(scene, {11, 8});
    REQUIRE(explanation.covered);
    const tools::Table* table = find_table(*find_section(explanation, "depth"), "not_drawn");
    REQUIRE(table);
    REQUIRE(table->rows.size() == 1);
    CHECK(table->rows[0][1].find("culled") == 0);
}

TEST_CASE("explain: the depths of a pixel's triangles are told in drawing order and the least is seen") {
    const scene::Scene scene = scenes_to_explain()[2].scene;  // the ball is drawn before the wall behind it
    const Explanation explanation = tools::explain_pixel(scene, {11, 8});
    const tools::Table* table = find_table(*find_section(explanation, "depth"), "covers");
    REQUIRE(table);
    REQUIRE(table->rows.size() == 2);
    CHECK(table->rows[0][3] == "seen");
    CHECK(table->rows[1][3].find("hidden") == 0);
    CHECK(std::stod(table->rows[0][2]) < std::stod(table->rows[1][2]));
}

TEST_CASE("explain: the command prints text and Markdown and JSON of the same bytes") {
    const TempFolder folder;
    const auto run = [&](std::vector<std::string> args) {
        args.insert(args.begin(),
                    {"explain", "--set", "image.size=[60,40]", "--set", "image.samples=2", "--pixel", "30,20"});
        const Outcome outcome = run_kreda(args, folder.path.string());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return outcome.out;
    };
    const nlohmann::json json = nlohmann::json::parse(run({"--format", "json"}));
    const nlohmann::json last = json.at("sections").back().at("items").back();
    CHECK(last.at("symbol") == "byte");
    REQUIRE(run_kreda({"render", "--size", "60x40", "--samples", "2", "-o", "p.png"}, folder.path.string()).exit_code ==
            0);
    const raster::Image png = scene::read_image(folder.file("p.png"));
    std::string bytes = "(";
    for (int c = 0; c < 3; ++c) {
        const long byte = std::lround(255.0f * png.at(c, 30, 20));
        CHECK(last.at("value")[static_cast<std::size_t>(c)] == byte);
        bytes += (c ? ", " : "") + std::to_string(byte);
    }
    bytes += ")";
    CHECK(run({}).find(bytes) != std::string::npos);
    CHECK(run({"--format", "md"}).find(bytes) != std::string::npos);
    CHECK(run({"--format", "md"}).find("| symbol | formula | numbers | result |") != std::string::npos);
}

TEST_CASE("explain: what cannot be asked is refused with the remedy") {
    const TempFolder folder;
    const auto refused = [&](std::vector<std::string> args, const char* remedy) {
        args.insert(args.begin(), "explain");
        const Outcome outcome = run_kreda(args, folder.path.string());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.out.empty());
        CHECK(line_count(outcome.err) == 1);
        CHECK(outcome.err.find(remedy) != std::string::npos);
    };
    refused({}, "--pixel");
    refused({"--pixel", "12"}, "e.g. --pixel 320,180");
    refused({"--pixel", "1,2,3"}, "e.g. --pixel 320,180");
    refused({"--pixel=-1,2"}, "e.g. --pixel 320,180");
    refused({"--pixel", "640,0"}, "X from 0 to 639");
    refused({"--pixel", "99999999999,0"}, "e.g. --pixel 320,180");
    refused({"--pixel", "1,1", "--sample", "3,0"}, "numbers from 0 to 2");
    refused({"--pixel", "1,1", "--format", "pdf"}, "--format");
}

namespace {

/// A wall behind a ball, lit from beside it, so that the ball's shadow falls on the wall, and a ball turned away from
/// the light. `kind` is the light, `shadow` the table.
scene::Scene shadow_scene(const std::string& kind, const std::string& shadow) {
    return scene::read_scene_text(
        "[image]\nsize = [24, 16]\n[camera]\nposition = [0.4, 0.6, 4]\n"
        "[[light]]\nshadow = true\n" +
            kind + "[shadow]\nsize = 64\n" + shadow +
            "[[object]]\nmesh = \"sphere\"\ndetail = 8\nscale = 0.6\n"
            "[[object]]\nmesh = \"plane\"\nrotate = [90, 0, 0]\ntranslate = [0, 0, -1]\nscale = 2\n",
        "shadows", "");
}

/// All values of the equations with this symbol, in their order.
std::vector<double> all_values_of(const tools::Section& section, const std::string& symbol) {
    std::vector<double> values;
    for (const tools::Item& item : section.items) {
        const auto* equation = std::get_if<Equation>(&item);
        if (equation && equation->symbol == symbol) values.push_back(equation->value.at(0));
    }
    return values;
}

struct ShadowCase {
    std::string name, kind, shadow;
};

std::vector<ShadowCase> shadow_cases() {
    const std::pair<const char*, const char*> lights[] = {
        {"directional", "type = \"directional\"\ndirection = [-1, -0.5, -2]\n"},
        {"point", "type = \"point\"\nposition = [1.5, 1, 2]\n"},
        {"spot", "type = \"spot\"\nposition = [1.5, 1, 2]\ndirection = [-1.5, -1, -2.5]\ncone = [20, 40]\n"},
    };
    std::vector<ShadowCase> cases;
    for (const auto& [name, kind] : lights) {
        for (const char* method : {"exact", "irregular", "volume", "planar"}) {
            cases.push_back({std::string(name) + " " + method, kind, "method = \"" + std::string(method) + "\"\n"});
        }
        for (const char* filter : {"none", "pcf", "pcss"}) {
            for (const char* bias : {"none", "constant", "slope", "normal_offset"}) {
                cases.push_back(
                    {std::string(name) + " map " + filter + " " + bias, kind,
                     "light_size = 0.3\nfilter = \"" + std::string(filter) + "\"\nbias = \"" + bias + "\"\n"});
            }
        }
    }
    return cases;
}

}  // namespace

TEST_CASE("explain: the derivation of a shadow ends in the very number that the film was drawn with") {
    for (const ShadowCase& one : shadow_cases()) {
        CAPTURE(one.name);
        const scene::Scene scene = shadow_scene(one.kind, one.shadow);
        const scene::RenderPlan plan = make_plan(scene, {scene::find_view("shadow")});
        scene::RenderBuffers buffers;
        render(scene, plan, buffers);
        int dark = 0, lit = 0;
        for (int i = 0; i < 24 * 16; i += 5) {
            const int x = i % 24, y = i / 24;
            CAPTURE(x);
            CAPTURE(y);
            const Explanation explanation = tools::explain_pixel(scene, {x, y}, 1);  // tiny: threads would only wait
            if (!explanation.covered) continue;
            const std::vector<double> shadow = all_values_of(*find_section(explanation, "light_0"), "shadow");
            REQUIRE(shadow.size() == 2);  // as it was derived, and as the channel holds it
            CHECK(shadow[0] == shadow[1]);
            CHECK(static_cast<float>(shadow[0]) == buffers.views[0].at(0, x, y));
            (shadow[0] < 1.0 ? dark : lit) += 1;
        }
        CHECK(dark > 0);
        CHECK(lit > 0);
    }
}

TEST_CASE("explain: the numbers of an equation hold no second equation and lights have the numbers of the file") {
    for (const NamedScene& named : scenes_to_explain()) {
        CAPTURE(named.name);
        const Explanation explanation = tools::explain_pixel(named.scene, {11, 8});
        for (const tools::Section& section : explanation.derivation.sections) {
            for (const tools::Item& item : section.items) {
                const auto* equation = std::get_if<Equation>(&item);
                if (!equation) continue;
                CAPTURE(equation->symbol);
                CHECK(equation->numbers.find(" = ") == std::string::npos);
            }
        }
    }
    scene::Scene scene = scenes_to_explain()[2].scene;
    scene.lights[0].on = false;
    const Explanation explanation = tools::explain_pixel(scene, {11, 8});
    CHECK(find_section(explanation, "light_0") == nullptr);
    CHECK(find_section(explanation, "light_1") != nullptr);
}

TEST_CASE("explain: planar fog puts in the numbers of its own formula") {
    // The camera looks along -z from z = 3 or so; the sum of the products is the distance.
    for (const NamedScene& named : scenes_to_explain()) {
        if (named.name != "fog linear planar") continue;
        const Explanation explanation = tools::explain_pixel(named.scene, {11, 8});
        REQUIRE(explanation.covered);
        for (const tools::Item& item : find_section(explanation, "fog")->items) {
            const auto* equation = std::get_if<Equation>(&item);
            if (!equation || equation->symbol != "z_p") continue;
            double a[3], b[3];
            std::string plain = equation->numbers;
            for (const char* sign : {"(", ")"}) {
                for (std::size_t at = 0; (at = plain.find(sign)) != std::string::npos;) plain.erase(at, 1);
            }
            for (std::size_t at = 0; (at = plain.find("·")) != std::string::npos;) plain.replace(at, 2, "*");
            REQUIRE(std::sscanf(plain.c_str(), "%lf*%lf + %lf*%lf + %lf*%lf", &a[0], &b[0], &a[1], &b[1], &a[2],
                                &b[2]) == 6);
            CHECK(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] == doctest::Approx(equation->value.at(0)).epsilon(1e-5));
        }
    }
}

TEST_CASE("explain: with several samples a pixel window coordinates are told in samples and in pixels") {
    scene::Scene scene = square_scene();
    scene.image.samples = 2;
    const std::string text = as_text(tools::explain_pixel(scene, {32, 32}).derivation);
    CHECK(text.find("window, in pixels   (16, ") != std::string::npos);
    CHECK(text.find("window, in samples  (32, ") != std::string::npos);
}

TEST_CASE("explain: the distance to what blocks is that of the ray's hit and methods without one do not show it") {
    // The square at z = 0.5 is 1.5 before the wall; the ray to the light climbs by 0.8: 1.5 / 0.8 = 1.875 along it.
    const auto scene_with = [](const char* method) {
        return square_scene(
            "[[light]]\nshadow = true\ndirection = [-0.6, 0, -0.8]\n[shadow]\nmethod = \"" + std::string(method) +
            "\"\n[[object]]\nmesh = \"plane\"\nrotate = [90, 0, 0]\ntranslate = [0, 0, 0.5]\nscale = 0.5\n"
            "[[object]]\nmesh = \"plane\"\nrotate = [90, 0, 0]\ntranslate = [0, 0, -1]\nscale = 3\n");
    };
    scene::Scene scene = scene_with("exact");
    scene.objects.pop_back();  // that of square_scene()
    const scene::RenderPlan plan = make_plan(scene, {scene::find_view("blocker_distance")});
    scene::RenderBuffers buffers;
    render(scene, plan, buffers);
    CHECK(buffers.views[0].at(0, 14, 32) == doctest::Approx(1.875).epsilon(1e-6));
    CHECK(buffers.views[0].at(0, 60, 32) == 0.0f);  // lit
    const tools::Section section = *find_section(tools::explain_pixel(scene, {14, 32}), "light_0");
    CHECK(value_of(section, "distance").at(0) == doctest::Approx(1.875).epsilon(1e-6));
    const scene::Scene other = scene_with("volume");
    CHECK_FALSE(can_show(make_plan(other), other, *scene::find_view("blocker_distance")));
}
