// The keys of all tables but [[material]] and [[object]].
#include "scene/files/key_tables.hpp"

namespace kreda::scene {

const std::vector<Key<ImageSettings>>& image_keys() {
    using I = ImageSettings;
    static const std::vector<Key<I>> keys = rows_of<I>(
        "image",
        {
            pair_row("size", &I::width, &I::height, "width and height in pixels", {.range = {1, 16384}}),
            row<I>("samples", &I::samples, "n x n supersampling", {.range = {1, 8}}),
            own_row<I>("background", KeyType::vector_or_word, "linear RGB, or what surrounds the scene",
                       {.range = kNotNegative, .words = {"environment"}, .by_default = text_of(I{}.background)},
                       [](const Value& value, I& image) {
                           image.environment_background = value.kind == ValueKind::text;  // the only word
                           if (!image.environment_background) set_member(value, image.background);
                       }),
            row<I>("exposure", &I::exposure, "multiplies radiance before tone mapping", {.range = kNotNegative}),
            row<I>("tone_map", &I::tone_map, "radiance to 0..1; none: clamp",
                   {.words = {"none", "reinhard", "reinhard_extended"}}),
            row<I>("white", &I::white, "reinhard_extended: the radiance that maps to 1", {.range = kPositive}),
            row<I>("transfer", &I::transfer, "linear values to the file's 8 bits",
                   {.words = {"srgb", "gamma", "linear"}}),
            row<I>("gamma", &I::gamma, "transfer = \"gamma\": the exponent", {.range = kPositive}),
        });
    return keys;
}

const std::vector<Key<CameraTable>>& camera_keys() {
    using T = CameraTable;
    using C = raster::Camera;
    const auto camera = [](auto member) { return within(&T::camera, member); };
    static const std::vector<Key<T>> keys = rows_of<T>(
        "camera",
        {
            row<T>("position", &T::position, "where the camera is", {.range = kPlace}),
            row<T>("target", &T::target, "the point it looks at", {.range = kPlace}),
            row<T>("up", camera(&C::up), "what is up in the picture"),
            row<T>("orbit", &T::orbit_deg, "degrees that the camera goes round the target, about the axis up"),
            row<T>("projection", camera(&C::projection), "how depth becomes size",
                   {.words = {"perspective", "orthographic"}}),
            row<T>("vertical_fov", camera(&C::vertical_fov_deg), "perspective: degrees from bottom to top",
                   {.range = {0, 180, true}}),
            row<T>("height", camera(&C::height), "orthographic: world units from bottom to top", {.range = kPositive}),
            row<T>("near", camera(&C::near), "distance of the near plane", {.range = kPositive}),
            row<T>("far", camera(&C::far), "distance of the far plane, beyond near", {.range = kPositive}),
        });
    return keys;
}

const std::vector<Key<ShadingSettings>>& shading_keys() {
    using S = ShadingSettings;
    static const std::vector<Key<S>> keys = rows_of<S>(
        "shading",
        {
            row<S>("frequency", &S::frequency, "light per triangle, per vertex or per pixel",
                   {.words = {"flat", "gouraud", "phong"}}),
            row<S>("rate", &S::rate, "phong: a point is lit for n x n samples of a triangle", {.range = {1, 8}}),
            row<S>("interpolation", &S::interpolation, "affine shows why not", {.words = {"perspective", "affine"}}),
            row<S>("cull", &S::cull, "which side of a triangle is not drawn", {.words = {"back", "front", "none"}}),
            row<S>("two_sided", &S::two_sided,
                   "where cull lets a back be seen: its normal is turned to the viewer; false takes the light of the "
                   "front"),
        });
    return keys;
}

const std::vector<Key<Scene>>& ambient_keys() {
    static const std::vector<Key<Scene>> keys = rows_of<Scene>(
        "ambient", {
                       row<Scene>("color", &Scene::ambient, "s_A: light from everywhere", {.range = kNotNegative}),
                   });
    return keys;
}

const std::vector<Key<LightTable>>& light_keys() {
    using T = LightTable;
    using L = lighting::Light;
    const auto light = [](auto member) { return within(&T::light, member); };
    const L implied;
    static const std::vector<Key<T>> keys = rows_of<T>(
        "light", {
                     row<T>("type", light(&L::type), "the sun, a lamp, or a lamp in a cone",
                            {.words = {"directional", "point", "spot"}}),
                     row<T>("direction", light(&L::direction), "directional, spot: the way the light travels"),
                     row<T>("position", &T::position, "point, spot: where it is", {.range = kPlace}),
                     row<T>("color", light(&L::color), "linear RGB", {.range = kNotNegative}),
                     row<T>("intensity", light(&L::intensity), "multiplies color", {.range = kNotNegative}),
                     own_row<T>("attenuation", KeyType::vector_or_word, "1 / (c + l d + q d^2); \"physical\": 1 / d^2",
                                {.range = kNotNegative, .words = {"physical"}, .by_default = "[1, 0, 0]"},
                                [](const Value& value, T& table) {
                                    glm::vec3 c_l_q{0.0f, 0.0f, 1.0f};  // "physical", the only word
                                    if (value.kind != ValueKind::text) set_member(value, c_l_q);
                                    table.light.attenuation = {c_l_q.x, c_l_q.y, c_l_q.z};
                                }),
                     own_row<T>("cone", KeyType::number_pair,
                                "spot: half-angles in degrees; full light inside the first, none outside the second",
                                {.range = {0, 180},
                                 .by_default = text_of(glm::vec2(implied.inner_cone_deg, implied.outer_cone_deg))},
                                [](const Value& value, T& table) {
                                    set_member(value.items[0], table.light.inner_cone_deg);
                                    set_member(value.items[1], table.light.outer_cone_deg);
                                }),
                     row<T>("shadow", light(&L::shadow), "whether it casts shadows"),
                     row<T>("on", light(&L::on), "false switches it off"),
                 });
    return keys;
}

const std::vector<Key<shadows::ShadowSettings>>& shadow_keys() {
    using S = shadows::ShadowSettings;
    static const std::vector<Key<S>> keys = rows_of<S>(
        "shadow",
        {
            row<S>("method", &S::method, "how shadows are found",
                   {.words = {"map", "planar", "volume", "irregular", "exact"}}),
            row<S>("size", &S::size, "map: texels a side", {.range = {1, 8192}}),
            row<S>("filter", &S::filter, "map: hard edges, blurred ones, or as soft as the light is wide",
                   {.words = {"none", "pcf", "pcss"}}),
            row<S>("radius", &S::radius, "pcf: mean of (2 radius + 1)^2 texels", {.range = {0, 64}}),
            row<S>("light_size", &S::light_size, "pcss: the light's width; directional: seen from distance 1",
                   {.range = kNotNegative}),
            row<S>("bias", &S::bias, "map: what keeps a surface from shadowing itself",
                   {.words = {"none", "constant", "slope", "normal_offset"}}),
            row<S>("constant_bias", &S::constant_bias, "share of the map's range of depth", {.range = kNotNegative}),
            row<S>("slope_bias", &S::slope_bias, "slope, normal_offset: times the least that a flat surface needs",
                   {.range = kNotNegative}),
            row<S>("cull", &S::cull, "map: which side of a triangle casts nothing",
                   {.words = {"back", "front", "none"}}),
        });
    return keys;
}

const std::vector<Key<lighting::Fog>>& fog_keys() {
    using F = lighting::Fog;
    static const std::vector<Key<F>> keys = rows_of<F>(
        "fog",
        {
            row<F>("mode", &F::mode, "how the surface fades with distance",
                   {.words = {"none", "linear", "exp", "exp2"}}),
            row<F>("color", &F::color, "linear RGB", {.range = kNotNegative}),
            row<F>("start", &F::start, "linear: distance where fog begins"),
            row<F>("end", &F::end, "linear: distance where nothing else is seen"),
            row<F>("density", &F::density, "exp, exp2: per world unit", {.range = kNotNegative}),
            row<F>("distance", &F::distance, "from the eye, or from its plane", {.words = {"radial", "planar"}}),
            row<F>("frequency", &F::frequency, "computed per pixel or per vertex", {.words = {"pixel", "vertex"}}),
        });
    return keys;
}

const std::vector<Key<EnvironmentSettings>>& environment_keys() {
    using E = EnvironmentSettings;
    static const std::vector<Key<E>> keys = rows_of<E>(
        "environment",
        {
            row<E>("file", &E::file,
                   "light from an equirectangular image: .hdr, .exr; 8 or 16 bits are decoded as sRGB",
                   {.example = "\"studio.hdr\""}),
            row<E>("sky", &E::sky, "or from a built-in sky",
                   {.words = {"studio", "sunset", "gradient"}, .example = "\"studio\"", .by_default = ""}),
            row<E>("rotation", &E::rotation_deg, "degrees about +y"),
            row<E>("intensity", &E::intensity, "multiplies its light", {.range = kNotNegative}),
            row<E>("irradiance", &E::irradiance, "diffuse light: a map, or nine coefficients",
                   {.words = {"map", "sh9"}}),
            row<E>("samples", &E::samples, "specular light: samples baked for roughness 1", {.range = {32, 65536}}),
            row<E>("reference", &E::reference,
                   "0: the split sum; else samples a point of the integral itself, in each of three ways",
                   {.range = {0, 65536}}),
            row<E>("on", &E::on, "false switches it off", {.by_default = "true"}),  // where there is an [environment]
        });
    return keys;
}

}  // namespace kreda::scene
