// What 97_extremes shows: the printed equations err as the page says, the arranged ones do not.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "lighting/fresnel.hpp"
#include "lighting/light.hpp"
#include "lighting/microfacet.hpp"
#include "lighting/reflection.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("97_extremes: brightness falls from the middle of the arranged highlight and has rings in the printed one") {
    const auto rises = [](const raster::Image& panel) {
        int count = 0;
        const int middle = panel.width / 2, y = panel.height / 2;
        for (int x = middle; x + 1 < panel.width; ++x) {
            count += panel.at(0, x + 1, y) > panel.at(0, x, y) + 0.001f ? 1 : 0;
        }
        return count;
    };
    const raster::Image both = golden("97_extremes/highlight.png");
    const auto half = [&](int first) {
        raster::Image part = raster::make_image(both.width / 2 - 4, both.height, 3);
        for (int y = 0; y < part.height; ++y) {
            for (int x = 0; x < part.width; ++x) part.set_rgb(x, y, both.rgb(first + x, y));
        }
        return part;
    };
    CHECK(rises(half(both.width / 2 + 4)) == 0);
    CHECK(rises(half(0)) > 0);
}

TEST_CASE("97_extremes: light at the lamp and without end is a number") {
    lighting::Light lamp;
    lamp.type = lighting::LightType::point;
    lamp.intensity = 1e9f;
    lamp.color = glm::vec3(1e9f);
    lamp.attenuation = {0.0f, 0.0f, 1.0f};
    const lighting::LightSample here = sample(lamp, lamp.position);
    CHECK(here.irradiance.x <= lighting::kMostIrradiance * 1.0001f);
    CHECK(here.irradiance * glm::dot(here.l, glm::vec3(0, 1, 0)) == glm::vec3(0.0f));
    CHECK(lighting::attenuate({1.0f, 0.0f, 0.0f}, raster::kInfinity) == 1.0f);
}

TEST_CASE("97_extremes: the mirror's direction has a highlight of 1 with any exponent") {
    int above = 0;
    for (int i = 1; i < 2000; ++i) {
        const glm::vec3 v =
            glm::normalize(glm::vec3(0.37f * static_cast<float>(i % 41), 1.0f, 0.001f * static_cast<float>(i)));
        above += glm::dot(v, v) > 1.0f ? 1 : 0;
        lighting::PhongMaterial m;
        m.shininess = 1e9f;
        const float highlight = lighting::highlight_of(lighting::sigma_phong(v, v), 1.0f, m);
        CHECK(highlight <= 1.0f);
    }
    CHECK(above > 0);  // otherwise nothing was tried
}
