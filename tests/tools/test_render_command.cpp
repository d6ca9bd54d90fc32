// What `kreda render` and `kreda plan` do with good input.
#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/render_output.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// A unit square that fills the view of an orthographic camera: every pixel is shaded, and the colour is known.
void write_full_view(const TempFolder& folder, const std::string& more = "") {
    folder.write("square.obj", "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n");
    folder.write(
        "square.toml",
        "[image]\nsize = [24, 16]\n"
        "[camera]\nposition = [0, 0, 4]\nprojection = \"orthographic\"\nheight = 2\n" +
            more +
            "[[material]]\nname = \"m\"\nmodel = \"unlit\"\nemission = [0.25, 0.5, 0.75]\ndiffuse = [0.25, 0.5, 0.75]\n"
            "[[object]]\nmesh = \"square.obj\"\nmaterial = \"m\"\n");
}

/// A lit shape with some curvature: many different values in the picture.
void write_sphere(const TempFolder& folder, const std::string& more = "") {
    folder.write("sphere.toml",
                 "[image]\nsize = [48, 32]\n[camera]\nposition = [0, 0, 3]\n[[light]]\nintensity = 0.9\n" + more +
                     "[[object]]\nmesh = \"sphere\"\ndetail = 16\n");
}

/// IEC 61966-2-1 with the standard library's pow in double: an independent copy of the formula.
double srgb_encoded(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

std::string render(const TempFolder& folder, std::vector<std::string> args) {
    args.insert(args.begin(), "render");
    const Outcome outcome = run_kreda(args, folder.path.string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
}

}  // namespace

TEST_CASE("render without a scene: the built-in one in the size that is asked for") {
    const TempFolder folder;
    CHECK(render(folder, {"--size", "40x30", "--samples", "1"}).empty());
    const raster::Image picture = scene::read_image(folder.file("built_in.png"));
    CHECK(picture.width == 40);
    CHECK(picture.height == 30);
    CHECK(picture.channels == 3);
    CHECK(*std::max_element(picture.values.begin(), picture.values.end()) >
          *std::min_element(picture.values.begin(), picture.values.end()));
}

TEST_CASE("render names the picture after the scene and puts it into the current folder") {
    const TempFolder folder;
    folder.write("deep/scene.toml", "[image]\nsize = [8, 4]\n");
    render(folder, {"deep/scene.toml"});
    CHECK(names_in(folder.path.string()) == std::vector<std::string>{"deep", "scene.png"});
}

TEST_CASE("the PNG is the EXR: clamped and encoded as sRGB and rounded to 8 bits") {
    const TempFolder folder;
    write_sphere(folder);
    render(folder, {"sphere.toml", "-o", "s.png"});
    render(folder, {"sphere.toml", "-o", "s.exr"});
    const raster::Image png = scene::read_image(folder.file("s.png"));
    const raster::Image exr = scene::read_image(folder.file("s.exr"));
    REQUIRE(png.values.size() == exr.values.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < png.values.size(); ++i) {
        worst = std::max(worst, std::abs(255.0 * png.values[i] - 255.0 * srgb_encoded(exr.values[i])));
    }
    CHECK(worst <= 0.501);  // half a step of 8 bits, and 1e-3 for single precision
    CHECK(raster::count_non_finite(exr) == 0);
}

TEST_CASE("an EXR holds radiance: neither exposure nor tone map nor transfer touch it") {
    const TempFolder folder;
    write_sphere(folder);
    render(folder, {"sphere.toml", "-o", "a.exr"});
    render(folder, {"sphere.toml", "-o", "b.exr", "--set", "image.exposure=3", "--set", "image.tone_map=\"reinhard\"",
                    "--set", "image.transfer=\"linear\""});
    CHECK(bytes_of(folder.file("a.exr")) == bytes_of(folder.file("b.exr")));
}

TEST_CASE("time prints one line of JSON whose counts are those of a view filled by two triangles") {
    const TempFolder folder;
    write_full_view(folder);
    const std::string out = render(folder, {"square.toml", "--time", "--threads", "2"});
    CHECK(line_count(out) == 1);
    const nlohmann::json json = nlohmann::json::parse(out);
    CHECK(json.at("triangles") == 2);
    CHECK(json.at("pixels_shaded") == 24 * 16);
    CHECK(json.at("width") == 24);
    CHECK(json.at("height") == 16);
    CHECK(json.at("threads") == 2);
    CHECK(json.at("frames") == 1);
    CHECK(json.at("culled") == 0);
    CHECK(json.at("degenerate") == 0);
    CHECK(json.at("non_finite") == 0);
    double sum = 0.0;
    for (const auto& stage : json.at("stages")) {
        CHECK(stage.get<double>() >= 0.0);
        sum += stage.get<double>();
    }
    CHECK(json.at("stages").contains("vertices"));
    CHECK(json.at("stages").contains("visibility"));
    // The stages are parts of the whole and of the encoding in 8 bits, which is counted apart; each is rounded to a
    // microsecond, a dozen of them at most.
    const double whole = json.at("total_ms").get<double>() + json.at("around").at("encoding").get<double>();
    CHECK(sum <= whole + 0.013);
}

TEST_CASE("four samples a pixel are four times the shading and the same flat colour") {
    const TempFolder folder;
    write_full_view(folder);
    const auto json =
        nlohmann::json::parse(render(folder, {"square.toml", "--time", "--samples", "2", "-o", "four.exr"}));
    CHECK(json.at("pixels_shaded") == 4 * 24 * 16);
    render(folder, {"square.toml", "-o", "one.exr"});
    CHECK(scene::read_image(folder.file("four.exr")).values == scene::read_image(folder.file("one.exr")).values);
}

TEST_CASE("repeat draws the same picture again and again") {
    const TempFolder folder;
    write_sphere(folder);
    const auto json = nlohmann::json::parse(render(folder, {"sphere.toml", "--time", "--repeat", "4", "-o", "a.exr"}));
    CHECK(json.at("frames") == 4);
    render(folder, {"sphere.toml", "-o", "b.exr"});
    CHECK(bytes_of(folder.file("a.exr")) == bytes_of(folder.file("b.exr")));
}

TEST_CASE("the number of threads does not change a bit") {
    const TempFolder folder;
    write_sphere(folder);
    render(folder, {"sphere.toml", "--threads", "1", "--samples", "4", "-o", "a.exr"});
    render(folder, {"sphere.toml", "--threads", "7", "--samples", "4", "-o", "b.exr"});
    CHECK(bytes_of(folder.file("a.exr")) == bytes_of(folder.file("b.exr")));
}

TEST_CASE("the command line wins over the file") {
    const TempFolder folder;
    folder.write("scene.toml", "[image]\nsize = [8, 4]\nbackground = [1, 0, 0]\n");
    render(folder, {"scene.toml", "--set", "image.background=[0, 0.5, 1]", "--size", "5x3", "-o", "p.exr"});
    const raster::Image picture = scene::read_image(folder.file("p.exr"));
    CHECK(picture.width == 5);
    CHECK(picture.height == 3);
    CHECK(picture.rgb(4, 2) == glm::vec3(0.0f, 0.5f, 1.0f));
}

TEST_CASE("what is wrong but not fatal is a line of warning each") {
    const TempFolder folder;
    folder.write("a.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("scene.toml", "[image]\nsize = [8, 4]\n[[object]]\nmesh = \"a.obj\"\n");
    const Outcome outcome = run_kreda({"render", "scene.toml"}, folder.path.string());
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.rfind("warning: ", 0) == 0);
    CHECK(outcome.err.find("none.mtl") != std::string::npos);
}

