// What `kreda stages` writes: the pictures and numbers of the real render, and a page that works from a file.
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <string>

#include <doctest/doctest.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/explain_scenes.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/draw/slide.hpp"
#include "tools/stages/stage.hpp"
#include "tools/stages/stage_page.hpp"

using namespace kreda;
using namespace kreda::tests;
using tools::Stage;

namespace {

std::map<std::string, Stage> stages_of(const scene::Scene& scene) {
    std::map<std::string, Stage> stages;
    tools::for_each_stage(scene, [&](const Stage& stage) { stages[stage.name] = stage; });
    return stages;
}

scene::Scene scene_named(const std::string& name) {
    for (const NamedScene& named : scenes_to_explain()) {
        if (named.name == name) return named.scene;
    }
    FAIL("no scene ", name);
    return {};
}

bool same_values(const raster::Image& a, const raster::Image& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels && a.values == b.values;
}

/// An independent way back from packed_values: inflate, add up, put the bytes together.
std::vector<float> unpacked(const std::vector<unsigned char>& packed, std::size_t value_count, std::size_t plane_size) {
    std::vector<unsigned char> bytes(3 * value_count);
    uLongf size = static_cast<uLongf>(bytes.size());
    REQUIRE(uncompress(bytes.data(), &size, packed.data(), static_cast<uLong>(packed.size())) == Z_OK);
    REQUIRE(size == bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (i % plane_size != 0) bytes[i] = static_cast<unsigned char>(bytes[i] + bytes[i - 1]);
    }
    std::vector<float> values;
    for (std::size_t v = 0; v < value_count; ++v) {
        const std::size_t channel = v / plane_size, i = v % plane_size;
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | bytes[(3 * channel + k) * plane_size + i];
        values.push_back(std::bit_cast<float>(bits << 8));
    }
    return values;
}

}  // namespace

TEST_CASE("stages: every kind of scene ends with the picture that render draws") {
    for (const NamedScene& named : scenes_to_explain()) {
        CAPTURE(named.name);
        std::vector<std::string> names;
        raster::Image radiance, last;
        tools::for_each_stage(named.scene, [&](const Stage& stage) {
            names.push_back(stage.name);
            CHECK(stage.picture.channels == 3);
            CHECK(stage.picture.width == named.scene.image.width);
            CHECK(stage.values.channels == static_cast<int>(stage.components.size()));
            if (stage.name == "radiance") radiance = stage.values;
            last = stage.picture;
        });
        CHECK(names.back() == "final");
        CHECK(same_values(radiance, scene::render(named.scene)));
        std::sort(names.begin(), names.end());
        CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    }
}

TEST_CASE("stages: only what the plan holds is shown") {
    const auto has = [](const char* scene, const char* stage) {
        return stages_of(scene_named(scene)).count(stage) > 0;
    };
    CHECK_FALSE(has("phong", "fog"));
    CHECK(has("fog exp2", "fog"));
    CHECK(has("phong", "light_1_specular"));
    CHECK_FALSE(has("unlit", "normal"));
    CHECK_FALSE(has("phong", "light_0_D"));
    CHECK(has("D ggx", "light_2_D"));
    CHECK(has("D ggx", "roughness"));
    CHECK(has("gouraud", "light_0_radiance"));
    CHECK_FALSE(has("gouraud", "normal"));
    CHECK_FALSE(has("empty", "wireframe"));
    CHECK(has("shadows", "light_0_light_depth"));
    CHECK(has("shadows, flat", "light_0_light_depth"));
    CHECK_FALSE(has("phong", "light_0_light_depth"));
    CHECK(has("environment, split sum", "prefilter"));
    CHECK(has("environment, diffuse", "irradiance"));
    CHECK_FALSE(has("environment, diffuse", "prefilter"));
    CHECK_FALSE(has("environment, integral", "prefilter"));
    CHECK_FALSE(has("phong", "irradiance"));
}

