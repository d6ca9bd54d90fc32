#include "examples/tile_maps.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "examples/draw.hpp"
#include "raster/film.hpp"

namespace kreda::examples {

namespace {

constexpr float kGroove = 0.05f;  ///< from the tile's border, in tiles: mortar ends here
constexpr float kBevel = 0.14f;   ///< and the tile is flat from here on
constexpr float kSlope = 0.35f;   ///< height of a tile over the mortar, in tiles

/// Where a point lies, in tiles: u and v run over 0..2 and start over there.
struct TilePoint {
    bool gold = false;
    float rise = 0.0f;         ///< 0 mortar, 1 on the tile
    float x = 0.0f, y = 0.0f;  ///< within the tile, 0..1
};

TilePoint tile_at(float u, float v) {
    const float column = std::floor(u), row = std::floor(v);
    TilePoint point;
    point.x = u - column;
    point.y = v - row;
    point.gold = (static_cast<int>(column) + static_cast<int>(row)) % 2 == 0;
    const float border = std::min({point.x, 1.0f - point.x, point.y, 1.0f - point.y});
    point.rise = glm::smoothstep(kGroove, kBevel, border);
    return point;
}

/// Height over the mortar; gold is hammered, glaze is smooth.
float height_at(float u, float v) {
    const TilePoint p = tile_at(u + 2.0f - 2.0f * std::floor(0.5f * u), v + 2.0f - 2.0f * std::floor(0.5f * v));
    const float dents = 0.035f * std::sin(5.0f * raster::kTwoPi * p.x) * std::sin(5.0f * raster::kTwoPi * p.y);
    return p.rise * (kSlope * 0.2f + (p.gold ? 0.2f * dents : 0.0f));
}

glm::vec3 normal_at(float u, float v) {
    constexpr float kStep = 1.0f / 128.0f;
    const float du = (height_at(u + kStep, v) - height_at(u - kStep, v)) / (2.0f * kStep);
    const float dv = (height_at(u, v + kStep) - height_at(u, v - kStep)) / (2.0f * kStep);
    return glm::normalize(glm::vec3(-du, -dv, 1.0f));
}

void set_texel(std::array<TileMap, 5>& maps, int x, int y, float u, float v) {
    const TilePoint p = tile_at(u, v);
    const glm::vec3 tile = p.gold ? glm::vec3(1.0f, 0.78f, 0.34f) : srgb(0x2d62a8);
    const glm::vec3 albedo = glm::mix(srgb(0x6d675f), tile, p.rise);
    const float roughness = glm::mix(0.95f, p.gold ? 0.32f : 0.15f, p.rise);
    for (int c = 0; c < 3; ++c) {
        maps[0].stored.at(c, x, y) = raster::srgb_from_linear(albedo[c]);
        maps[4].stored.at(c, x, y) = (127.0f * normal_at(u, v)[c] + 128.0f) / 255.0f;
    }
    maps[1].stored.at(0, x, y) = p.gold ? p.rise : 0.0f;
    maps[2].stored.at(0, x, y) = roughness;
    maps[3].stored.at(0, x, y) = glm::mix(0.35f, 1.0f, p.rise);
}

}  // namespace

std::array<TileMap, 5> tile_maps(int side) {
    const raster::Image color = raster::make_image(side, side, 3), value = raster::make_image(side, side, 1);
    std::array<TileMap, 5> maps = {
        {{"albedo", color}, {"metallic", value}, {"roughness", value}, {"ao", value}, {"normal", color}}};
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const float u = 2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(side);
            const float v = 2.0f - 2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(side);
            set_texel(maps, x, y, u, v);
        }
    }
    return maps;
}

}  // namespace kreda::examples
