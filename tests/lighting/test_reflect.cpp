// reflect(), the whole formula at one point, against the passes over a batch: the same bits, whatever is chosen.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "lighting/batch/passes.hpp"
#include "lighting/light_sample.hpp"
#include "lighting/microfacet_choices.hpp"
#include "lighting/reflect.hpp"
#include "lighting/ward.hpp"

using namespace kreda;
using namespace kreda::lighting;

namespace {

constexpr int kPoints = 37;  // not a multiple of the lanes

glm::vec3 direction(double theta_deg, double phi_deg) {
    const double theta = theta_deg * 3.14159265358979 / 180.0, phi = phi_deg * 3.14159265358979 / 180.0;
    return glm::vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
}

/// A batch with its channels; large, so that each test makes few of them.
struct Batch {
    std::unique_ptr<raster::Fragments> points = std::make_unique<raster::Fragments>();
    std::unique_ptr<LightingChannels> channels = std::make_unique<LightingChannels>();
};

Light lamp() {
    Light light;
    light.type = LightType::point;
    return light;
}

/// `count` points of a bent surface, from the one with this number on.
void place_points(Batch& batch, int first, int count) {
    batch.points->count = count;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * (first + i);
        batch.points->position.set(i, direction(angle, 11.0 * (first + i)));
        batch.points->normal.set(i, 1.7f * direction(3.0 * angle + 3.0, 11.0 * (first + i)));
    }
}

/// Light `count` points of a bent surface, from the one with this number on; some face away from lamp and eye.
void light(Batch& batch, const MaterialSetup& material, int first, int count, LeaveChannels leave) {
    const LightSetup lamp_setup = prepare(lamp());
    LightingSetup frame;
    frame.eye = {0.3f, -1.0f, 4.0f};
    frame.lights = {&lamp_setup, 1};
    place_points(batch, first, count);
    batch.channels->microfacet.D.set(0, -7.0f);  // what an earlier batch left
    batch.channels->sigma.set(0, -7.0f);
    start_lighting(*batch.points, material, frame, *batch.channels);
    sample_light(*batch.points, lamp_setup, *batch.channels);
    add_reflection(count, material, leave, *batch.channels);
    sum_terms(count, *batch.channels);
}

/// Every point by the passes, by a batch of its own, and by reflect() with nothing of a batch at all.
void check_batch(const Material& m) {
    const MaterialSetup setup = prepare(m);
    const PointMaterial material{m.model, m.phong, &setup.cook_torrance, setup.cook_torrance.surface};
    static Batch many, one;
    light(many, setup, 0, kPoints, LeaveChannels::only_of_batches);
    int wrong = 0, lit = 0;
    for (int i = 0; i < kPoints; ++i) {
        light(one, setup, i, 1, LeaveChannels::only_of_batches);
        const glm::vec3 p = many.points->position.at(i), n = unit(many.points->normal.at(i));
        const LightSample s = sample(lamp(), p);
        const ReflectedTerms terms = reflect(material, n, s.l, unit(glm::vec3(0.3f, -1.0f, 4.0f) - p));
        const glm::vec3 diffuse = glm::vec3(0.0f) + s.irradiance * terms.diffuse;
        const glm::vec3 specular = glm::vec3(0.0f) + s.irradiance * terms.specular;
        wrong += many.channels->diffuse.at(i) != diffuse || many.channels->specular.at(i) != specular;
        wrong += one.channels->diffuse.at(0) != diffuse || one.channels->specular.at(0) != specular;
        wrong += one.channels->radiance.at(0) != many.channels->radiance.at(i);
        lit += diffuse != glm::vec3(0.0f) || specular != glm::vec3(0.0f);
    }
    CHECK(wrong == 0);
    CHECK(lit > kPoints / 4);
    CHECK(lit < kPoints);
}

Material with_model(ReflectionModel model) {
    Material m;
    m.model = model;
    m.phong = {
        .ambient = glm::vec3(0.0f), .diffuse = {0.8f, 0.4f, 0.2f}, .specular = {0.5f, 0.4f, 0.6f}, .shininess = 23.0f};
    m.phong.grain = {0.3f, 2.0f, -0.5f};
    return m;
}

}  // namespace

