// The lecture's local models against numbers worked by hand.
#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>

#include "lighting/batch/passes.hpp"
#include "lighting/reflect.hpp"
#include "lighting/reflection.hpp"

using namespace kreda;
using namespace kreda::lighting;

namespace {

glm::vec3 direction(double theta_deg, double phi_deg = 0.0) {
    const double theta = theta_deg * 3.14159265358979 / 180.0, phi = phi_deg * 3.14159265358979 / 180.0;
    return glm::vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
}

const glm::vec3 kNormal{0, 0, 1};

PhongMaterial material(float shininess) {
    return {
        .ambient = glm::vec3(0.0f), .diffuse = {0.8f, 0.4f, 0.2f}, .specular = glm::vec3(0.5f), .shininess = shininess};
}

}  // namespace

TEST_CASE("Yellow ambient light makes a blue surface black and a violet one red") {
    CHECK(ambient_term({1, 1, 0}, {0, 0, 1}) == glm::vec3(0, 0, 0));
    CHECK(ambient_term({1, 1, 0}, {1, 0, 1}) == glm::vec3(1, 0, 0));
}

TEST_CASE("Lambert at 60 degrees reflects half and behind the surface nothing") {
    CHECK(lambert(kNormal, direction(60), material(1)).diffuse.x == doctest::Approx(0.4));
    CHECK(lambert(kNormal, direction(120), material(1)).diffuse == glm::vec3(0.0f));
}

TEST_CASE("The mirror vector is unit and as far from the normal on the other side") {
    for (const double theta : {0.0, 20.0, 70.0, 89.0}) {
        const glm::vec3 l = direction(theta, 33);
        const glm::vec3 r = mirror_vector(kNormal, l);
        CAPTURE(theta);
        CHECK(glm::dot(r, r) == doctest::Approx(1.0));
        CHECK(r.z == doctest::Approx(l.z));
        CHECK(r.x == doctest::Approx(-l.x));
        CHECK(r.y == doctest::Approx(-l.y));
    }
}

TEST_CASE("A viewer in the mirror direction sees the whole highlight in both models") {
    const glm::vec3 l = direction(40, 10);
    const glm::vec3 v = mirror_vector(kNormal, l);
    CHECK(sigma_phong(v, mirror_vector(kNormal, l)) == doctest::Approx(1.0));
    CHECK(sigma_blinn(kNormal, half_vector(l, v)) == doctest::Approx(1.0));
    CHECK(phong(kNormal, l, v, material(32)).specular.x == doctest::Approx(0.5));
    CHECK(blinn_phong(kNormal, l, v, material(32)).specular.x == doctest::Approx(0.5));
}

TEST_CASE("In the plane of incidence the half vector's angle is half the mirror vector's") {
    const glm::vec3 l = direction(20), v = direction(30, 180);  // 10 degrees beyond the mirror direction
    CHECK(sigma_phong(v, mirror_vector(kNormal, l)) == doctest::Approx(std::cos(10.0 * 3.14159265358979 / 180.0)));
    CHECK(sigma_blinn(kNormal, half_vector(l, v)) == doctest::Approx(std::cos(5.0 * 3.14159265358979 / 180.0)));
}

TEST_CASE("The matched exponent gives Blinn's highlight Phong's width near the normal") {
    const double rho = 10.0 * 3.14159265358979 / 180.0;
    for (const float h : {10.0f, 100.0f}) {
        const double phong_value = std::pow(std::cos(rho), h);
        const double blinn_value = std::pow(std::cos(0.5 * rho), blinn_exponent_matching_phong(h));
        CHECK(blinn_value ==
              doctest::Approx(phong_value).epsilon(0.02));  // ratio cos^4(rho/2)/cos(rho) = 1 + rho^4/8 to the h
    }
}

TEST_CASE("Phong at 10 degrees from the mirror direction with exponent 32 by hand") {
    const glm::vec3 l = direction(20), v = direction(30, 180);
    CHECK(phong(kNormal, l, v, material(32)).specular.x ==
          doctest::Approx(0.5 * 0.6129).epsilon(1e-3));  // cos(10)^32 = 0.6129
}

TEST_CASE("A surface that faces away from the light shows no highlight") {
    const glm::vec3 l = direction(95), v = direction(80, 180);
    CHECK(sigma_phong(v, mirror_vector(kNormal, l)) > 0.9f);
    CHECK(phong(kNormal, l, v, material(4)).specular == glm::vec3(0.0f));
    CHECK(blinn_phong(kNormal, l, v, material(4)).specular == glm::vec3(0.0f));
}

TEST_CASE("Exponent 0 lights every facing point and a huge one only the mirror direction") {
    const glm::vec3 l = direction(30), v = direction(50, 200);
    CHECK(phong(kNormal, l, v, material(0)).specular == glm::vec3(0.5f));
    CHECK(phong(kNormal, l, v, material(1e6f)).specular.x == 0.0f);
    CHECK(std::isfinite(phong(kNormal, l, mirror_vector(kNormal, l), material(1e6f)).specular.x));
}

