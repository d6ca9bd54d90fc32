// Materials, pictures, cameras and lights of glTF files.
#include <cmath>
#include <memory>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/light_sample.hpp"
#include "scene/files/gltf_material.hpp"
#include "scene/files/load_maps.hpp"
#include "tests/scene/gltf_maker.hpp"
#include "tests/scene/raw_png.hpp"

using namespace kreda;
using namespace kreda::scene;
using namespace kreda::tests;

namespace {

const std::string kWithUv = "\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"material\":0";

/// A triangle with texture coordinates.
GltfMaker corner_with_uv() {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    maker.add(std::vector<float>{0, 0, 1, 0, 0, 1}, kFloat, 2);
    return maker;
}

/// The file's materials with their maps loaded, as a scene has them.
Scene scene_of(const LoadedMesh& loaded) {
    Scene scene;
    scene.materials = loaded.materials;
    load_maps(scene, std::vector<bool>(scene.materials.size(), true));
    return scene;
}

float texel(const lighting::Map& map, int channel = 0) {
    REQUIRE(map.texture);
    return map.texture->texels[static_cast<std::size_t>(channel)];
}

/// A picture of one pixel in the buffer of the file, and a texture of it: number 0.
std::string with_picture(GltfMaker& maker, const std::string& png, const std::string& materials) {
    const int view = maker.add_view(png);
    return ",\n\"textures\":[{\"source\":0}],\"images\":[{\"mimeType\":\"image/png\",\"bufferView\":" +
           std::to_string(view) + "}],\n\"materials\":[" + materials + "]";
}

}  // namespace

TEST_CASE("gltf: constants of a material are those of cook_torrance and the defaults are the specification's") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    const std::string materials =
        ",\"materials\":[{\"name\":\"gold\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0.75,0.25,1],"
        "\"metallicFactor\":0.5,\"roughnessFactor\":0.25},\"emissiveFactor\":[0.5,0,1],"
        "\"extensions\":{\"KHR_materials_emissive_strength\":{\"emissiveStrength\":4}}},{},"
        "{\"extensions\":{\"KHR_materials_unlit\":{}},\"pbrMetallicRoughness\":{\"baseColorFactor\":[0,1,0,1]}}]";
    const LoadedText read = load_gltf(maker.gltf(one_mesh(kPosition0 + ",\"material\":0", materials)));
    CHECK(read.warnings.empty());
    const lighting::Material& gold = read.loaded.materials.at(0);
    CHECK(gold.name == "gold");
    CHECK(gold.model == lighting::ReflectionModel::cook_torrance);
    CHECK(gold.cook_torrance.albedo == glm::vec3(1, 0.75f, 0.25f));
    CHECK(gold.cook_torrance.metallic == 0.5f);
    CHECK(gold.cook_torrance.roughness == 0.25f);
    CHECK(gold.phong.emission == glm::vec3(2, 0, 4));
    const lighting::Material& plain = read.loaded.materials.at(1);
    CHECK(plain.cook_torrance.albedo == glm::vec3(1));
    CHECK(plain.cook_torrance.metallic == 1.0f);
    CHECK(plain.cook_torrance.roughness == 1.0f);
    CHECK(read.loaded.materials.at(2).model == lighting::ReflectionModel::unlit);
    CHECK(read.loaded.materials.at(2).phong.diffuse == glm::vec3(0, 1, 0));
    CHECK(read.loaded.mesh.parts.at(0).material == 0);
}

TEST_CASE("gltf: pictures in the file are decoded and multiplied by the factors and each quantity has its channel") {
    GltfMaker maker = corner_with_uv();
    const std::string rest = with_picture(
        maker, one_pixel_png(8, 2, "\x33\x66\xcc"),  // 0.2 0.4 0.8
        "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0},\"metallicRoughnessTexture\":{\"index\":0},"
        "\"baseColorFactor\":[0.5,1,0.25,1],\"metallicFactor\":0.5,\"roughnessFactor\":0.75},"
        "\"occlusionTexture\":{\"index\":0,\"strength\":0.5},\"normalTexture\":{\"index\":0,\"scale\":2},"
        "\"emissiveTexture\":{\"index\":0},\"emissiveFactor\":[1,1,1]}");
    const LoadedText read = load_gltf(maker.glb(one_mesh(kWithUv, rest)), "a.glb");
    CHECK(read.warnings.empty());
    const Scene scene = scene_of(read.loaded);
    const lighting::MaterialMaps& maps = scene.materials.at(0).maps;
    const auto linear = [](double stored) { return std::pow((stored + 0.055) / 1.055, 2.4); };  // IEC 61966-2-1
    CHECK(texel(maps.albedo, 0) == doctest::Approx(0.5 * linear(0.2)).epsilon(1e-5));           // float's pow
    CHECK(texel(maps.albedo, 1) == doctest::Approx(linear(0.4)).epsilon(1e-5));
    CHECK(texel(maps.albedo, 2) == doctest::Approx(0.25 * linear(0.8)).epsilon(1e-5));
    CHECK(texel(maps.metallic) == doctest::Approx(0.5 * 0.8));    // blue
    CHECK(texel(maps.roughness) == doctest::Approx(0.75 * 0.4));  // green
    CHECK(texel(maps.ao) == doctest::Approx(1.0 + 0.5 * (0.2 - 1.0)));
    CHECK(texel(maps.normal, 0) == doctest::Approx(2.0 * (0x33 - 128) / 127.0));
    CHECK(texel(maps.normal, 2) == doctest::Approx((0xcc - 128) / 127.0));
    CHECK(texel(maps.emission, 1) == doctest::Approx(linear(0.4)).epsilon(1e-5));
    CHECK(maps.normal_y == lighting::NormalMapY::up);
}