TEST_CASE("stages: what the environment adds and what a surface sends by itself are its ambient light") {
    for (const char* name : {"environment, split sum", "environment, bounces", "environment, integral"}) {
        CAPTURE(name);
        const scene::Scene scene = scene_named(name);
        const glm::vec3 emission = scene.materials[0].phong.emission;
        const std::map<std::string, Stage> stages = stages_of(scene);
        const raster::Image& ambient = stages.at("ambient").values;
        float greatest = 0.0f;
        for (int y = 0; y < ambient.height; ++y) {
            for (int x = 0; x < ambient.width; ++x) {
                if (stages.at("overdraw").values.at(0, x, y) == 0.0f) continue;
                for (int c = 0; c < 3; ++c) {
                    const float sum = emission[c] + stages.at("environment_diffuse").values.at(c, x, y) +
                                      stages.at("environment_specular").values.at(c, x, y);
                    CHECK(ambient.at(c, x, y) == doctest::Approx(sum).epsilon(1e-6));
                    greatest = std::max(greatest, sum);
                }
            }
        }
        CHECK(greatest > 0.1f);
    }
}

TEST_CASE("stages: what a light sees keeps its shape and its distances") {
    const scene::Scene scene = scene_named("shadows");
    const Stage stage = stages_of(scene).at("light_0_light_depth");
    const scene::RenderPlan plan = make_plan(tools::with_only_light(scene, 0));
    REQUIRE(plan.shadows.size() == 1);
    const auto faces = static_cast<int>(plan.shadows[0].map.views.size());
    int shown = 0, casts = 0;
    for (const float d : stage.values.values) {
        shown += !std::isnan(d);
        casts += std::isfinite(d);
        if (std::isfinite(d)) CHECK((d > 0.0f && d < plan.shadows[0].map.views[0].far));
    }
    const int side = std::min(scene.image.height, scene.image.width / faces);
    CHECK(shown == side * side * faces);
    CHECK(casts > 0);
}

TEST_CASE("stages: the lights' terms add up to those of all lights") {
    const std::map<std::string, Stage> stages = stages_of(scene_named("D ggx"));
    for (const std::string term : {"diffuse", "specular"}) {
        const raster::Image& all = stages.at(term).values;
        float greatest = 0.0f;
        for (std::size_t i = 0; i < all.values.size(); ++i) {
            float sum = 0.0f;
            for (const char* light : {"light_0_", "light_1_", "light_2_"})
                sum += stages.at(light + term).values.values[i];
            CHECK(sum == doctest::Approx(all.values[i]).epsilon(1e-6));
            greatest = std::max(greatest, sum);
        }
        CHECK(greatest > 0.1f);
    }
}

TEST_CASE("stages: coverage and overdraw and barycentrics tell of the same samples") {
    const std::map<std::string, Stage> stages = stages_of(scene_named("3 x 3 samples"));
    const raster::Image& covered = stages.at("coverage").values;
    const raster::Image& overdraw = stages.at("overdraw").values;
    const raster::Image& b = stages.at("barycentrics").values;
    int partly = 0;
    for (int y = 0; y < covered.height; ++y) {
        for (int x = 0; x < covered.width; ++x) {
            const float share = covered.at(0, x, y);
            const glm::vec3 weights = b.rgb(x, y);
            CHECK(weights.x + weights.y + weights.z == doctest::Approx(share).epsilon(1e-5));
            CHECK(overdraw.at(0, x, y) >= share - 1e-6f);
            partly += share > 0.01f && share < 0.99f;
        }
    }
    CHECK(partly > 5);
}

TEST_CASE("stages: a square of known size covers just its pixels and both its triangles once") {
    // 2 x 2 world units where 4 are 64 pixels: pixels 16 .. 47.
    const scene::Scene scene = scene::read_scene_text(
        "[image]\nsize = [64, 64]\n[camera]\nposition = [0, 0, 4]\nprojection = \"orthographic\"\nheight = 4\n"
        "[[object]]\nmesh = \"plane\"\nrotate = [90, 0, 0]\n",
        "square", "");
    const std::map<std::string, Stage> stages = stages_of(scene);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const bool inside = x >= 16 && x < 48 && y >= 16 && y < 48;
            CHECK(stages.at("overdraw").values.at(0, x, y) == (inside ? 1.0f : 0.0f));
            CHECK((stages.at("triangles").values.at(1, x, y) >= 0.0f) == inside);
        }
    }
}