TEST_CASE("reflect: the passes over a batch give its bits whatever the model") {
    for (const ReflectionModel model :
         {ReflectionModel::lambert, ReflectionModel::phong, ReflectionModel::blinn_phong, ReflectionModel::ward,
          ReflectionModel::heidrich_seidel, ReflectionModel::cook_torrance}) {
        CAPTURE(static_cast<int>(model));
        Material m = with_model(model);
        for (const float shininess : {0.0f, 23.0f, 1e6f}) {
            m.phong.shininess = shininess;
            check_batch(m);
        }
        if (model != ReflectionModel::ward) continue;
        m.phong.shininess = 23.0f;
        m.phong.ward_alpha = glm::vec2(0.1f, 0.5f);
        check_batch(m);
    }
}

TEST_CASE(
    "reflect: lights of parallel rays, the same at every point, add what reflect() says, first or second, in shadow or "
    "not") {
    Light sun;
    sun.direction = {0.3f, -0.2f, -1.0f};
    sun.color = {0.9f, 0.7f, 0.4f};
    static Batch batch;
    LightingSetup frame;
    frame.eye = {0.3f, -1.0f, 4.0f};
    frame.ambient = {0.1f, 0.2f, 0.3f};
    for (const ReflectionModel model :
         {ReflectionModel::lambert, ReflectionModel::phong, ReflectionModel::blinn_phong, ReflectionModel::ward,
          ReflectionModel::heidrich_seidel, ReflectionModel::cook_torrance}) {
        CAPTURE(static_cast<int>(model));
        Material m = with_model(model);
        m.phong.ambient = {0.5f, 0.25f, 0.125f};
        const MaterialSetup setup = prepare(m);
        const PointMaterial material{m.model, m.phong, &setup.cook_torrance, setup.cook_torrance.surface};
        for (const auto& lights : {std::vector<Light>{}, {sun}, {sun, lamp()}, {lamp(), sun}, {sun, sun}}) {
            CAPTURE(lights.size());
            for (const int way : {0, 1, 2, 3}) {
                const bool shadow = way % 2 != 0, ends_in_radiance = way >= 2;
                place_points(batch, 0, kPoints);
                start_lighting(*batch.points, setup, frame, *batch.channels);
                for (int i = 0; i < kPoints; ++i) batch.channels->shadow.set(i, 0.25f * static_cast<float>(i % 5));
                for (std::size_t k = 0; k < lights.size(); ++k) {
                    sample_light(*batch.points, prepare(lights[k]), *batch.channels);
                    if (shadow) shadow_light(kPoints, *batch.channels);
                    using enum LeaveChannels;
                    const LeaveChannels last = ends_in_radiance ? only_radiance : only_of_batches;
                    add_reflection(kPoints, setup, k + 1 == lights.size() ? last : only_of_batches, *batch.channels);
                }
                sum_terms(kPoints, *batch.channels);
                int wrong = 0;
                for (int i = 0; i < kPoints; ++i) {
                    const glm::vec3 p = batch.points->position.at(i), n = unit(batch.points->normal.at(i));
                    glm::vec3 diffuse(0.0f), specular(0.0f);
                    for (const Light& light : lights) {
                        const LightSample s = sample(light, p);
                        const ReflectedTerms terms = reflect(material, n, s.l, unit(frame.eye - p));
                        const float share = 0.25f * static_cast<float>(i % 5);
                        const glm::vec3 irradiance = shadow ? share * s.irradiance : s.irradiance;
                        diffuse = diffuse + irradiance * terms.diffuse;
                        specular = specular + irradiance * terms.specular;
                    }
                    const bool knows_ambient = model != ReflectionModel::cook_torrance;
                    const glm::vec3 ambient =
                        knows_ambient ? ambient_term(frame.ambient, m.phong.ambient) : glm::vec3(0.0f);
                    wrong += batch.channels->radiance.at(i) != ambient + diffuse + specular;
                    wrong += batch.channels->ambient.at(i) != ambient;
                }
                CHECK(wrong == 0);
            }
        }
    }
}