TEST_CASE("The half vector of opposite directions is 0 and not a number nowhere") {
    CHECK(half_vector({0, 0, 1}, {0, 0, -1}) == glm::vec3(0.0f));
    CHECK(unit(glm::vec3(0.0f)) == glm::vec3(0.0f));
}

TEST_CASE("The faintest highlight that pow can tell from 0 is still the formula's") {
    // A batch leaves the power out where no Sigma of it is large enough. Sigma = 0.115 is: 0.115^40 = 2^-124.8, just
    // above 2^-126; 0.11^40 = 2^-127.4 is not, and counts as 0.
    for (const double sigma : {0.115, 0.11}) {
        for (const ReflectionModel model : {ReflectionModel::phong, ReflectionModel::blinn_phong}) {
            CAPTURE(sigma);
            CAPTURE(static_cast<int>(model));
            Material m;
            m.model = model;
            m.phong = material(40.0f);
            m.phong.diffuse = m.phong.ambient = glm::vec3(0.0f);
            const MaterialSetup setup = prepare(m);
            // n is tilted from l by an angle whose double's (mirror) or own (half vector, v = l) cosine is sigma.
            const double tilt = model == ReflectionModel::phong ? 0.5 * std::acos(sigma) : std::acos(sigma);
            Light lamp;
            lamp.type = LightType::directional;
            lamp.direction = {0.0f, 0.0f, -1.0f};
            const LightSetup light = prepare(lamp);
            LightingSetup frame;
            frame.orthographic = true;
            frame.forward = {0.0f, 0.0f, -1.0f};
            static raster::Fragments fragments;
            static LightingChannels channels;
            fragments.count = 16;
            for (int i = 0; i < fragments.count; ++i) {
                const double turn = 0.4 * i;
                fragments.position.set(i, glm::vec3(0.0f));
                fragments.normal.set(
                    i, glm::vec3(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)));
            }
            start_lighting(fragments, setup, frame, channels);
            sample_light(fragments, light, channels);
            CHECK(any_faces_light(fragments.count, channels));
            add_reflection(fragments.count, setup, LeaveChannels::always, channels);
            for (int i = 0; i < fragments.count; ++i) {
                const glm::vec3 v(0.0f, 0.0f, 1.0f);
                const glm::vec3 n = unit(fragments.normal.at(i));
                const glm::vec3 expected = reflect(material_at(setup, channels, i), n, v, v).specular;
                CHECK(channels.specular.at(i) == expected);
                CHECK((expected.x > 0.0f) == (sigma > 0.112));
            }
        }
    }
}

TEST_CASE("Exponent 0 lights a batch whose every Sigma is 0 as it lights the point") {
    // n is turned by 60 degrees from l = v: the mirror vector by 120, so that v.r < 0 and Sigma = 0; 0^0 = 1.
    Material m;
    m.model = ReflectionModel::phong;
    m.phong = material(0.0f);
    const MaterialSetup setup = prepare(m);
    Light lamp;
    lamp.direction = {0.0f, 0.0f, -1.0f};
    LightingSetup frame;
    frame.orthographic = true;
    frame.forward = {0.0f, 0.0f, -1.0f};
    static raster::Fragments fragments;
    static LightingChannels channels;
    fragments.count = 16;
    for (int i = 0; i < fragments.count; ++i) fragments.normal.set(i, direction(60, 20.0 * i));
    start_lighting(fragments, setup, frame, channels);
    sample_light(fragments, prepare(lamp), channels);
    add_reflection(fragments.count, setup, LeaveChannels::always, channels);
    for (int i = 0; i < fragments.count; ++i) {
        CHECK(channels.sigma.at(i) == 0.0f);
        CHECK(channels.specular.at(i) == m.phong.specular);
    }
}

TEST_CASE("A light on the back of every point says so") {
    static raster::Fragments fragments;
    static LightingChannels channels;
    fragments.count = 5;
    for (int i = 0; i < fragments.count; ++i) {
        fragments.position.set(i, {float(i), 0.0f, 0.0f});
        fragments.normal.set(i, {0.0f, 0.0f, 2.0f});
    }
    Light lamp;
    lamp.type = LightType::point;
    start_lighting(fragments, prepare(Material{}), LightingSetup{}, channels);
    const auto adds_something = [&] {
        sample_light(fragments, prepare(lamp), channels);
        return any_faces_light(fragments.count, channels);
    };
    lamp.position = {0.0f, 0.0f, -1.0f};
    CHECK_FALSE(adds_something());
    lamp.position = {0.0f, 0.0f, 0.0f};  // in the plane, and in point 0 itself
    CHECK_FALSE(adds_something());
    lamp.position = {0.0f, 0.0f, 1e-3f};
    CHECK(adds_something());
    CHECK(channels.n_dot_l.at(0) == 1.0f);
}
