// Camera matrices against those of gluLookAt, gluPerspective and glOrtho, worked by hand.
#include <doctest/doctest.h>

#include <cmath>

#include <glm/matrix.hpp>

#include "raster/camera.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda::tests;

namespace {

/// Rows as they are written on paper; every entry within `tolerance`.
void check_matrix(const glm::mat4& m, const float (&rows)[4][4], float tolerance) {
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            CAPTURE(row);
            CAPTURE(column);
            CHECK(std::abs(m[column][row] - rows[row][column]) <= tolerance);
        }
    }
}

glm::dvec3 divided(const glm::vec4& clip) {
    return glm::dvec3(clip) / double{clip.w};
}

}  // namespace

TEST_CASE("gluLookAt by hand: from +z the world only moves back") {
    Camera camera;
    camera.position = {0, 0, 4};
    camera.target = {0, 0, 0};
    check_matrix(view_from_world(camera), {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -4}, {0, 0, 0, 1}}, 0.0f);
}

TEST_CASE("gluLookAt by hand: from +x the right hand points to -z") {
    Camera camera;
    camera.position = {4, 0, 0};
    camera.target = {0, 0, 0};
    check_matrix(view_from_world(camera), {{0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, -4}, {0, 0, 0, 1}}, 0.0f);
}

TEST_CASE("gluLookAt by hand: 3-4-5 triangle downwards") {
    // Forward (0, -4, -3)/5, right +x, up (0, 3, -4)/5; the eye (0, 4, 3) lies 5 in front of the origin, on the axis.
    Camera camera;
    camera.position = {0, 4, 3};
    camera.target = {0, 0, 0};
    check_matrix(view_from_world(camera), {{1, 0, 0, 0}, {0, 0.6f, -0.8f, 0}, {0, 0.8f, 0.6f, -5}, {0, 0, 0, 1}},
                 1e-7f);  // each entry rounded once
}

TEST_CASE("gluPerspective by hand: 90 degrees and aspect 2 and near 1 and far 3") {
    // cot(45 deg) = 1;  (f + n)/(n - f) = -2;  2 f n/(n - f) = -3.
    Camera camera;
    camera.vertical_fov_deg = 90.0f;
    camera.near = 1.0f;
    camera.far = 3.0f;
    check_matrix(clip_from_view(camera, 2.0f), {{0.5f, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -2, -3}, {0, 0, -1, 0}}, 1e-7f);
}

TEST_CASE("glOrtho by hand: height 4 and aspect 1.5 and near 1 and far 5") {
    // 2/width = 1/3, 2/height = 1/2, -2/(f - n) = -1/2, -(f + n)/(f - n) = -3/2.
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.height = 4.0f;
    camera.near = 1.0f;
    camera.far = 5.0f;
    check_matrix(clip_from_view(camera, 1.5f),
                 {{1.0f / 3.0f, 0, 0, 0}, {0, 0.5f, 0, 0}, {0, 0, -0.5f, -1.5f}, {0, 0, 0, 1}}, 1e-7f);
}

TEST_CASE(
    "View matrix is a rotation and a translation: lengths stay and determinant 1 and the eye becomes the origin") {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Camera camera = random_camera(random);
        const glm::mat4 view = view_from_world(camera);
        const glm::mat3 rotation(view);
        const glm::mat3 identity = rotation * glm::transpose(rotation);
        // Entries are rounded to 2^-25 each, nine of them in a product.
        for (int k = 0; k < 3; ++k) CHECK(glm::length(identity[k] - glm::mat3(1.0f)[k]) < 1e-6f);
        CHECK(glm::determinant(rotation) == doctest::Approx(1.0f).epsilon(1e-6));
        CHECK(glm::length(glm::vec3(view * glm::vec4(camera.position, 1.0f))) < 4e-6f);  // of coordinates up to 7
    }
}

TEST_CASE("Target projects to the centre and near plane to -1 and far plane to +1") {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        Camera camera = random_camera(random);
        camera.far = camera.near * random.real(2.0f, 1000.0f);
        const glm::mat4 clip = clip_from_world(camera, 1.5f);
        const glm::vec3 forward = view_direction(camera);
        CHECK(glm::length(forward) == doctest::Approx(1.0f).epsilon(1e-6));
        const glm::dvec3 target = divided(clip * glm::vec4(camera.target, 1.0f));
        // Cancellation of coordinates up to 7, over a half height of at least 0.087 (10 degrees) at distance 1.1.
        CHECK(std::abs(target.x) < 2e-5);
        CHECK(std::abs(target.y) < 2e-5);
        // z_view is off by 2^-24 of 12, so up to 1e-6; relative to near (0.01 at least) that is 1e-4 of the depth
        // range.
        CHECK(divided(clip * glm::vec4(camera.position + camera.near * forward, 1.0f)).z ==
              doctest::Approx(-1.0).epsilon(4e-4));
        CHECK(divided(clip * glm::vec4(camera.position + camera.far * forward, 1.0f)).z ==
              doctest::Approx(1.0).epsilon(4e-4));
    }
}

TEST_CASE("Field of view: half of it above the axis is the top of the image and aspect widens it") {
    for (const float fov_deg : {10.0f, 45.0f, 90.0f, 150.0f}) {
        Camera camera;
        camera.position = {0, 0, 0};
        camera.target = {0, 0, -1};
        camera.vertical_fov_deg = fov_deg;
        const float half = std::tan(0.5f * fov_deg * 3.14159265f / 180.0f);
        const glm::dvec3 corner = divided(clip_from_world(camera, 1.6f) * glm::vec4(1.6f * half * 5, half * 5, -5, 1));
        CHECK(corner.x == doctest::Approx(1.0).epsilon(1e-6));  // a handful of float roundings
        CHECK(corner.y == doctest::Approx(1.0).epsilon(1e-6));
    }
}

TEST_CASE("Perspective w is the distance along the axis and orthographic w is 1") {
    Camera camera;
    camera.position = {1, 2, 3};
    camera.target = {1, 2, -7};
    CHECK((clip_from_world(camera, 1.0f) * glm::vec4(5, 5, -4, 1)).w == doctest::Approx(7.0f).epsilon(1e-6));
    camera.projection = Projection::orthographic;
    CHECK((clip_from_world(camera, 1.0f) * glm::vec4(5, 5, -4, 1)).w == 1.0f);
}
