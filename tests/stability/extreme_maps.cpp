#include "tests/stability/extreme_maps.hpp"

#include <memory>
#include <random>
#include <span>

#include "raster/texture.hpp"
#include "scene/map_meshes.hpp"

namespace kreda::tests {

namespace {

using Random = std::mt19937;

float one_of(std::span<const float> values, Random& random) {
    return values[random() % values.size()];
}

raster::Image image_of(std::span<const float> values, int width, int height, int channels, Random& random) {
    raster::Image image = raster::make_image(width, height, channels);
    for (float& value : image.values) value = one_of(values, random);
    return image;
}

std::shared_ptr<const raster::Texture> texture_of(std::span<const float> values, int channels, Random& random) {
    const int width = 1 + static_cast<int>(random() % 5), height = 1 + static_cast<int>(random() % 5);
    return std::make_shared<raster::Texture>(raster::make_texture(image_of(values, width, height, channels, random)));
}

// What load_maps.cpp leaves of a file: shares in 0..1, light in 0..1e9, normals as they are stored.
constexpr float kShares[] = {0.0f, 1.0f, 1e-8f, 0.5f, 1.0f - 0x1p-24f, 1e-38f};
constexpr float kLight[] = {0.0f, 1e9f, 1e-8f, 1.0f, 1e-38f};
constexpr float kNormals[] = {0.0f, 1.0f, 0.5f, 128.0f / 255.0f, 127.0f / 255.0f, 0.5f};

void add_maps(lighting::MaterialMaps& maps, Random& random) {
    const auto some = [&](lighting::Map& map, std::span<const float> values, int channels) {
        if (random() % 2 == 0) map.texture = texture_of(values, channels, random);
    };
    some(maps.albedo, kShares, 3);
    some(maps.diffuse, kShares, 3);
    some(maps.emission, kLight, 3);
    some(maps.metallic, kShares, 1);
    some(maps.roughness, kShares, 1);
    some(maps.ao, kShares, 1);
    some(maps.normal, kNormals, 3);
    constexpr float kRepeats[] = {1.0f, 1e-6f, 1e6f, 3.7f};
    maps.scale = {one_of(kRepeats, random), one_of(kRepeats, random)};
    maps.filter = static_cast<lighting::TextureFilter>(random() % 3);
    maps.wrap = static_cast<lighting::TextureWrap>(random() % 2);
}

}  // namespace

void add_extreme_maps(scene::Scene& scene, std::uint32_t seed) {
    Random random(seed);
    if (scene.environment.on && random() % 3 == 0) {
        scene.environment.image = std::make_shared<raster::Image>(image_of(kLight, 8, 4, 3, random));
    }
    if (random() % 2 == 0) return;
    for (lighting::Material& material : scene.materials) add_maps(material.maps, random);
    scene::drop_maps_without_uv(scene);
    scene::TangentMeshes made;
    scene::add_tangents(scene, made);
}

}  // namespace kreda::tests