TEST_CASE("gltf: pictures come from data URIs and files beside it and nowhere else") {
    const TempFolder folder;
    const std::string png = one_pixel_png(8, 2, "\xff\x80\x01");
    folder.write("in/my picture.png", png);
    folder.write("outside.png", png);
    GltfMaker maker = corner_with_uv();
    const auto file = [&](const std::string& uri) {
        return folder.write(
            "in/a.gltf",
            maker.gltf(one_mesh(kWithUv, ",\"textures\":[{\"source\":0}],\n\"images\":[{\"uri\":\"" + uri +
                                             "\"}],\n\"materials\":[{"
                                             "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}]")));
    };
    for (const std::string& uri : {std::string("my%20picture.png"), "data:image/png;base64," + base64_of(png)}) {
        CAPTURE(uri);
        const LoadedMesh loaded = load_mesh_file(file(uri));
        CHECK(loaded.warnings.empty());
        CHECK(texel(scene_of(loaded).materials.at(0).maps.albedo) == 1.0f);
    }
    CHECK(has(load_mesh_file(file("absent.png")).warnings.at(0), "a.gltf:10:11: no such image file: 'absent.png'"));
    CHECK(has(load_mesh_file(file("../outside.png")).warnings.at(0), "is outside the folder of the mesh file"));
}

TEST_CASE("gltf: pictures that are none are an error of one line") {
    for (const std::string& bytes :
         {std::string("no picture"), std::string("\x89PNG\r\n\x1a\n"), std::string("\xff\xd8\xff\xe0"),
          one_pixel_png(8, 2, "\x33\x66\xcc").substr(0, 45), std::string("\xabKTX 20\xbb")}) {
        CAPTURE(bytes.substr(0, 4));
        GltfMaker maker = corner_with_uv();
        const std::string rest =
            with_picture(maker, bytes, "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}");
        const LoadedText read = load_loose_gltf(maker.glb(one_mesh(kWithUv, rest)), "a.glb");
        try {
            (void)scene_of(read.loaded);
            FAIL("no error");
        } catch (const UserError& error) {
            CHECK(has(error.what(), "a.glb images[0]: "));
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
        }
    }
}

TEST_CASE("gltf: texture coordinates are moved and turned and scaled as KHR_texture_transform says") {
    const double quarter = std::numbers::pi / 2;
    const auto at = [](const GltfUv& how, float u, float v) { return uv_of(how, glm::vec2(u, v)); };
    CHECK(at({}, 0.25f, 0.75f) == glm::vec2(0.25f, 0.25f));
    CHECK(at({0, {0.5, 0.25}, {2, 4}, 0}, 0.25f, 0.125f) == glm::vec2(1.0f, 0.25f));
    // A quarter turn counter-clockwise, v down: right becomes up.
    CHECK(glm::distance(at({0, {0, 0}, {1, 1}, quarter}, 1, 0), glm::vec2(0, 2)) < 1e-6f);
    CHECK(glm::distance(at({0, {0, 0}, {1, 1}, quarter}, 0, 1), glm::vec2(1, 1)) < 1e-6f);
    CHECK(glm::distance(at({0, {0, 1}, {2, 1}, quarter}, 0.5f, 0), glm::vec2(0, 1)) < 1e-6f);

    GltfMaker maker = corner_with_uv();
    maker.add(std::vector<float>{0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f}, kFloat, 2);
    const std::string rest = with_picture(
        maker, one_pixel_png(8, 2, "\x33\x66\xcc"),
        "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_transform\":"
        "{\"texCoord\":1,\"offset\":[0.25,0],\"scale\":[1,0.5]}}}},\"occlusionTexture\":{\"index\":0}}");
    const LoadedText read = load_gltf(
        maker.gltf(one_mesh("\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"TEXCOORD_1\":2},\"material\":0", rest)));
    CHECK(read.loaded.mesh.uvs == std::vector<glm::vec2>(3, glm::vec2(0.75f, 0.75f)));
    CHECK(read.loaded.materials.at(0).maps.ao.file.empty());  // it would lie elsewhere
    REQUIRE(read.warnings.size() == 1);
    CHECK(has(read.warnings[0], "occlusionTextures at other texture coordinates"));
}

