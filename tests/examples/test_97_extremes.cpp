// What 97_extremes shows: the printed equations err as the page says, the arranged ones do not.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "lighting/fresnel.hpp"
#include "lighting/light.hpp"
#include "lighting/light_sample.hpp"
#include "lighting/microfacet.hpp"
#include "lighting/reflection.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("97_extremes: the printed highlight falls in a few steps and the arranged one smoothly") {
    const raster::Image both = golden_montage("97_extremes/highlight", 2);
    // From the middle of a panel to the right, above its caption: how often neighbours differ.
    const auto steps = [&](int first) {
        const int last = first + both.width / 2 - 8, y = both.height / 2;
        int count = 0;
        for (int x = (first + last) / 2; x < last; ++x) count += both.at(0, x + 1, y) != both.at(0, x, y) ? 1 : 0;
        return count;
    };
    const int printed = steps(0), arranged = steps(both.width / 2 + 4);
    CHECK(printed > 2);
    CHECK(2 * printed < arranged);
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
