#include <doctest/doctest.h>

#include "lighting/spectrum.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/files/scene_keys.hpp"

using namespace kreda;
using namespace kreda::scene;

namespace {

Scene read_text(const std::string& text) {
    return read_scene_text(text, "s.toml", ".");
}

}  // namespace

TEST_CASE("An empty scene file is an empty scene with the documented defaults") {
    const Scene scene = read_text("");
    CHECK(scene.file == "s.toml");
    CHECK(scene.lights.empty());
    CHECK(scene.objects.empty());
    CHECK(scene.image.width == 640);
    CHECK(scene.image.height == 360);
    CHECK(scene.image.samples == 1);
    CHECK(scene.image.background == glm::vec3(0.0f));
    CHECK(scene.image.exposure == 1.0f);
    CHECK(scene.image.tone_map == ToneMap::none);
    CHECK(scene.image.white == 4.0f);
    CHECK(scene.image.transfer == Transfer::srgb);
    CHECK(scene.image.gamma == 2.2f);
    CHECK(scene.camera.position == glm::vec3(0.0f, 1.0f, 4.0f));
    CHECK(scene.camera.target == glm::vec3(0.0f));
    CHECK(scene.camera.up == glm::vec3(0.0f, 1.0f, 0.0f));
    CHECK(scene.camera.projection == raster::Projection::perspective);
    CHECK(scene.camera.vertical_fov_deg == 45.0f);
    CHECK(scene.camera.height == 2.0f);
    CHECK(scene.camera.near == 0.1f);
    CHECK(scene.camera.far == 100.0f);
    CHECK(scene.shading.frequency == ShadingFrequency::phong);
    CHECK(scene.shading.interpolation == Interpolation::perspective);
    CHECK(scene.shading.cull == raster::CullMode::back);
    CHECK(scene.ambient == glm::vec3(0.05f));
    CHECK(scene.fog.mode == lighting::FogMode::none);
    CHECK(scene.fog.color == glm::vec3(0.6f, 0.65f, 0.7f));
    CHECK(scene.fog.start == 5.0f);
    CHECK(scene.fog.end == 30.0f);
    CHECK(scene.fog.density == 0.1f);
    CHECK(scene.fog.distance == lighting::FogDistance::radial);
    CHECK(scene.fog.frequency == lighting::FogFrequency::pixel);
}

TEST_CASE("An empty light and an empty material have the documented defaults") {
    const Scene scene = read_text("[[light]]\n[[material]]\n");
    REQUIRE(scene.lights.size() == 1);
    const lighting::Light& light = scene.lights[0];
    CHECK(light.type == lighting::LightType::directional);
    CHECK(light.direction == glm::vec3(-1.0f, -2.0f, -1.0f));
    CHECK(light.position == glm::vec3(2.0f, 3.0f, 1.0f));
    CHECK(light.color == glm::vec3(1.0f));
    CHECK(light.intensity == 1.0f);
    CHECK(light.attenuation.constant == 1.0f);
    CHECK(light.attenuation.linear == 0.0f);
    CHECK(light.attenuation.quadratic == 0.0f);
    CHECK(light.inner_cone_deg == 20.0f);
    CHECK(light.outer_cone_deg == 30.0f);
    CHECK_FALSE(light.shadow);
    CHECK(light.on);
    REQUIRE(scene.materials.size() == 1);
    const lighting::Material& material = scene.materials[0];
    CHECK(material.name == "default");
    CHECK(material.model == lighting::ReflectionModel::blinn_phong);
    CHECK(material.phong.ambient == glm::vec3(0.1f));
    CHECK(material.phong.diffuse == glm::vec3(0.7f));
    CHECK(material.phong.specular == glm::vec3(0.3f));
    CHECK(material.phong.emission == glm::vec3(0.0f));
    CHECK(material.phong.shininess == 32.0f);
}

