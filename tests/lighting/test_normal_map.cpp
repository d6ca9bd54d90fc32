// Normal maps: flat leaves the normal to the last bit, the frame is right-handed, mirrored pictures tilt the right way.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "lighting/normal_map.hpp"

using namespace kreda::lighting;

namespace {

glm::vec3 random_vector(std::mt19937& bits, float length) {
    const auto real = [&] { return static_cast<float>(bits() >> 8) * 0x1p-23f - 1.0f; };
    const float x = real(), y = real(), z = real();
    return glm::vec3(x, y, z) * length;
}

}  // namespace

TEST_CASE("Flat normal map gives exactly the interpolated normal made unit") {
    std::mt19937 bits(1);
    for (int i = 0; i < 10000; ++i) {
        const glm::vec3 normal = random_vector(bits, i % 3 == 0 ? 1.0f : 17.3f);
        const glm::vec3 tangent = i % 7 == 0 ? glm::vec3(0.0f) : random_vector(bits, 1.0f);
        const float side = i % 2 == 0 ? 1.0f : -1.0f;
        const glm::vec3 n = unit(normal);
        REQUIRE(bend_normal(normal, tangent, side, {0.0f, 0.0f, 1.0f}) == n);
        REQUIRE(bend_normal(normal, tangent, side, {0.0f, 0.0f, 0.0f}) == n);
    }
}

TEST_CASE("Tangent frame is orthonormal and right-handed or left-handed as the side says") {
    std::mt19937 bits(2);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 n = unit(random_vector(bits, 1.0f));
        const glm::vec3 tangent = random_vector(bits, 1.0f);
        if (std::abs(glm::dot(n, unit(tangent))) > 0.9f) continue;
        const float side = i % 2 == 0 ? 0.9999999f : -1.0f;
        const TangentFrame frame = tangent_frame(n, tangent, side);
        REQUIRE(std::abs(glm::dot(n, frame.t)) < 1e-6f);
        REQUIRE(std::abs(glm::dot(frame.b, frame.t)) < 1e-6f);
        REQUIRE(std::abs(glm::length(frame.t) - 1.0f) < 1e-6f);
        REQUIRE(std::abs(glm::dot(glm::cross(frame.t, frame.b), n) - (side > 0.0f ? 1.0f : -1.0f)) < 1e-5f);
        REQUIRE(glm::dot(frame.t, tangent) > 0.0f);
    }
}

TEST_CASE("Bent normal has the components of the map in the frame whatever the length of normal and tangent") {
    const glm::vec3 m = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
    const glm::vec3 expected(m.x, m.z, -m.y);  // u along +x, the normal along +y: v along -z
    const glm::vec3 bent = bend_normal({0.0f, 5.0f, 0.0f}, {3.0f, 0.7f, 0.0f}, 1.0f, m);
    CHECK(glm::length(bent - expected) < 1e-6f);
    const glm::vec3 mirrored = bend_normal({0.0f, 5.0f, 0.0f}, {3.0f, 0.7f, 0.0f}, -1.0f, m);
    CHECK(glm::length(mirrored - glm::vec3(m.x, m.z, m.y)) < 1e-6f);
    const glm::vec3 averaged = bend_normal({0.0f, 5.0f, 0.0f}, {3.0f, 0.7f, 0.0f}, 1.0f, 0.4f * m);
    CHECK(glm::length(averaged - expected) < 1e-6f);
}

TEST_CASE("Tangent along the normal or of no length bends nothing and stays finite") {
    const glm::vec3 m(0.6f, 0.0f, 0.8f);
    CHECK(bend_normal({0.0f, 2.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 1.0f, m) == glm::vec3(0.0f, 1.0f, 0.0f));
    CHECK(bend_normal({0.0f, 2.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, 1.0f, m) == glm::vec3(0.0f, 1.0f, 0.0f));
    CHECK(bend_normal({0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, 1.0f, m) == glm::vec3(0.0f));
}

TEST_CASE("Stored 128 of 255 and 32768 of 65535 and 0.5 of a float mean exactly 0") {
    CHECK(normal_component(128.0f / 255.0f, 8) == 0.0f);
    CHECK(normal_component(32768.0f / 65535.0f, 16) == 0.0f);
    CHECK(normal_component(0.5f, 0) == 0.0f);
    for (const int bits : {0, 8, 16}) {
        CHECK(normal_component(1.0f, bits) == 1.0f);
        CHECK(normal_component(0.0f, bits) == -1.0f);
        CHECK(std::abs(normal_component(0.75f, bits) - 0.5f) < 0.005f);
    }
}
