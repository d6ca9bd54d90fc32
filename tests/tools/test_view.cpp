// The viewer behind the page of `kreda view`, without a browser: the same functions, compiled natively.
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "scene/files/image_file.hpp"
#include "scene/files/overrides.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/files/scene_keys.hpp"
#include "scene/files/toml_check.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/keys_json.hpp"
#include "tools/view/scene_text.hpp"
#include "tools/view/view_page.hpp"
#include "tools/view/viewer.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::tools;

namespace {

constexpr const char* kViewedScene = R"(
[image]
size = [48, 27]
[camera]
position = [0.1, 0.7, 2.0]
[[light]]
direction = [-1, -2, -1]
[[light]]
type = "point"
position = [1, 1, 1]
intensity = 0.1
[[material]]
name = "red \"paint\""
diffuse = [0.7, 0.123456789, 0.1]
[[object]]
mesh = "teapot"
detail = 4
material = "red \"paint\""
)";

constexpr const char* kMesh = "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";

bool has_file(const CarriedScene& scene, const std::string& name) {
    for (const CarriedFile& file : scene.files) {
        if (file.name == name) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("the viewer draws the film of kreda render, after its size and camera came and went") {
    const TempFolder folder;
    folder.write("a.toml", kViewedScene);
    Viewer viewer;
    open_scene(viewer, folder.file("a.toml"), {});
    set_size(viewer, 48, 27, 1);
    draw(viewer);
    const raster::Image expected = render(scene::read_scene(folder.file("a.toml")));
    CHECK(viewer.buffers.film.values == expected.values);
    set_size(viewer, 30, 20, 2);
    move_camera(viewer, {{1.0, 2.0, 2.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
    draw(viewer);
    CHECK(viewer.buffers.film.values != expected.values);
    open_scene(viewer, folder.file("a.toml"), {"light.0.on=false"});
    draw(viewer);
    const scene::ReadOptions without{.overrides = {"light.0.on=false"}};
    CHECK(viewer.buffers.film.values == render(scene::read_scene(folder.file("a.toml"), without)).values);
}

TEST_CASE("a change of a key reads no file again; a changed file is read again") {
    const TempFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("a.toml", "[[light]]\n[[material]]\n[[object]]\nmesh = \"a.obj\"\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(60));  // newer files may change within their time's step
    Viewer viewer;
    open_scene(viewer, folder.file("a.toml"), {});
    const int reads = viewer.files.reads;
    CHECK(reads > 0);
    open_scene(viewer, folder.file("a.toml"), {"material.0.shininess=3"});
    open_scene(viewer, folder.file("a.toml"), {"material.0.shininess=3", "light.0.intensity=2"});
    CHECK(viewer.files.reads == reads);
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 1 1\nf 1 2 3\n");
    open_scene(viewer, folder.file("a.toml"), {});
    CHECK(viewer.files.reads > reads);
}

TEST_CASE("the screen shows the bytes of the PNG, whatever the exposure and the transfer function are") {
    const TempFolder folder;
    folder.write("a.toml", kViewedScene);
    Viewer viewer;
    for (const char* change : {"image.exposure=3", "image.tone_map=reinhard", "image.transfer=linear"}) {
        open_scene(viewer, folder.file("a.toml"), {change});
        draw(viewer);
        const raster::Image encoded = develop(viewer.buffers.film, film_settings(viewer.scene.image));
        std::size_t differ = 0;
        for (std::size_t i = 0; i < encoded.plane_size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                differ +=
                    viewer.picture.rgba[4 * i + c] != scene::byte_from_encoded(encoded.plane(static_cast<int>(c))[i]);
            }
        }
        CHECK(differ == 0);
    }
}

TEST_CASE("the screen shows opaque pixels of the picture, and of every view that the scene can show") {
    const TempFolder folder;
    folder.write("a.toml", kViewedScene);
    Viewer viewer;
    open_scene(viewer, folder.file("a.toml"), {"light.0.shadow=true", "shadow.size=32"});
    int shown = 0;
    const auto described = describe(viewer);
    for (const auto& view : described["views"]) {
        const std::string name = view["name"];
        CAPTURE(name);
        choose_view(viewer, name);
        if (view.contains("requires")) {
            CHECK_THROWS_AS(draw(viewer), scene::UserError);
            continue;
        }
        ++shown;
        draw(viewer);
        REQUIRE(viewer.picture.rgba.size() ==
                std::size_t{4} * std::size_t(viewer.picture.width) * std::size_t(viewer.picture.height));
        CHECK(viewer.picture.rgba[3] == 255);
    }
    CHECK(shown > 10);
    CHECK_THROWS_AS(choose_view(viewer, "no_such_view"), scene::UserError);
}

TEST_CASE("what cannot be read leaves the viewer as it was, with the line that kreda prints") {
    const TempFolder folder;
    folder.write("a.toml", kViewedScene);
    folder.write("bad.toml", "[camera]\nnaer = 1\n");
    Viewer viewer;
    open_scene(viewer, folder.file("a.toml"), {});
    std::string line;
    try {
        open_scene(viewer, folder.file("bad.toml"), {});
    } catch (const scene::UserError& error) { line = error.what(); }
    CHECK(line + "\n" == run_kreda({"render", folder.file("bad.toml")}, folder.path.string()).err);
    CHECK(viewer.path == folder.file("a.toml"));
    CHECK(viewer.scene.lights.size() == 2);
}

TEST_CASE("n, l, v, h and r start at the explained point and are drawn in their true directions") {
    const TempFolder folder;
    folder.write("a.toml", kViewedScene);
    Viewer viewer;
    open_scene(viewer, folder.file("a.toml"), {});
    const auto told = explain_on_screen(viewer, 24, 13);
    CHECK(std::string(told["text"]).find("Pixel (24, 13)") == 0);
    const auto& arrows = told["vectors"];
    REQUIRE(arrows.size() == 8);        // n, v, and three of each of two lights
    for (const auto& arrow : arrows) {  // from the middle of the pixel that was asked for
        CHECK(double(arrow["from"][0]) == doctest::Approx(24.5).epsilon(0.01));
        CHECK(double(arrow["from"][1]) == doctest::Approx(13.5).epsilon(0.01));
    }
    // v leads to the eye: on the screen it has no length.
    CHECK(std::abs(double(arrows[1]["to"][0]) - 24.5) < 0.3);
    CHECK(std::abs(double(arrows[1]["to"][1]) - 13.5) < 0.3);
    CHECK(explain_on_screen(viewer, 0, 0)["vectors"].empty());  // the background
}

TEST_CASE("a saved scene file holds the same values to the last bit, and the changes") {
    scene::Value root = scene::parse_toml(kViewedScene, "a");
    scene::check_tables(root);
    scene::apply_overrides(root, {"light.1.intensity=0.30000000000000004", "fog.mode=exp", "light.0.on=false"});
    const std::string text = text_of_scene(root);
    const scene::Value again = scene::parse_toml(text, "b");
    CHECK(as_json(again) == as_json(root));
    CHECK(as_json(again)["light"][1]["intensity"] == 0.30000000000000004);
    CHECK(as_json(again)["fog"]["mode"] == "exp");
    CHECK_NOTHROW(scene::read_scene_text(text, "b", ""));
}

TEST_CASE("kreda keys --json has every key with what may be written") {
    const TempFolder folder;
    const Outcome printed = run_kreda({"keys", "--json"}, folder.path.string());
    REQUIRE(printed.exit_code == 0);
    const auto keys = nlohmann::ordered_json::parse(printed.out);
    REQUIRE(keys.size() == scene::scene_keys().size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const scene::KeyInfo& info = scene::scene_keys()[i];
        CAPTURE(info.key);
        CHECK(keys[i]["key"] == info.key);
        CHECK(keys[i]["words"].size() == info.words.size());
        CHECK(keys[i]["default"].is_null() == info.default_value.empty());
    }
}

TEST_CASE("the page carries meshes, their materials and their maps under names that lead to them") {
    const TempFolder folder;
    std::filesystem::create_directories(folder.path / "meshes");
    std::filesystem::create_directories(folder.path / "scenes");
    folder.write("meshes/a.obj", kMesh);
    folder.write("meshes/paint.mtl", "newmtl red\nKd 1 0 0\n");
    folder.write("scenes/a.toml", "[[light]]\n[[object]]\nmesh = \"../meshes/a.obj\"\n");
    const std::string path = folder.file("scenes/a.toml");
    scene::LoadedFiles loaded;
    scene::ReadOptions options;
    options.files = &loaded;
    const CarriedScene carried = files_of_scene(scene::read_scene(path, options), path, loaded);
    CHECK(carried.path == "a.toml");
    CHECK(carried.folder == "up");
    CHECK(carried.files.size() == 3);
    for (const char* name : {"up/a.toml", "meshes/a.obj", "meshes/paint.mtl"}) {
        CAPTURE(name);
        CHECK(has_file(carried, name));
    }
    CHECK(files_of_scene(scene::read_scene_text(scene::built_in_scene_text(), "built-in", ""), "", {}).files.empty());
}

TEST_CASE("nothing in a scene ends the script that holds it") {
    const TempFolder folder;
    folder.write("a.toml", kViewedScene);
    const CarriedScene scene{"</script><b>.toml", "", {{"</script>", folder.file("a.toml")}}};
    const std::string page =
        page_with_scene("<script>/*SCENE*/</script>", scene, {{"material.</script>.shininess=1"}, {"</script>"}});
    CHECK(page.find("</script") == page.rfind("</script"));
    CHECK(page.find("/*SCENE*/") == std::string::npos);
}

TEST_CASE("without the page kreda view says what to build, and a wrong name is refused first") {
    CHECK_THROWS_WITH_AS(static_cast<void>(read_view_page({"/nonexistent/view.html"})),
                         doctest::Contains("./course view"), scene::UserError);
    const TempFolder folder;
    const Outcome wrong = run_kreda({"view", "-o", "page.png"}, folder.path.string());
    CHECK(wrong.exit_code == 2);
    CHECK(wrong.err == "page.png: a page is written as .html; end the name with it\n");
    CHECK(names_in(folder.path.string()).empty());
}
