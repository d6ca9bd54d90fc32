#include "lighting/batch/highlight_passes.hpp"

#include "lighting/batch/add_light.hpp"
#include "lighting/batch/model_loop.hpp"
#include "lighting/reflection.hpp"
#include "raster/platform.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

namespace {

using raster::lanes_for;

/// use(Sigma), where Sigma(n, l, v, n_dot_l) is the measure of reflection of Phong's model or of Blinn's.
template <class Use>
inline void with_sigma(ReflectionModel model, Use use) {
    if (model == ReflectionModel::phong) {
        return use([](const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, float n_dot_l) {
            return sigma_phong(v, mirror_vector(n, l, n_dot_l));
        });
    }
    use([](const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, float) {
        return sigma_blinn(n, half_vector(l, v));
    });
}

KREDA_BATCH_LOOP void set_sigma(int lanes, ReflectionModel model, LightingChannels& c) {
    with_sigma(model, [&](auto Sigma) {
        with_quantity(c.l, [&](auto l) {
            for (int i = 0; i < lanes; ++i) {  // 4 formulas
                c.sigma.set(i, Sigma(c.n.at(i), l(i), c.v.at(i), c.n_dot_l.at(i)));
            }
        });
    });
}

/// Blinn's Sigma where l and v, and so h, are the same at every point.
KREDA_BATCH_LOOP void set_sigma_of_one_h(int lanes, glm::vec3 h, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.sigma.set(i, sigma_blinn(c.n.at(i), h));
}

/// How many lanes have a highlight: they face the light, and their Sigma is above `least`.
KREDA_BATCH_LOOP int lanes_with_highlight(int lanes, float least, const LightingChannels& c) {
    int shining = 0;
    for (int i = 0; i < lanes; ++i) shining += c.sigma.at(i) * faces_light(c.n_dot_l.at(i)) > least ? 1 : 0;
    return shining;
}

/// Is any highlight of the batch above 0? Up to Sigma = 2^(-127/h) the power is below 2^-126, which pow counts as 0.
/// (0^0 = 1: a shininess of 0 lights everything that faces the light.)
bool any_highlight(int lanes, float shininess, const LightingChannels& c) {
    const float least = raster::exp2(-127.0f / shininess);
    return shininess == 0.0f || lanes_with_highlight(lanes, least, c) > 0;
}

/// The highlight   highlight_of(Sigma, n.l, m)
/// Its pow in two loops: the shorter a loop, the more points a processor has under way (a seventh faster).
KREDA_BATCH_LOOP void raise_sigma(int lanes, float h, LightingChannels& c) {
    raster::Channel high, low;
    for (int i = 0; i < lanes; ++i) {
        const raster::TwoFloats exponent = raster::log2_of_pow(c.sigma.at(i), h);
        high.set(i, exponent.high);
        low.set(i, exponent.low);
    }
    for (int i = 0; i < lanes; ++i) {
        const float power = raster::pow_from_log2({high.at(i), low.at(i)}, h);
        c.highlight.set(i, power * faces_light(c.n_dot_l.at(i)));
    }
}

KREDA_BATCH_LOOP void no_highlight(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.highlight.set(i, 0.0f);  // not vectorized: GCC makes it a call of memset
}

KREDA_BATCH_LOOP void add_phong_terms(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c,
              [&c](int i, const PhongMaterial& m) { return phong_terms(c.n_dot_l.at(i), c.highlight.at(i), m); });
}

}  // namespace

void add_highlights(int count, const Material& material, bool map, LightingChannels& c) {
    const int lanes = lanes_for(count);
    if (material.model == ReflectionModel::blinn_phong && c.l.is_even && c.one_v)
        set_sigma_of_one_h(lanes, half_vector(c.l.even, c.v.at(0)), c);
    else
        set_sigma(lanes, material.model, c);
    if (any_highlight(lanes, material.phong.shininess, c))
        raise_sigma(lanes, material.phong.shininess, c);
    else
        no_highlight(lanes, c);
    add_phong_terms(lanes, material.phong, map, c);
}

}  // namespace kreda::lighting