TEST_CASE("Writing every default out changes nothing") {
    std::string text;
    for (const std::string& table : table_names()) {
        text += table_title(table) + "\n";
        if (table == "object") text += "mesh = \"cube\"\n";
        if (table == "environment") text += "sky = \"studio\"\n";  // it must be one or the other
        for (const KeyInfo& info : scene_keys()) {
            if (info.table != table || info.default_value.empty()) continue;
            text += std::string(info.key) + " = " + std::string(info.default_value) + "\n";
        }
    }
    CAPTURE(text);
    const Scene written = read_text(text);
    const Scene implied = read_text("[[light]]\n[[material]]\n[[object]]\nmesh = \"cube\"\n");
    CHECK(written.image.width == implied.image.width);
    CHECK(written.image.exposure == implied.image.exposure);
    CHECK(written.image.white == implied.image.white);
    CHECK(written.image.gamma == implied.image.gamma);
    CHECK(written.camera.position == implied.camera.position);
    CHECK(written.camera.target == implied.camera.target);
    CHECK(written.camera.vertical_fov_deg == implied.camera.vertical_fov_deg);
    CHECK(written.camera.height == implied.camera.height);
    CHECK(written.camera.near == implied.camera.near);
    CHECK(written.camera.far == implied.camera.far);
    CHECK(written.ambient == implied.ambient);
    CHECK(written.fog.color == implied.fog.color);
    CHECK(written.fog.start == implied.fog.start);
    CHECK(written.fog.end == implied.fog.end);
    CHECK(written.fog.density == implied.fog.density);
    CHECK(written.lights[0].direction == implied.lights[0].direction);
    CHECK(written.lights[0].position == implied.lights[0].position);
    CHECK(written.lights[0].color == implied.lights[0].color);
    CHECK(written.lights[0].inner_cone_deg == implied.lights[0].inner_cone_deg);
    CHECK(written.lights[0].outer_cone_deg == implied.lights[0].outer_cone_deg);
    CHECK(written.materials[0].name == implied.materials[0].name);
    CHECK(written.materials[0].phong.ambient == implied.materials[0].phong.ambient);
    CHECK(written.materials[0].phong.diffuse == implied.materials[0].phong.diffuse);
    CHECK(written.materials[0].phong.specular == implied.materials[0].phong.specular);
    CHECK(written.materials[0].phong.shininess == implied.materials[0].phong.shininess);
    CHECK(written.objects[0].world_from_object == glm::mat4(1.0f));
    CHECK(written.objects[0].mesh->triangle_count() == implied.objects[0].mesh->triangle_count());
    CHECK(written.objects[0].mesh->triangle_count() == 6 * 2);  // a cube's default detail is 1: one quad a face
    CHECK(written.materials[0].cook_torrance.albedo == implied.materials[0].cook_torrance.albedo);
    CHECK(written.materials[0].cook_torrance.metallic == implied.materials[0].cook_torrance.metallic);
    CHECK(written.materials[0].cook_torrance.roughness == implied.materials[0].cook_torrance.roughness);
    CHECK(written.materials[0].cook_torrance.ao == implied.materials[0].cook_torrance.ao);
    CHECK(written.materials[0].cook_torrance.distribution == implied.materials[0].cook_torrance.distribution);
    CHECK(written.materials[0].cook_torrance.geometry == implied.materials[0].cook_torrance.geometry);
    CHECK(written.materials[0].cook_torrance.fresnel == implied.materials[0].cook_torrance.fresnel);
    CHECK_FALSE(implied.materials[0].cook_torrance.ior.has_value());
}

TEST_CASE("Every key of cook_torrance arrives at its field") {
    const Scene scene = read_text(R"(
[[material]]
model = "cook_torrance"
albedo = [1, 0.78, 0.34]
metallic = 0.25
roughness = 0.3
ao = 0.5
distribution = "gaussian"
geometry = "implicit"
fresnel = "f82"
energy_compensation = "kulla_conty"
ior = [0.18, 0.42, 1.37]
extinction = [3.42, 2.35, 1.77]
[[material]]
name = "w"
model = "ward"
)");
    using namespace lighting;
    CHECK(scene.materials[0].model == ReflectionModel::cook_torrance);
    CHECK(scene.materials[1].model == ReflectionModel::ward);
    const CookTorranceMaterial& m = scene.materials[0].cook_torrance;
    CHECK(m.albedo == glm::vec3(1.0f, 0.78f, 0.34f));
    CHECK(m.metallic == 0.25f);
    CHECK(m.roughness == 0.3f);
    CHECK(m.ao == 0.5f);
    CHECK(m.distribution == Distribution::gaussian);
    CHECK(m.geometry == Geometry::implicit);
    CHECK(m.fresnel == FresnelMethod::f82);
    CHECK(m.energy_compensation == EnergyCompensation::kulla_conty);
    CHECK(m.ior.value() == glm::vec3(0.18f, 0.42f, 1.37f));
    CHECK(m.extinction.value() == glm::vec3(3.42f, 2.35f, 1.77f));
}