TEST_CASE("a view is a picture of its own and an EXR of its numbers") {
    const TempFolder folder;
    write_full_view(folder);
    render(folder, {"square.toml", "--view", "position", "-o", "p.exr"});
    const raster::Image position = scene::read_image(folder.file("p.exr"));
    CHECK(position.rgb(0, 0).y == doctest::Approx(1.0 - 1.0 / 16.0).epsilon(1e-5));  // the centre of the upper row
    render(folder, {"square.toml", "--view", "depth", "-o", "d.png"});
    CHECK(scene::read_image(folder.file("d.png")).channels == 1);
}

TEST_CASE("a view that is not there or not in the scene is an error that says what to do") {
    const TempFolder folder;
    write_sphere(folder);
    const Outcome typo = run_kreda({"render", "sphere.toml", "--view", "normals"}, folder.path.string());
    CHECK(typo.exit_code == 2);
    CHECK(typo.err.find("did you mean normal?") != std::string::npos);
    const Outcome absent = run_kreda({"render", "sphere.toml", "--view", "roughness"}, folder.path.string());
    CHECK(absent.exit_code == 2);
    CHECK(absent.err.find("cook_torrance") != std::string::npos);
    CHECK(names_in(folder.path.string()) == std::vector<std::string>{"sphere.toml"});
}

/// A square over a floor under three lights, two of which cast shadows.
void write_two_shadows(const TempFolder& folder) {
    folder.write("lights.toml",
                 "[image]\nsize = [24, 16]\n[camera]\nposition = [0, 6, 5]\n[shadow]\nsize = 32\n"
                 "[[light]]\ntype = \"point\"\nposition = [0, 3, 0]\nshadow = true\n"
                 "[[light]]\ndirection = [0.2, -1, 0]\nshadow = true\n[[light]]\ndirection = [-0.2, -1, 0.1]\n"
                 "[[object]]\nmesh = \"plane\"\nscale = 4\n"
                 "[[object]]\nmesh = \"plane\"\nscale = 0.5\ntranslate = [0, 1, 0]\n");
}

