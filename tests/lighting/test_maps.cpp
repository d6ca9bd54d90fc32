// Maps in a batch: a map of one colour is the constant, maps that the model does not read are never touched.
#include <doctest/doctest.h>

#include <memory>
#include <random>

#include "lighting/batch/passes.hpp"
#include "lighting/microfacet.hpp"
#include "raster/texture.hpp"

using namespace kreda;
using namespace kreda::lighting;

namespace {

constexpr int kPoints = 70;

std::shared_ptr<const raster::Texture> even_texture(int channels, glm::vec3 color) {
    raster::Image image = raster::make_image(6, 5, channels);
    for (int c = 0; c < channels; ++c) std::fill_n(image.plane(c), image.plane_size(), color[c]);
    return std::make_shared<raster::Texture>(raster::make_texture(image));
}

/// Left half one value, right half another.
std::shared_ptr<const raster::Texture> two_values(float left, float right, int channels = 1) {
    raster::Image image = raster::make_image(2, 1, channels);
    for (int c = 0; c < channels; ++c) {
        image.plane(c)[0] = left;
        image.plane(c)[1] = right;
    }
    return std::make_shared<raster::Texture>(raster::make_texture(image));
}

struct Batch {
    std::unique_ptr<raster::Fragments> points = std::make_unique<raster::Fragments>();
    std::unique_ptr<LightingChannels> channels = std::make_unique<LightingChannels>();
};

Batch random_batch() {
    Batch batch;
    std::mt19937 bits(5);
    const auto real = [&] { return static_cast<float>(bits() >> 8) * 0x1p-23f - 1.0f; };
    raster::Fragments& f = *batch.points;
    f.count = kPoints;
    for (int i = 0; i < raster::kChannelSize; ++i) {
        f.position.set(i, {real(), real(), real()});
        f.normal.set(i, {0.3f * real(), 0.3f * real(), 1.0f});
        f.tangent.set(i, {1.0f, real(), 0.0f});
        f.tangent_side.set(i, 1.0f);
        f.u.set(i, real());
        f.v.set(i, real());
        for (raster::Channel* step : {&f.du_dx, &f.dv_dx, &f.du_dy, &f.dv_dy}) step->set(i, 0.2f * real());
    }
    return batch;
}

/// Light the batch with one light.
void light(Batch& batch, const Material& material, LeaveChannels leave = LeaveChannels::always) {
    const std::vector<LightSetup> lights = {prepare(Light{})};
    LightingSetup setup;
    setup.eye = {0.0f, 0.0f, 5.0f};
    setup.ambient = glm::vec3(0.1f);
    setup.lights = lights;
    const MaterialSetup ready = prepare(material);
    start_lighting(*batch.points, ready, setup, *batch.channels);
    for (const LightSetup& one : lights) {
        sample_light(*batch.points, one, *batch.channels);
        add_reflection(batch.points->count, ready, leave, *batch.channels);
    }
    sum_terms(batch.points->count, *batch.channels);
}

bool same_radiance(const Batch& a, const Batch& b) {
    for (int i = 0; i < kPoints; ++i) {
        if (a.channels->radiance.at(i) != b.channels->radiance.at(i)) return false;
    }
    return true;
}

constexpr ReflectionModel kModels[] = {ReflectionModel::unlit,        ReflectionModel::lambert,
                                       ReflectionModel::phong,        ReflectionModel::blinn_phong,
                                       ReflectionModel::ward,         ReflectionModel::heidrich_seidel,
                                       ReflectionModel::cook_torrance};

}  // namespace

TEST_CASE("Maps of one value are the constants bit by bit with every model and filter") {
    for (const ReflectionModel model : kModels) {
        for (const auto filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
            CAPTURE(static_cast<int>(model));
            CAPTURE(static_cast<int>(filter));
            Material constant;
            constant.model = model;
            constant.phong.diffuse = {0.8f, 0.3f, 0.1f};
            constant.phong.emission = {0.125f, 0.3f, 0.6f};
            constant.cook_torrance.albedo = {0.2f, 0.5f, 0.7f};
            constant.cook_torrance.metallic = 0.3f;
            constant.cook_torrance.roughness = 0.45f;
            Material mapped = constant;
            mapped.phong.diffuse = glm::vec3(9.0f);
            mapped.phong.emission = glm::vec3(1.0f);  // multiplies the map
            mapped.cook_torrance.albedo = glm::vec3(1.0f);
            mapped.cook_torrance.metallic = 1.0f;
            mapped.cook_torrance.roughness = 1.0f;
            mapped.maps.filter = filter;
            mapped.maps.diffuse.texture = even_texture(3, constant.phong.diffuse);
            mapped.maps.emission.texture = even_texture(3, constant.phong.emission);
            mapped.maps.albedo.texture = even_texture(3, constant.cook_torrance.albedo);
            mapped.maps.metallic.texture = even_texture(1, glm::vec3(0.3f));
            mapped.maps.roughness.texture = even_texture(1, glm::vec3(0.45f));
            Batch a = random_batch(), b = random_batch();
            light(a, constant);
            light(b, mapped);
            CHECK(same_radiance(a, b));
        }
    }
}

