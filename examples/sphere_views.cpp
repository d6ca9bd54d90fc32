#include "examples/sphere_views.hpp"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lighting/environment/environment_image.hpp"

namespace kreda::examples {

namespace {

/// The mean of four points of pixel (x, y); `color_at` takes a point of the picture, in pixels.
template <class ColorAt>
glm::vec3 pixel_mean(int x, int y, ColorAt color_at) {
    glm::vec3 sum(0.0f);
    for (const float dy : {0.25f, 0.75f}) {
        for (const float dx : {0.25f, 0.75f}) {
            sum += color_at(glm::vec2(static_cast<float>(x) + dx, static_cast<float>(y) + dy));
        }
    }
    return 0.25f * sum;
}

/// Where a face begins in the cross, in faces from the upper left corner.
glm::ivec2 place_in_cross(int face) {
    constexpr glm::ivec2 kPlaces[] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
    return kPlaces[face];
}

/// `place` tells where a direction lies on the picture, in pixels. A name stands below its place, within the picture.
template <class Place>
Panel with_axes(Panel panel, float size, Place place) {
    for (const char* name : {"+x", "-x", "+y", "-y", "+z", "-z"}) {
        glm::vec3 axis(0.0f);
        axis[name[1] - 'x'] = name[0] == '+' ? 1.0f : -1.0f;
        const std::string text = std::string(1, name[0]) + "$" + name[1] + "$";
        const float width = tools::type_width(text, size);
        const glm::vec2 below = place(axis) + glm::vec2(-0.5f * width, size);
        const glm::vec2 lowest(panel.image.width, panel.image.height);
        const glm::vec2 start =
            glm::clamp(below, glm::vec2(0.1f * size, size), lowest - glm::vec2(width + 0.1f * size, 0.3f * size));
        panel.labels.push_back({start, text, kChalk, size});
    }
    return panel;
}

}  // namespace

Image equirect_picture(int width, const DirectionColor& color) {
    Image image = make_board(width, width / 2);
    const glm::vec2 size(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto at = [&](glm::vec2 point) { return color(lighting::equirect_direction(point / size)); };
            image.set_rgb(x, y, pixel_mean(x, y, at));
        }
    }
    return image;
}

Image cube_picture(int side, const DirectionColor& color) {
    Image image = make_board(4 * side, 3 * side);
    for (int face = 0; face < lighting::kCubeFaces; ++face) {
        const glm::ivec2 corner = side * place_in_cross(face);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const auto at = [&](glm::vec2 point) {
                    const glm::vec2 uv = point / static_cast<float>(side);
                    return color(glm::normalize(lighting::direction_of({face, uv.x, uv.y})));
                };
                image.set_rgb(corner.x + x, corner.y + y, pixel_mean(x, y, at));
            }
        }
    }
    return image;
}

Panel with_equirect_axes(Image picture, float type_size) {
    const glm::vec2 size(picture.width, picture.height);
    return with_axes(std::move(picture), type_size,
                     [&](const glm::vec3& axis) { return lighting::equirect_point(axis) * size; });
}

Panel with_cube_axes(Image picture, float type_size) {
    const float side = static_cast<float>(picture.width / 4);
    return with_axes(std::move(picture), type_size, [&](const glm::vec3& axis) {
        const lighting::CubePoint p = lighting::cube_point(axis);
        return side * (glm::vec2(place_in_cross(p.face)) + glm::vec2(p.u, p.v));
    });
}

Image camera_picture(glm::ivec2 size, const glm::vec3& forward, float vertical_fov_deg, const DirectionColor& color) {
    const glm::vec3 f = glm::normalize(forward);
    const glm::vec3 right = glm::normalize(glm::cross(f, glm::vec3(0.0f, 1.0f, 0.0f)));
    const glm::vec3 up = glm::cross(right, f);
    const double half_angle = 0.5 * static_cast<double>(vertical_fov_deg) * std::numbers::pi / 180.0;
    const float pixel = 2.0f * static_cast<float>(std::tan(half_angle)) / static_cast<float>(size.y);
    Image image = make_board(size.x, size.y);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const auto at = [&](glm::vec2 point) {
                const glm::vec2 from_middle = pixel * (point - 0.5f * glm::vec2(size));
                return color(glm::normalize(f + right * from_middle.x - up * from_middle.y));
            };
            image.set_rgb(x, y, pixel_mean(x, y, at));
        }
    }
    return image;
}

}  // namespace kreda::examples