TEST_CASE("The words of cook_torrance stand in the order of their enumerators") {
    using namespace lighting;
    const auto material = [](const std::string& line) {
        return read_text("[[material]]\n" + line + "\n").materials.at(0).cook_torrance;
    };
    CHECK(material("distribution = 'ggx'").distribution == Distribution::ggx);
    CHECK(material("distribution = 'beckmann'").distribution == Distribution::beckmann);
    CHECK(material("distribution = 'blinn_phong'").distribution == Distribution::blinn_phong);
    CHECK(material("geometry = 'smith'").geometry == Geometry::smith);
    CHECK(material("geometry = 'smith_correlated'").geometry == Geometry::smith_correlated);
    CHECK(material("geometry = 'cook_torrance'").geometry == Geometry::cook_torrance);
    CHECK(material("fresnel = 'exact'").fresnel == FresnelMethod::exact);
    CHECK(material("fresnel = 'rescaled_schlick'").fresnel == FresnelMethod::rescaled_schlick);
    CHECK(material("fresnel = 'corrected_schlick'").fresnel == FresnelMethod::corrected_schlick);
    CHECK(material("fresnel = 'schlick_ior'").fresnel == FresnelMethod::schlick_ior);
    CHECK(material("fresnel = 'corrected_schlick_as_printed'").fresnel == FresnelMethod::corrected_schlick_as_printed);
    CHECK(material("fresnel = 'table'").fresnel == FresnelMethod::table);
    CHECK(material("fresnel = 'nvidia'").fresnel == FresnelMethod::nvidia);
    CHECK(material("fresnel = 'none'").fresnel == FresnelMethod::none);
}

TEST_CASE("A measured metal is metallic and a measured dielectric is not unless the file says so") {
    using namespace lighting;
    const auto material = [](const std::string& lines) {
        return read_text("[[material]]\n" + lines + "\n").materials.at(0).cook_torrance;
    };
    CHECK(material("measured = 'gold'").metallic == 1.0f);
    CHECK(material("measured = 'gold'").measured == "gold");
    CHECK(material("measured = 'gold'").spectrum == SpectrumUse::full);
    CHECK(material("measured = 'gold'\nspectrum = 'three'").spectrum == SpectrumUse::three);
    CHECK(material("measured = 'gold'\nmetallic = 0.5").metallic == 0.5f);
    CHECK(material("measured = 'water'").metallic == 0.0f);
    for (const MeasuredMaterial& m : measured_materials()) {
        CHECK(material("measured = '" + std::string(m.name) + "'").measured == m.name);
    }
}

TEST_CASE("The keys of brushed surfaces and of Fresnel's methods arrive at their fields") {
    const Scene scene = read_text(R"(
[[material]]
model = "heidrich_seidel"
ward_alpha = [0.05, 0.4]
grain = [1, 0, 2]
nvidia = [0.1, 0.8, 3]
f82 = [0.83, 0.86, 0.89]
table_size = 16
ior = [1.5, 1.5, 1.5]
outside_ior = 1.33
)");
    const lighting::Material& m = scene.materials.at(0);
    CHECK(m.model == lighting::ReflectionModel::heidrich_seidel);
    CHECK(m.phong.ward_alpha.value() == glm::vec2(0.05f, 0.4f));
    CHECK(m.phong.grain == glm::vec3(1.0f, 0.0f, 2.0f));
    CHECK(m.cook_torrance.nvidia.value() == glm::vec3(0.1f, 0.8f, 3.0f));
    CHECK(m.cook_torrance.f82.value() == glm::vec3(0.83f, 0.86f, 0.89f));
    CHECK(m.cook_torrance.table_size == 16);
    CHECK(m.cook_torrance.outside_ior == 1.33f);
}

