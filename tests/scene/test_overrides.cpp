#include <doctest/doctest.h>

#include "scene/files/overrides.hpp"
#include "scene/files/read_scene.hpp"

using namespace kreda::scene;

namespace {

const std::string kScene = R"([camera]
near = 0.5
[[light]]
intensity = 1
[[light]]
[[material]]
name = "gold"
[[material]]
name = "v1.2"
[[object]]
mesh = "cube"
)";

Scene read_with(const std::vector<std::string>& overrides, const std::string& text = kScene) {
    ReadOptions options;
    options.overrides = overrides;
    return read_scene_text(text, "s.toml", ".", options);
}

std::string complaint(const std::string& override) {
    try {
        const Scene scene = read_with({override});
    } catch (const UserError& error) { return error.what(); }
    return "no complaint";
}

}  // namespace

TEST_CASE("An override replaces a value or adds it") {
    CHECK(read_with({"camera.near=0.25"}).camera.near == 0.25f);
    CHECK(read_with({"camera.position=[0,1,9]"}).camera.position == glm::vec3(0.0f, 1.0f, 9.0f));
    CHECK(read_with({" camera.near = 0.25 "}).camera.near == 0.25f);
    CHECK(read_with({"camera.near=0.25", "camera.near=0.75"}).camera.near == 0.75f);
    CHECK(read_with({"camera.near=0.25"}).camera.far == 100.0f);
}

TEST_CASE("An override adds a table that the file lacks") {
    CHECK(read_with({"image.size=[7,8]"}).image.height == 8);
    CHECK(read_with({"fog.mode=exp"}, "").fog.mode == kreda::lighting::FogMode::exp);
}

TEST_CASE("Of a file and a sky the one that is set last gives the light") {
    const auto keys_after = [](const std::vector<std::string>& overrides) {
        Value root = parse_toml("[environment]\nsky = \"studio\"\nintensity = 2.0\n", "s.toml");
        apply_overrides(root, overrides);
        std::string keys;
        for (const Value& item : root.items.front().items) keys += item.key + " ";
        return keys;
    };
    CHECK(keys_after({"environment.file=a.hdr"}) == "intensity file ");
    CHECK(keys_after({"environment.file=a.hdr", "environment.sky=sunset"}) == "intensity sky ");
    CHECK(keys_after({"environment.intensity=3"}) == "sky intensity ");
}

TEST_CASE("Words and file names need no quotes in an override") {
    CHECK(read_with({"shading.frequency=gouraud"}).shading.frequency == ShadingFrequency::gouraud);
    CHECK(read_with({"shading.frequency=\"flat\""}).shading.frequency == ShadingFrequency::flat);
    CHECK(read_with({"light.0.on=false"}).lights[0].on == false);
    CHECK(read_with({"object.0.mesh=plane"}).objects[0].mesh_name == "plane");
    CHECK(complaint("object.0.mesh=../x y.obj") ==
          "--set object.0.mesh=../x y.obj: there is no mesh file '../x y.obj'; known built-in meshes: cube, sphere, "
          "torus, torus_knot, plane, teapot, terrain");
}

TEST_CASE("Lights and objects go by number and materials by name or number") {
    CHECK(read_with({"light.0.intensity=2"}).lights[0].intensity == 2.0f);
    CHECK(read_with({"light.1.intensity=3"}).lights[1].intensity == 3.0f);
    CHECK(read_with({"material.gold.shininess=8"}).materials[0].phong.shininess == 8.0f);
    CHECK(read_with({"material.v1.2.shininess=9"}).materials[1].phong.shininess == 9.0f);
    CHECK(read_with({"material.1.shininess=9"}).materials[1].phong.shininess == 9.0f);
    const Scene moved = read_with({"object.0.translate=[1,2,3]"});
    CHECK(moved.objects[0].world_from_object[3] == glm::vec4(1.0f, 2.0f, 3.0f, 1.0f));
    CHECK(read_with({"object.0.material=gold"}).objects[0].part_material.at(0) == 0);
}

TEST_CASE("A complaint about an override quotes it") {
    CHECK(complaint("camera.nera=1") == "--set camera.nera=1: unknown key 'nera' in [camera]; did you mean 'near'?");
    CHECK(complaint("camera.near=-1") ==
          "--set camera.near=-1: 'near' in [camera] is -1; expected a number > 0, e.g. near = 0.1");
    CHECK(complaint("camera.up=[0,x,0]").substr(0, 25) == "--set camera.up=[0,x,0]: ");
    CHECK(complaint("camera.up=[0,1").substr(0, 22) == "--set camera.up=[0,1: ");
    CHECK(complaint("camra.near=1") == "--set camra.near=1: unknown table 'camra'; did you mean 'camera'?");
    CHECK(complaint("light.2.on=true") == "--set light.2.on=true: there is no light '2'; the scene has 0 to 1");
    CHECK(complaint("light.on=true") == "--set light.on=true: which one? write light.0.on");
    CHECK(complaint("material.glod.shininess=1") ==
          "--set material.glod.shininess=1: there is no material 'glod'; did you mean 'gold'?");
}

TEST_CASE("An override that is not TABLE.KEY=VALUE says what is") {
    const std::string forms = "; expected TABLE.KEY=VALUE, light.0.KEY=VALUE or material.NAME.KEY=VALUE";
    CHECK(complaint("camera.near") == "--set camera.near: there is no '='" + forms);
    CHECK(complaint("near=1") == "--set near=1: there is no '.' before the '='" + forms);
    CHECK(complaint("camera.=1") == "--set camera.=1: there is no key" + forms);
    CHECK(complaint("camera.near=") == "--set camera.near=: there is no value" + forms);
    CHECK(complaint("camera.near.x=1") == "--set camera.near.x=1: too many dots" + forms);
    CHECK(complaint("camera.near=1\nfar=2").substr(0, 26) == "--set camera.near=1?far=2:");
}

TEST_CASE("An override cannot mend a table that is no table") {
    CHECK_THROWS_AS(read_with({"camera.near=1"}, "camera = 3\n"), UserError);
    CHECK_THROWS_AS(read_with({"light.0.on=true"}, "light = [3]\n"), UserError);
}