TEST_CASE("a light's depth is a picture of the size of its map and its EXR holds distances") {
    const TempFolder folder;
    write_two_shadows(folder);
    render(folder, {"lights.toml", "--view", "light_depth", "-o", "sun.png"});
    CHECK(scene::read_image(folder.file("sun.png")).width == 32);  // the last that casts shadows
    render(folder, {"lights.toml", "--view", "light_depth", "--light", "0", "-o", "lamp.exr"});
    const raster::Image lamp = scene::read_image(folder.file("lamp.exr"));
    CHECK(lamp.width == 6 * 32);
    CHECK(lamp.height == 32);
    CHECK(raster::count_non_finite(lamp) == 0);
    CHECK(*std::min_element(lamp.values.begin(), lamp.values.end()) == doctest::Approx(2.0).epsilon(1e-5));
    render(folder, {"lights.toml", "--view", "light_depth", "--slides", "dark", "-o", "slide.png"});
    CHECK(scene::read_image(folder.file("slide.png")).width == 1920);
}

TEST_CASE("a light's depth that is not there is an error that says why") {
    const TempFolder folder;
    write_two_shadows(folder);
    const auto refused = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", "lights.toml", "--view", "light_depth"});
        const Outcome outcome = run_kreda(more, folder.path.string());
        CHECK(outcome.exit_code == 2);
        CHECK(line_count(outcome.err) == 1);
        return outcome.err;
    };
    CHECK(refused({"--light", "2"}).find("no light that is on has shadow = true") != std::string::npos);
    CHECK(refused({"--set", "shadow.method=\"exact\""}).find("shadow.method = \"map\"") != std::string::npos);
    CHECK(refused({"--light", "3"}).find("--light 3: the scene has 3 lights, numbered from 0") != std::string::npos);
    CHECK(refused({"--set", "object.1.casts_shadow=false"}).find("nothing can cast") != std::string::npos);
    CHECK(names_in(folder.path.string()) == std::vector<std::string>{"lights.toml"});
}

TEST_CASE("a light's depth in which nothing casts is white and says so") {
    const TempFolder folder;  // a single texel a face, and along no axis does the lamp see the sphere
    folder.write("aside.toml",
                 "[image]\nsize = [32, 24]\n[shadow]\nsize = 1\n[[light]]\ntype = \"point\"\nposition = [2, 3, 2]\n"
                 "shadow = true\n[[object]]\nmesh = \"sphere\"\n");
    const Outcome outcome =
        run_kreda({"render", "aside.toml", "--view", "light_depth", "-o", "aside.png"}, folder.path.string());
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.find("inf") == std::string::npos);
    CHECK(outcome.err.find("all of it is background") != std::string::npos);
    for (const float value : scene::read_image(folder.file("aside.png")).values) CHECK(value == 1.0f);
}

TEST_CASE("one light alone is the scene with the others off") {
    const TempFolder folder;
    write_two_shadows(folder);
    render(folder, {"lights.toml", "--light", "1", "-o", "a.exr"});
    render(folder, {"lights.toml", "--set", "light.0.on=false", "--set", "light.2.on=false", "-o", "b.exr"});
    CHECK(bytes_of(folder.file("a.exr")) == bytes_of(folder.file("b.exr")));
}

TEST_CASE("plan prints what a scene requires and nothing else") {
    const TempFolder folder;
    write_sphere(folder, "[fog]\nmode = \"exp\"\n");
    const std::string foggy = run_kreda({"plan", "sphere.toml"}, folder.path.string()).out;
    CAPTURE(foggy);
    const std::size_t vertices = foggy.find(". vertices: "), visibility = foggy.find(". visibility: ");
    const std::size_t light = foggy.find(". light pixels: "), fog = foggy.find("fog at pixels: "),
                      film = foggy.find(". film: ");
    CHECK(vertices < visibility);
    CHECK(visibility < light);
    CHECK(light < fog);
    CHECK(fog < film);
    CHECK(film != std::string::npos);
    const std::string film_lines =
        tools::kBuiltForDebugger
            ? "film: one sample a pixel\n     linear RGB: " + std::to_string(48 * 32 * 12) + " bytes"
            : "film: one sample a pixel, tone-mapped and encoded in its tile\n     8-bit RGB: " +
                  std::to_string(48 * 32 * 3) + " bytes";
    CHECK(foggy.find(film_lines) != std::string::npos);
    const std::string clear =
        run_kreda({"plan", "sphere.toml", "--set", "fog.mode=\"none\""}, folder.path.string()).out;
    CHECK(clear.find("fog") == std::string::npos);
    CHECK(names_in(folder.path.string()) == std::vector<std::string>{"sphere.toml"});
}

TEST_CASE("plan says why not") {
    const TempFolder folder;
    write_sphere(folder);
    const std::string text = run_kreda({"plan", "sphere.toml", "--why-not"}, folder.path.string()).out;
    CAPTURE(text);
    CHECK(text.find("fog: left out, fog.mode = \"none\"") != std::string::npos);
    CHECK(text.find("light vertices: left out") != std::string::npos);
}
