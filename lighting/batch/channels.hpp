// The named quantities of a batch while it is lit: what the passes write for each other and for the pictures of stages.
#pragma once

#include "lighting/cook_torrance_setup.hpp"
#include "lighting/environment/texel_taps.hpp"
#include "raster/fragments.hpp"

namespace kreda::lighting {

/// A vector or a colour at every point. Where it is the same at all of them it stands here once: no channel has to be
/// written for it, and none read.
struct EvenOrChannel {
    bool is_even = false;   ///< the same everywhere: `even`
    glm::vec3 even{0.0f};   ///< its value then
    raster::Channel3 each;  ///< its value at each point otherwise

    /// Its value at point i, in whichever way. Loops over a batch ask once, by with_quantity().
    [[nodiscard]] glm::vec3 at(int i) const {
        return is_even ? even : each.at(i);
    }
    /// The same everywhere from now on.
    void set_all(const glm::vec3& v) {
        is_even = true;
        even = v;
    }
};

/// use(value), where value(i) is the quantity at point i: two loops, one for each way.
template <class Use>
inline void with_quantity(const EvenOrChannel& quantity, Use use) {
    if (quantity.is_even) return use([v = quantity.even](int) { return v; });
    use([&quantity](int i) { return quantity.each.at(i); });
}

/// What a material says of its surface at every point. Where no map says it, it is the same at all of them and stands
/// here once, as EvenOrChannel does.
struct SurfaceChannels {
    bool is_even = false;                        ///< the same everywhere: `even`
    MicrofacetSurface even;                      ///< the material's constants then
    raster::Channel3 albedo;                     ///< otherwise c, linear RGB
    raster::Channel3 f0;                         ///< reflectance at normal incidence
    raster::Channel metallic, roughness, alpha;  ///< each in [0, 1]; alpha = roughness^2, at least kMinAlpha

    /// The surface at point i as the channels have it.
    [[nodiscard]] MicrofacetSurface each(int i) const {
        return {albedo.at(i), f0.at(i), metallic.at(i), roughness.at(i), alpha.at(i)};
    }
    /// The surface at point i, in whichever way. Loops over a batch ask once, by with_surface().
    [[nodiscard]] MicrofacetSurface at(int i) const {
        return is_even ? even : each(i);
    }
    /// The same everywhere from now on.
    void set_all(const MicrofacetSurface& s) {
        is_even = true;
        even = s;
    }
};

/// use(surface), where surface(i) is the surface at point i: two loops, one for each way.
template <class Use>
inline void with_surface(const SurfaceChannels& surface, Use use) {
    if (surface.is_even) return use([s = surface.even](int) { return s; });
    use([&surface](int i) { return surface.each(i); });
}

/// The quantities of the microfacet model at every point; they hold something only where the material is cook_torrance.
struct MicrofacetChannels {
    SurfaceChannels surface;                             ///< c, F0, metallic, roughness, alpha
    raster::Channel ao;                                  ///< share of the environment's light that arrives, [0, 1]
    raster::Channel n_dot_l, n_dot_v, n_dot_h, v_dot_h;  ///< of the light that is being added, in [0, 1]
    raster::Channel sin2_h;                              ///< 1 - (n.h)^2
    raster::Channel D;                                   ///< of the light that is being added
    raster::Channel V;                                   ///< G / (4 (n.l)(n.v)) of that light
    raster::Channel3 F;                                  ///< at v.h, of that light
};

/// What the environment sends and what becomes of it; they hold something only where the scene has an environment.
struct EnvironmentChannels {
    raster::Channel3 direction;      ///< world space: r; of the background the way a sample looks
    raster::Channel3 map_direction;  ///< n, r or l as the maps know it, where they are turned
    raster::Channel3 irradiance;     ///< E on n
    raster::Channel3 prefiltered;    ///< P: radiance around r, as blurred as the surface is rough
    raster::Channel lod;             ///< level of the prefiltered map, where it is not the same everywhere
    raster::Channel3 brdf;           ///< A, B and the mean energy of the roughness
    raster::Channel3 F;              ///< at n.v
    raster::Channel3 diffuse;        ///< of ambient, what comes from the environment by diffuse reflection
    raster::Channel3 specular;       ///< and by specular reflection
    raster::Channel error;           ///< of a sum over samples: its standard error, luminance (environment.reference)
    TapScratch scratch;              ///< what a look-up in a map needs, used again by the next one
};

/// Every quantity of the lecture's equation at every point of a batch.
struct LightingChannels {
    raster::Channel level;          ///< level of detail at which the maps are read (trilinear)
    raster::Channel3 m_D;           ///< diffuse reflectance, where a map gives it
    raster::Channel3 map_emission;  ///< what the emission map says: m_E is the constant times it
    raster::Channel3 map_normal;    ///< what the normal map says: t, b, n components, not unit
    raster::Channel3 n;             ///< unit normal
    raster::Channel3 v;             ///< unit, to the viewer
    raster::Channel3 t;             ///< unit, in the surface: the way scratches or threads run (ward, heidrich_seidel)
    EvenOrChannel l;                ///< unit, to the light that is being added; even: a directional light
    EvenOrChannel irradiance;       ///< what that light sends, s(p); in shadow what the shadow leaves of it
    bool one_v = false;             ///< v is the same at every point: a parallel projection
    raster::Channel n_dot_l;        ///< of that light; negative where the surface faces away from it
    raster::Channel sigma;          ///< Sigma of that light; phong and blinn_phong
    raster::Channel
        highlight;           ///< Sigma^h of that light, 0 where the surface faces away from it; phong and blinn_phong
    raster::Channel shadow;  ///< of that light: 1 lit .. 0 in full shadow; only where it casts shadows
    raster::Channel
        blocker_distance;      ///< from a point back to what keeps that light from it, world units; only for views
    raster::Channel penumbra;  ///< width of that shadow's soft edge there, world units; only for views
    EvenOrChannel ambient;     ///< s_A m_A + m_E and what the environment adds
    bool is_lit = false;       ///< a light was added: before, diffuse and specular hold nothing and count as 0
    bool is_last = false;      ///< no light follows, and nobody looks at diffuse and specular: radiance alone is wanted
    bool is_summed = false;    ///< radiance holds the sum already
    raster::Channel3 diffuse;  ///< sum over lights of s m_D (l.n)
    raster::Channel3 specular;        ///< sum over lights of s m_S Sigma^h
    raster::Channel fog;              ///< f
    raster::Channel3 radiance;        ///< what leaves toward the viewer: linear RGB
    MicrofacetChannels microfacet;    ///< cook_torrance only
    EnvironmentChannels environment;  ///< only with an environment
};

}  // namespace kreda::lighting