TEST_CASE("Each key arrives at its field") {
    const Scene scene = read_text(R"(
[image]
size = [12, 34]
samples = 2
background = [1, 0.5, 0.25]
exposure = 3
tone_map = "reinhard_extended"
white = 5
transfer = "gamma"
gamma = 1.8
[camera]
position = [1, 2, 3]
target = [4, 5, 7]
up = [0, 0, 1]
projection = "orthographic"
vertical_fov = 60.5
height = 8
near = 1
far = 9
[shading]
frequency = "gouraud"
interpolation = "affine"
cull = "none"
[ambient]
color = [1, 2, 3]
[fog]
mode = "exp2"
color = [3, 2, 1]
start = 1
end = 2
density = 0.5
distance = "planar"
frequency = "vertex"
)");
    CHECK(scene.image.width == 12);
    CHECK(scene.image.height == 34);
    CHECK(scene.image.samples == 2);
    CHECK(scene.image.background == glm::vec3(1.0f, 0.5f, 0.25f));
    CHECK(scene.image.exposure == 3.0f);
    CHECK(scene.image.tone_map == ToneMap::reinhard_extended);
    CHECK(scene.image.white == 5.0f);
    CHECK(scene.image.transfer == Transfer::gamma);
    CHECK(scene.image.gamma == 1.8f);
    CHECK(scene.camera.position == glm::vec3(1.0f, 2.0f, 3.0f));
    CHECK(scene.camera.target == glm::vec3(4.0f, 5.0f, 7.0f));
    CHECK(scene.camera.up == glm::vec3(0.0f, 0.0f, 1.0f));
    CHECK(scene.camera.projection == raster::Projection::orthographic);
    CHECK(scene.camera.vertical_fov_deg == 60.5f);
    CHECK(scene.camera.height == 8.0f);
    CHECK(scene.camera.near == 1.0f);
    CHECK(scene.camera.far == 9.0f);
    CHECK(scene.shading.frequency == ShadingFrequency::gouraud);
    CHECK(scene.shading.interpolation == Interpolation::affine);
    CHECK(scene.shading.cull == raster::CullMode::none);
    CHECK(scene.ambient == glm::vec3(1.0f, 2.0f, 3.0f));
    CHECK(scene.fog.mode == lighting::FogMode::exp2);
    CHECK(scene.fog.color == glm::vec3(3.0f, 2.0f, 1.0f));
    CHECK(scene.fog.start == 1.0f);
    CHECK(scene.fog.end == 2.0f);
    CHECK(scene.fog.density == 0.5f);
    CHECK(scene.fog.distance == lighting::FogDistance::planar);
    CHECK(scene.fog.frequency == lighting::FogFrequency::vertex);
}

TEST_CASE("Each key of a light and of a material arrives at its field") {
    const Scene scene = read_text(R"(
[[light]]
type = "spot"
direction = [0, -1, 0]
position = [7, 8, 9]
color = [1, 0, 1]
intensity = 2.5
attenuation = [1, 2, 3]
cone = [5, 180]
on = false
[[light]]
attenuation = "physical"
[[material]]
name = "gold"
model = "phong"
ambient = [1, 0, 0]
diffuse = [0, 1, 0]
specular = [0, 0, 1]
emission = [2, 2, 2]
shininess = 0
)");
    REQUIRE(scene.lights.size() == 2);
    CHECK(scene.lights[0].type == lighting::LightType::spot);
    CHECK(scene.lights[0].direction == glm::vec3(0.0f, -1.0f, 0.0f));
    CHECK(scene.lights[0].position == glm::vec3(7.0f, 8.0f, 9.0f));
    CHECK(scene.lights[0].color == glm::vec3(1.0f, 0.0f, 1.0f));
    CHECK(scene.lights[0].intensity == 2.5f);
    CHECK(scene.lights[0].attenuation.constant == 1.0f);
    CHECK(scene.lights[0].attenuation.linear == 2.0f);
    CHECK(scene.lights[0].attenuation.quadratic == 3.0f);
    CHECK(scene.lights[0].inner_cone_deg == 5.0f);
    CHECK(scene.lights[0].outer_cone_deg == 180.0f);
    CHECK_FALSE(scene.lights[0].on);
    CHECK(scene.lights[1].attenuation.constant == 0.0f);
    CHECK(scene.lights[1].attenuation.quadratic == 1.0f);
    const lighting::Material& gold = scene.materials.at(0);
    CHECK(gold.name == "gold");
    CHECK(gold.model == lighting::ReflectionModel::phong);
    CHECK(gold.phong.ambient == glm::vec3(1.0f, 0.0f, 0.0f));
    CHECK(gold.phong.diffuse == glm::vec3(0.0f, 1.0f, 0.0f));
    CHECK(gold.phong.specular == glm::vec3(0.0f, 0.0f, 1.0f));
    CHECK(gold.phong.emission == glm::vec3(2.0f));
    CHECK(gold.phong.shininess == 0.0f);
}