TEST_CASE("stages: numbers survive the way to the browser") {
    raster::Image values = raster::make_image(7, 5, 2);
    for (std::size_t i = 0; i < values.values.size(); ++i) {
        values.values[i] =
            std::ldexp(1.0f + 0.013f * static_cast<float>(i), static_cast<int>(i) - 30) * (i % 3 ? 1.0f : -1.0f);
    }
    values.values[4] = 0.0f;
    values.values[5] = 65535.0f;
    const std::vector<float> back = unpacked(tools::packed_values(values), values.values.size(), values.plane_size());
    for (std::size_t i = 0; i < back.size(); ++i) {
        CHECK(std::abs(back[i] - values.values[i]) <= std::ldexp(std::abs(values.values[i]), -16));  // 15 bits are left
    }
    CHECK(back[4] == 0.0f);
    CHECK(back[5] == 65535.0f);
}

TEST_CASE("stages: a zoom shows a covered pixel in blue and an empty one in the colour of the board") {
    const scene::Scene scene = scene::read_scene_text(
        "[image]\nsize = [64, 64]\n[camera]\nposition = [0, 0, 4]\nprojection = \"orthographic\"\nheight = 4\n"
        "[[object]]\nmesh = \"plane\"\nrotate = [90, 0, 0]\n",
        "square", "");
    const std::vector<Stage> zoom = tools::zoom_stages(scene, {14, 20, 4, 2}, 400, 200);
    REQUIRE(zoom.size() == 3);
    const raster::Image& picture = zoom[0].picture;
    CHECK(picture.width == 400);
    CHECK(picture.height == 200);
    // Left quarters of pixels 14 .. 17: away from centres and edges. The square begins at x = 16.
    const auto blue = [&](int pixel) {
        const glm::vec3 c = picture.rgb(pixel * 100 + 25, 80);
        return c.z > 1.5f * c.x;
    };
    CHECK_FALSE(blue(0));
    CHECK_FALSE(blue(1));
    CHECK(blue(2));
    CHECK(blue(3));
}

TEST_CASE("stages: the folder holds a numbered picture a stage and a page that names them all and needs no network") {
    const TempFolder folder;
    const std::vector<std::string> size = {"--set", "image.size=[48,32]", "--set", "image.samples=2"};
    std::vector<std::string> args = {"stages", "-o", "out", "--exr"};
    args.insert(args.end(), size.begin(), size.end());
    const Outcome outcome = run_kreda(args, folder.path.string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    args = {"render", "-o", "p.png"};
    args.insert(args.end(), size.begin(), size.end());
    REQUIRE(run_kreda(args, folder.path.string()).exit_code == 0);

    const std::string html = bytes_of(folder.file("out/index.html"));
    CHECK(html.find("http") == std::string::npos);
    const std::size_t begin = html.find("const page = ") + 13;
    const nlohmann::json page = nlohmann::json::parse(html.substr(begin, html.find(";\n", begin) - begin));
    CHECK(page.at("width") == 48);
    // The passes stand there as the plan lists them.
    args = {"plan", "--json"};
    args.insert(args.end(), size.begin(), size.end());
    const nlohmann::json plan = nlohmann::json::parse(run_kreda(args, folder.path.string()).out);
    std::size_t at = html.find("<details id=\"passes\">");
    for (const nlohmann::json& pass : plan.at("passes")) {
        const std::string item = "<li><b>" + pass.at("name").get<std::string>() + "</b>";
        CAPTURE(item);
        at = html.find(item, at);
        CHECK(at != std::string::npos);
    }
    const auto& stages = page.at("stages");
    CHECK(stages.size() > 15);
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const std::string picture = stages[i].at("picture");
        CAPTURE(picture);
        CHECK(std::stoul(picture.substr(0, 2)) == i + 1);
        CHECK(scene::read_image(folder.file("out/" + picture)).width == 48);
        const std::string values = stages[i].at("values");
        if (values.empty()) continue;
        const std::string script = bytes_of(folder.file("out/" + values));
        CHECK(script.rfind("kredaValues(" + std::to_string(i) + ", ", 0) == 0);
        const std::string exr = picture.substr(0, picture.size() - 3) + "exr";
        CHECK(scene::read_image(folder.file("out/" + exr)).channels ==
              static_cast<int>(stages[i].at("components").size()));
    }
    CHECK(bytes_of(folder.file("out/" + stages.back().at("picture").get<std::string>())) ==
          bytes_of(folder.file("p.png")));
    CHECK(scene::read_image(folder.file("out/contact_sheet.png")).width > 5 * 48);
}

