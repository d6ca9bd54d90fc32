// What an assignment's stages expect, pixel by pixel, against what the renderer itself wrote into its channels.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tools/grade/assignment/argument_text.hpp"
#include "tools/grade/assignment/scene_case.hpp"

using namespace kreda;
namespace fs = std::filesystem;

namespace {

/// The channels of these names, as `kreda render --view` draws them.
std::vector<raster::Image> render_views(const fs::path& file, const std::vector<const char*>& names) {
    const scene::Scene scene = scene::read_scene(file.string());
    std::vector<const scene::View*> views;
    for (const char* name : names) views.push_back(scene::find_view(name));
    scene::RenderBuffers buffers;
    scene::render(scene, make_plan(scene, views), buffers, 1);
    return buffers.views;
}

/// A stage's table of one scene: what it is given, and what it should answer.
struct Rows {
    const tools::StageTable& input;
    const tools::StageTable& expected;
};
Rows rows_of(const tools::CaseSet& cases, const std::string& stage, const std::string& scene) {
    std::size_t i = 0;
    while (cases.inputs[i].stage != stage || cases.inputs[i].scene != scene) ++i;
    return {cases.inputs[i], cases.expected[i]};
}

tools::Rubric rubric_of(const char* folder) {
    return tools::read_rubric(fs::path(KREDA_SOURCE_DIR) / "examples" / "assignments" / folder / "rubric.toml");
}

/// A triangle wave, as A2 shows an attribute.
float wave(float a) {
    return std::abs(2.0f * (a - std::floor(a)) - 1.0f);
}

/// Is this the colour of A2's attribute at a place, for an object of any number? The wave has slope 2 and the place a
/// factor of 2.3; places of float precision are off by some 1e-5 in scenes some units deep.
bool is_color_of_place(const double* color, const glm::vec3& place) {
    for (int object = 0; object < 16; ++object) {
        const glm::vec3 a = 2.3f * place + static_cast<float>(object) * glm::vec3(0.37f, 0.21f, 0.13f);
        bool same = true;
        for (int c = 0; c < 3; ++c) same = same && std::abs(color[c] - static_cast<double>(wave(a[c]))) < 2e-4;
        if (same) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("A2 expects the depth and the place that the renderer has at every pixel") {
    const tools::Rubric rubric = rubric_of("A2_depth");
    const tools::CaseSet cases = tools::make_cases(rubric, {});
    for (const tools::SceneCase& scene : cases.scenes) {
        CAPTURE(scene.name);
        const auto views = render_views(scene.file, {"depth", "position"});
        const Rows rows = rows_of(cases, "draw_fragment", scene.name);
        std::size_t seen = 0;
        for (const float depth : views[0].values) seen += depth < 1.0f ? 1 : 0;
        CHECK(seen == rows.input.rows);  // one row for each pixel that shows a surface
        for (std::size_t row = 0; row < rows.input.rows; ++row) {
            const glm::ivec2 p = rows.input.pixel[row];
            CAPTURE(p.x);
            CAPTURE(p.y);
            const double depth = rows.expected.find("depth")->values[row];
            REQUIRE(std::abs(depth - static_cast<double>(views[0].at(0, p.x, p.y))) < 2e-6);  // some ulps of 1
            const glm::vec3 place(views[1].at(0, p.x, p.y), views[1].at(1, p.x, p.y), views[1].at(2, p.x, p.y));
            REQUIRE(is_color_of_place(rows.expected.find("color")->values.data() + 3 * row, place));
        }
    }
}

// With a slope bias the renderer also lets the distance follow the surface's plane from texel to texel, which the
// assignment leaves out: those scenes are not compared.
TEST_CASE("A7 expects the shadow that the renderer has at every pixel") {
    const tools::Rubric rubric = rubric_of("A7_shadow_map");
    const tools::CaseSet cases = tools::make_cases(rubric, {});
    int compared = 0;
    for (const tools::SceneCase& scene : cases.scenes) {
        CAPTURE(scene.name);
        if (scene::read_scene(scene.file.string()).shadow.bias == shadows::ShadowBias::slope) continue;
        ++compared;
        const auto views = render_views(scene.file, {"shadow", "n_dot_l"});
        const Rows rows = rows_of(cases, "shadow_factor", scene.name);
        std::size_t doubtful = 0;
        for (std::size_t row = 0; row < rows.input.rows; ++row) {
            const glm::ivec2 p = rows.input.pixel[row];
            CAPTURE(p.x);
            CAPTURE(p.y);
            const double factor = rows.expected.find("color")->values[row];
            if (rows.input.doubtful[row]) {
                ++doubtful;
            } else if (views[1].at(0, p.x, p.y) <= 0.0f) {
                REQUIRE(factor == 0.0);  // it turns away: the cosine is 0, whatever the map says
            } else {
                REQUIRE(std::abs(factor - static_cast<double>(views[0].at(0, p.x, p.y))) < 1e-6);
            }
        }
        CHECK(doubtful < rows.input.rows / 20);
    }
    CHECK(compared == 2);
}

TEST_CASE("arguments are written with words where a number stands for one") {
    const auto number = [](double value) { return std::to_string(static_cast<int>(value)); };
    const auto text = [&](const std::vector<tools::StageColumn>& columns) {
        return tools::arguments_text({"f", "s", 1, columns, {}, {}}, 0, number);
    };
    CHECK(text({{"light_kind_inner_outer", 3, true, {2, 9, 8}}, {"p", 3, true, {1, 2, 3}}}) ==
          "light = spot, cos_inner_outer = (9, 8), p = (1, 2, 3)");
    CHECK(text({{"light_kind_inner_outer", 3, true, {0, 9, 8}}}) == "light = directional, cos_inner_outer = (9, 8)");
    CHECK(text({{"mode", 1, true, {3}}, {"distance", 1, true, {1}}}) == "mode = exp2, distance = planar");
    CHECK(text({{"distance", 1, true, {1}}, {"all", 1, false, {7, 8}}}) == "distance = 1");
    CHECK(text({{"frequency", 1, true, {4}}}) == "frequency = 4");
}