TEST_CASE("gltf: what is not modelled is named in one warning") {
    GltfMaker maker = corner_with_uv();
    const std::string rest =
        ",\"materials\":[{\"alphaMode\":\"BLEND\",\"extensions\":{\"KHR_materials_clearcoat\":{}}},{\"alphaMode\":"
        "\"BLEND\"}],"
        "\"animations\":[{\"channels\":[],\"samplers\":[]}],\"skins\":[{\"joints\":[0]}],"
        "\"extensionsRequired\":[\"KHR_materials_volume\"]";
    const LoadedText read = load_loose_gltf(maker.gltf(
        one_mesh("\"attributes\":{\"POSITION\":0,\"COLOR_0\":0},\"material\":0,\"targets\":[{\"POSITION\":0}]", rest,
                 "\"mesh\":0,\"skin\":0")));
    REQUIRE(read.warnings.size() == 1);
    CHECK(
        read.warnings[0] ==
        "a.gltf: not modelled, and left out: KHR_materials_volume, animations, KHR_materials_clearcoat, transparency "
        "(alphaMode 'BLEND'), skins (the mesh is drawn as it is stored), colours of vertices (COLOR_0), morph targets");
}

TEST_CASE("gltf: cameras and lights stand where their nodes are") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    // The rotation by 90 degrees about y turns -z to -x.
    const std::string text = maker.gltf(
        "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"spot\",\"color\":[1,0.5,0.25],\"intensity\":"
        "40,"
        "\"spot\":{\"innerConeAngle\":0.5,\"outerConeAngle\":0.75}},{\"type\":\"directional\",\"intensity\":3,"
        "\"range\":2},"
        "{\"type\":\"point\"}]}},\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":0.5,\"znear\":0.1,"
        "\"aspectRatio\":1.5}},{\"type\":\"orthographic\",\"orthographic\":{\"xmag\":3,\"ymag\":2,\"znear\":1,\"zfar\":"
        "9}}],"
        "\"nodes\":[{\"mesh\":0},{\"translation\":[1,2,3],\"rotation\":[0,0.70710678,0,0.70710678],\"camera\":0,"
        "\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}},{\"extensions\":{\"KHR_lights_punctual\":{\"light\":1}"
        "},"
        "\"camera\":1},{\"extensions\":{\"KHR_lights_punctual\":{\"light\":2}}},"
        "{\"extensions\":{\"KHR_lights_punctual\":{\"light\":7}}}],\"meshes\":[{\"primitives\":[{" +
        kPosition0 + "}]}]");
    keep_gltf(std::string(text).replace(text.find("\"light\":7"), 9, "\"light\":2"));
    const LoadedText read = load_loose_gltf(text);
    REQUIRE(read.loaded.cameras.size() == 2);
    const FileCamera& camera = read.loaded.cameras[0];
    CHECK(camera.position == glm::dvec3(1, 2, 3));
    CHECK(glm::distance(camera.forward, glm::dvec3(-1, 0, 0)) < 1e-7);
    CHECK(camera.up == glm::dvec3(0, 1, 0));
    CHECK(camera.vertical_fov_deg == doctest::Approx(0.5 * 180 / std::numbers::pi));
    CHECK(camera.aspect == 1.5);
    CHECK(camera.far == 0.0);
    CHECK(read.loaded.cameras[1].projection == raster::Projection::orthographic);
    CHECK(read.loaded.cameras[1].height == 4.0);  // ymag is half of it
    REQUIRE(read.loaded.lights.size() == 3);
    const FileLight& spot = read.loaded.lights[0];
    CHECK(spot.light.type == lighting::LightType::spot);
    CHECK(spot.position == glm::dvec3(1, 2, 3));
    CHECK(glm::distance(spot.light.direction, glm::vec3(-1, 0, 0)) < 1e-6f);
    CHECK(spot.light.outer_cone_deg == doctest::Approx(0.75 * 180 / std::numbers::pi));
    // 40 candela at 2 metres are 10 lux.
    CHECK(spot.light.intensity * lighting::attenuate(spot.light.attenuation, 2.0f) == 10.0f);
    CHECK(read.loaded.lights[1].light.type == lighting::LightType::directional);
    CHECK(read.loaded.lights[1].light.intensity == 3.0f);
    CHECK(read.loaded.lights[2].light.intensity == 1.0f);
    REQUIRE(read.warnings.size() == 2);
    CHECK(has(read.warnings[0], "nodes[4]: its light"));
    CHECK(has(read.warnings[1], "ranges of lights"));
}