TEST_CASE("slides: 1920 x 1080 around the very picture that render draws in that size") {
    const TempFolder folder;
    const glm::ivec2 size = tools::slide_picture_size(64, 36);
    const glm::ivec2 corner = tools::slide_picture_corner(size);
    const std::string fitting = std::to_string(size.x) + "x" + std::to_string(size.y);
    REQUIRE(run_kreda({"render", "--size", fitting, "--samples", "1", "-o", "p.png"}, folder.path.string()).exit_code ==
            0);
    const raster::Image picture = scene::read_image(folder.file("p.png"));
    for (const char* ground : {"dark", "light"}) {
        const Outcome outcome = run_kreda(
            {"render", "--size", "64x36", "--samples", "1", "--slides", ground, "-o", "s.png"}, folder.path.string());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        const raster::Image slide = scene::read_image(folder.file("s.png"));
        REQUIRE(slide.width == 1920);
        REQUIRE(slide.height == 1080);
        CHECK((slide.rgb(2, 2).x > 0.5f) == (std::string(ground) == "light"));
        int different = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) different += slide.rgb(corner.x + x, corner.y + y) != picture.rgb(x, y);
        }
        CHECK(different == 0);
    }
}

TEST_CASE("slides: an example's scene is called what its page is called") {
    const TempFolder folder;
    folder.write("docs/22_phong_terms.md", "# 22 Phong's terms\n\n## Goal\n");
    folder.write("examples/22_phong_terms/scene.toml", "");
    folder.write("examples/23_other_thing/scene.toml", "");
    CHECK(tools::title_of_scene(folder.file("examples/22_phong_terms/scene.toml")) == "22 Phong's terms");
    CHECK(tools::title_of_scene(folder.file("examples/23_other_thing/scene.toml")) == "23 other thing");
    CHECK(tools::title_of_scene(folder.file("my_scene.toml")) == "my_scene");
}

TEST_CASE("stages: what cannot be asked is refused with the remedy") {
    const TempFolder folder;
    folder.write("file", "");
    const auto refused = [&](std::vector<std::string> args, const char* remedy) {
        const Outcome outcome = run_kreda(args, folder.path.string());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(line_count(outcome.err) == 1);
        CHECK(outcome.err.find(remedy) != std::string::npos);
    };
    refused({"stages"}, "--output");
    refused({"stages", "-o", "file"}, "cannot be made");
    refused({"stages", "-o", "o", "--zoom", "1,2,3"}, "e.g. --zoom 300,140,12,8");
    refused({"stages", "-o", "o", "--zoom", "639,0,2,1"}, "inside the picture, which is 640 x 360");
    refused({"stages", "-o", "o", "--zoom", "0,0,0,1"}, "from 1 to 400");
    refused({"stages", "-o", "o", "--slides", "green"}, "expected dark or light");
    refused({"render", "--slides", "green"}, "expected dark or light");
    refused({"render", "--slides", "dark", "-o", "s.exr"}, "a slide is a .png");
    refused({"render", "--title", "T"}, "add --slides");
    CHECK(names_in(folder.path.string()) == std::vector<std::string>{"file"});
}