TEST_CASE("A point in a batch of its own reads the maps as in a batch of many bit by bit with every model") {
    for (const ReflectionModel model : kModels) {
        CAPTURE(static_cast<int>(model));
        Material material;
        material.model = model;
        material.maps.filter = TextureFilter::bilinear;
        material.maps.diffuse.texture = material.maps.albedo.texture = two_values(0.2f, 0.9f, 3);
        material.maps.metallic.texture = two_values(0.0f, 1.0f);
        material.maps.roughness.texture = two_values(0.2f, 0.8f);
        Batch many = random_batch();
        light(many, material);
        int wrong = 0;
        for (int i = 0; i < kPoints; ++i) {
            Batch one;
            one.points->count = 1;
            one.points->position.set(0, many.points->position.at(i));
            one.points->normal.set(0, many.points->normal.at(i));
            one.points->u.set(0, many.points->u.at(i));
            one.points->v.set(0, many.points->v.at(i));
            light(one, material, LeaveChannels::only_of_batches);
            wrong += one.channels->radiance.at(0) != many.channels->radiance.at(i);
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("Flat normal map changes no bit of the picture") {
    for (const ReflectionModel model : {ReflectionModel::phong, ReflectionModel::cook_torrance}) {
        Material plain;
        plain.model = model;
        Material mapped = plain;
        mapped.maps.normal.texture = even_texture(3, {0.0f, 0.0f, 1.0f});
        Batch a = random_batch(), b = random_batch();
        light(a, plain);
        light(b, mapped);
        CHECK(same_radiance(a, b));
    }
}

TEST_CASE("Green that points down is green that points up with the other sign") {
    Material up, down;
    up.maps.normal.texture = even_texture(3, {0.2f, 0.4f, 0.9f});
    down.maps.normal.texture = even_texture(3, {0.2f, -0.4f, 0.9f});
    down.maps.normal_y = NormalMapY::down;
    Batch a = random_batch(), b = random_batch(), c = random_batch();
    light(a, up);
    light(b, down);
    CHECK(same_radiance(a, b));
    down.maps.normal_y = NormalMapY::up;
    light(c, down);
    CHECK_FALSE(same_radiance(a, c));
}

TEST_CASE("Values of a map reach their points and F0 and alpha follow them") {
    Material material;
    material.model = ReflectionModel::cook_torrance;
    material.maps.filter = TextureFilter::nearest;
    material.maps.metallic.texture = two_values(0.0f, 1.0f);
    material.maps.roughness.texture = two_values(0.2f, 0.9f);
    Batch batch = random_batch();
    for (int i = 0; i < kPoints; ++i) batch.points->u.set(i, i % 2 == 0 ? 0.25f : 0.75f);
    light(batch, material);
    const MicrofacetChannels& m = batch.channels->microfacet;
    for (int i = 0; i < kPoints; ++i) {
        const bool left = i % 2 == 0;
        CHECK(m.surface.at(i).metallic == (left ? 0.0f : 1.0f));
        CHECK(m.surface.at(i).alpha == alpha_from_roughness(left ? 0.2f : 0.9f));
        CHECK(m.surface.at(i).f0 == (left ? glm::vec3(kDielectricF0) : glm::vec3(0.8f)));
    }
}

TEST_CASE("Model decides which maps are read and what they ask of the points") {
    Material material;
    for (const MapUse& use : map_uses()) (material.maps.*use.map).texture = even_texture(3, glm::vec3(0.5f));
    const auto read = [&](ReflectionModel model) {
        material.model = model;
        const MaterialMaps maps = maps_in_use(material);
        std::string names;
        for (const MapUse& use : map_uses()) {
            if ((maps.*use.map).texture) names += std::string(use.name) + " ";
        }
        return names;
    };
    CHECK(read(ReflectionModel::unlit) == "diffuse emission ");
    CHECK(read(ReflectionModel::phong) == "diffuse emission normal ");
    CHECK(read(ReflectionModel::cook_torrance) == "albedo emission metallic roughness ao normal ");

    Material plain;
    CHECK_FALSE(needs_of(maps_in_use(plain)).uv);
    plain.maps.diffuse.texture = even_texture(3, glm::vec3(0.5f));
    plain.maps.filter = TextureFilter::bilinear;
    CHECK(needs_of(maps_in_use(plain)).uv);
    CHECK_FALSE(needs_of(maps_in_use(plain)).uv_steps);
    CHECK_FALSE(needs_of(maps_in_use(plain)).tangent);
}
