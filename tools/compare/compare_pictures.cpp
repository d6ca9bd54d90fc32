#include "tools/compare/compare_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>

#include "raster/film.hpp"

namespace kreda::tools {

namespace {

using raster::Image;

const glm::vec3 kNotANumber(1.0f, 0.0f, 0.0f);

/// Encoded colours at 1, 4 and 16 steps; between them they are mixed over the logarithm.
glm::vec3 heat_color(float steps) {
    constexpr glm::vec3 kCold(0.20f, 0.45f, 0.95f), kWarm(0.98f, 0.85f, 0.25f), kHot(0.95f, 0.15f, 0.10f);
    const float t = std::log2(std::clamp(steps, 1.0f, 16.0f)) / 2.0f;
    return t < 1.0f ? glm::mix(kCold, kWarm, t) : glm::mix(kWarm, kHot, t - 1.0f);
}

}  // namespace

Image shown(const Image& image, Numbers numbers) {
    Image picture = raster::make_image(image.width, image.height, 3);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const glm::vec3 color = image.rgb(x, y);
            const auto encoded = [&](float value) {
                const float display = numbers.levels > 0 ? value : raster::srgb_from_linear(value);
                return std::clamp(display, 0.0f, 1.0f);
            };
            const bool is_finite = std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
            picture.set_rgb(x, y,
                            is_finite ? glm::vec3(encoded(color.x), encoded(color.y), encoded(color.z)) : kNotANumber);
        }
    }
    return picture;
}

Image heat_map(const Comparison& comparison, const Image& expected, Numbers numbers) {
    Image map = shown(expected, numbers);
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const float steps = comparison.steps[std::size_t(y) * std::size_t(map.width) + std::size_t(x)];
            const glm::vec3 color = map.rgb(x, y);
            const float grey = 0.3f * (color.x + color.y + color.z) / 3.0f;
            map.set_rgb(x, y, steps > 0.0f ? heat_color(steps) : glm::vec3(grey));
        }
    }
    return map;
}

}  // namespace kreda::tools