TEST_CASE("Each word stands for the enumerator of its name") {
    const auto shading = [](const std::string& line) { return read_text("[shading]\n" + line).shading; };
    CHECK(shading("frequency = 'flat'").frequency == ShadingFrequency::flat);
    CHECK(shading("frequency = 'gouraud'").frequency == ShadingFrequency::gouraud);
    CHECK(shading("frequency = 'phong'").frequency == ShadingFrequency::phong);
    CHECK(shading("interpolation = 'perspective'").interpolation == Interpolation::perspective);
    CHECK(shading("interpolation = 'affine'").interpolation == Interpolation::affine);
    CHECK(shading("cull = 'back'").cull == raster::CullMode::back);
    CHECK(shading("cull = 'front'").cull == raster::CullMode::front);
    CHECK(shading("cull = 'none'").cull == raster::CullMode::none);
    const auto image = [](const std::string& line) { return read_text("[image]\n" + line).image; };
    CHECK(image("tone_map = 'none'").tone_map == ToneMap::none);
    CHECK(image("tone_map = 'reinhard'").tone_map == ToneMap::reinhard);
    CHECK(image("tone_map = 'reinhard_extended'").tone_map == ToneMap::reinhard_extended);
    CHECK(image("transfer = 'srgb'").transfer == Transfer::srgb);
    CHECK(image("transfer = 'gamma'").transfer == Transfer::gamma);
    CHECK(image("transfer = 'linear'").transfer == Transfer::linear);
    const auto fog = [](const std::string& line) { return read_text("[fog]\n" + line).fog; };
    CHECK(fog("mode = 'none'").mode == lighting::FogMode::none);
    CHECK(fog("mode = 'linear'").mode == lighting::FogMode::linear);
    CHECK(fog("mode = 'exp'").mode == lighting::FogMode::exp);
    CHECK(fog("mode = 'exp2'").mode == lighting::FogMode::exp2);
    CHECK(fog("distance = 'radial'").distance == lighting::FogDistance::radial);
    CHECK(fog("distance = 'planar'").distance == lighting::FogDistance::planar);
    CHECK(fog("frequency = 'pixel'").frequency == lighting::FogFrequency::pixel);
    CHECK(fog("frequency = 'vertex'").frequency == lighting::FogFrequency::vertex);
    const auto type = [](const std::string& word) { return read_text("[[light]]\ntype = " + word).lights.at(0).type; };
    CHECK(type("'directional'") == lighting::LightType::directional);
    CHECK(type("'point'") == lighting::LightType::point);
    CHECK(type("'spot'") == lighting::LightType::spot);
    const auto model = [](const std::string& word) {
        return read_text("[[material]]\nmodel = " + word).materials.at(0).model;
    };
    CHECK(model("'unlit'") == lighting::ReflectionModel::unlit);
    CHECK(model("'lambert'") == lighting::ReflectionModel::lambert);
    CHECK(model("'phong'") == lighting::ReflectionModel::phong);
    CHECK(model("'blinn_phong'") == lighting::ReflectionModel::blinn_phong);
}

TEST_CASE("A byte-order mark and carriage returns change nothing") {
    const Scene scene = read_text("\xEF\xBB\xBF[image]\r\nsize = [3, 4]\r\n[camera]\r\nnear = 1 # c\r\n");
    CHECK(scene.image.width == 3);
    CHECK(scene.image.height == 4);
    CHECK(scene.camera.near == 1.0f);
}

TEST_CASE("The built-in scene reads; it has a shadow and an environment and uses each of its materials") {
    const Scene scene = read_text(built_in_scene_text());
    REQUIRE(scene.lights.size() == 1);
    CHECK(scene.lights[0].shadow);
    CHECK(scene.image.environment_background);
    CHECK(scene.objects.size() == 3);
    CHECK(scene.materials.size() == 3);
    CHECK(scene.warnings.empty());
}