TEST_CASE("reflect: parallel light in a parallel projection has one half vector and its bits at every point") {
    Light sun;
    sun.direction = {0.3f, -0.2f, -1.0f};
    const LightSetup light = prepare(sun);
    LightingSetup frame;
    frame.orthographic = true;
    frame.forward = unit(glm::vec3(-0.4f, 0.1f, -1.0f));
    Material m = with_model(ReflectionModel::blinn_phong);
    m.phong.shininess = 3.0f;
    const MaterialSetup setup = prepare(m);
    const PointMaterial material{m.model, m.phong, &setup.cook_torrance, {}};
    static Batch batch;
    batch.points->count = kPoints;
    for (int i = 0; i < kPoints; ++i) batch.points->normal.set(i, direction(2.0 * i, 11.0 * i));
    start_lighting(*batch.points, setup, frame, *batch.channels);
    sample_light(*batch.points, light, *batch.channels);
    add_reflection(kPoints, setup, LeaveChannels::always, *batch.channels);
    const LightSample s = sample(sun, glm::vec3(0.0f));
    int wrong = 0, shining = 0;
    for (int i = 0; i < kPoints; ++i) {
        const ReflectedTerms terms = reflect(material, unit(batch.points->normal.at(i)), s.l, -frame.forward);
        wrong += batch.channels->specular.at(i) != glm::vec3(0.0f) + s.irradiance * terms.specular;
        shining += terms.specular != glm::vec3(0.0f);
    }
    CHECK(wrong == 0);
    CHECK(shining > kPoints / 4);
}

TEST_CASE("reflect: the passes over a batch give its bits for every distribution x geometry x Fresnel method") {
    struct Substance {
        const char* measured;
        SpectrumUse spectrum;
    };
    for (const Substance& substance : {Substance{"", SpectrumUse::full}, Substance{"gold", SpectrumUse::full},
                                       Substance{"gold", SpectrumUse::three}, Substance{"water", SpectrumUse::three}}) {
        for (std::size_t f = 0; f < kFresnelMethods.size(); ++f) {
            Material m = with_model(ReflectionModel::cook_torrance);
            m.cook_torrance.measured = substance.measured;
            m.cook_torrance.spectrum = substance.spectrum;
            m.cook_torrance.fresnel = static_cast<FresnelMethod>(f);
            m.cook_torrance.metallic = 0.3f;
            m.cook_torrance.albedo = {0.9f, 0.5f, 0.2f};
            if (substance.spectrum == SpectrumUse::three) m.cook_torrance.nvidia = glm::vec3(0.1f, 0.8f, 3.0f);
            for (std::size_t d = 0; d < kDistributions.size(); ++d) {
                for (std::size_t g = 0; g < kGeometries.size(); ++g) {
                    CAPTURE(std::string(substance.measured));
                    CAPTURE(kFresnelMethods[f].key);
                    CAPTURE(kDistributions[d].key);
                    CAPTURE(kGeometries[g].key);
                    m.cook_torrance.distribution = static_cast<Distribution>(d);
                    m.cook_torrance.geometry = static_cast<Geometry>(g);
                    check_batch(m);
                }
            }
        }
    }
}

TEST_CASE("reflect: the passes over a batch give its bits with the light of several bounces too") {
    Material m = with_model(ReflectionModel::cook_torrance);
    m.cook_torrance.energy_compensation = EnergyCompensation::kulla_conty;
    m.cook_torrance.roughness = 0.8f;
    for (const FresnelMethod method : {FresnelMethod::schlick, FresnelMethod::exact}) {
        m.cook_torrance.fresnel = method;
        check_batch(m);
    }
}

TEST_CASE("reflect: a batch of one leaves the steps' channels only where they are looked at") {
    Batch batch;
    const auto channels = [&](ReflectionModel model, int count, LeaveChannels leave) -> const LightingChannels& {
        light(batch, prepare(with_model(model)), 3, count, leave);
        return *batch.channels;
    };
    using enum LeaveChannels;
    using enum ReflectionModel;
    CHECK(channels(blinn_phong, 1, only_of_batches).sigma.at(0) == 0.0f);
    CHECK(channels(blinn_phong, 1, always).sigma.at(0) > 0.0f);
    CHECK(channels(blinn_phong, 2, only_of_batches).sigma.at(0) > 0.0f);
    CHECK(channels(cook_torrance, 1, only_of_batches).microfacet.D.at(0) == 0.0f);
    CHECK(channels(cook_torrance, 1, always).microfacet.D.at(0) > 0.0f);
}

TEST_CASE("reflect: an unlit surface reflects nothing") {
    const PointMaterial material{ReflectionModel::unlit, {}, nullptr, {}};
    const ReflectedTerms terms = reflect(material, {0, 0, 1}, {0, 0, 1}, {0, 0, 1});
    CHECK(terms.diffuse == glm::vec3(0.0f));
    CHECK(terms.specular == glm::vec3(0.0f));
}
