// Explain, shadow maps: where a point lies in the light's picture, the bias, what each tap of the filter compared.
#include <cmath>

#include "scene/files/scene_keys.hpp"
#include "shadows/filter_taps.hpp"
#include "tools/explain/explain_shadow.hpp"

namespace kreda::tools {

namespace {

using shadows::BiasTerms;
using shadows::FilterTap;
using shadows::LightView;
using shadows::MapPoints;
using shadows::MapSteps;
using shadows::PictureScale;
using shadows::PointInView;
using shadows::ShadowBias;
using shadows::ShadowMap;

constexpr const char* kFaceNames[6] = {"+x", "-x", "+y", "-y", "+z", "-z"};

/// A filter with more taps than this is told by those that decide.
constexpr std::size_t kMostTapsListed = 81;

std::string stored_text(float distance) {
    return distance < shadows::kNoCaster ? number_text(distance) : "nothing casts";
}

std::string range_text(const LightView& view) {
    return "(" + number_text(view.far) + " - " + number_text(view.near) + ")";
}

/// Clip space and the picture, from the light's own camera: what the rasterizer made of the map's triangles.
void explain_place(const LitPoint& point, const ShadowMap& map, const PointInView& in_view, Section& section) {
    const bool is_cube = map.plan.views.size() > 1;
    const LightView& view = map.plan.views[static_cast<std::size_t>(in_view.face)];
    const glm::vec3 p = point.points.position.at(0);
    const glm::vec4 clip = clip_from_world(view) * glm::vec4(p, 1.0f);
    section.equation(
        "q", view.perspective ? "axes (p - p_light)" : "axes (p - origin)", "axes " + vector_text(p - view.origin),
        in_view.q,
        "in the light's view: right, up, backward" +
            std::string(is_cube ? ", face " + std::string(kFaceNames[in_view.face]) + " of the cube" : ""));
    section.equation("clip", "clip_from_world (p, 1)", "", std::vector<double>{clip.x, clip.y, clip.z, clip.w},
                     "of the light's camera, near " + number_text(view.near) + ", far " + number_text(view.far));
    if (clip.w > 0.0f) {
        section.equation("ndc", "clip / w", vector_text(glm::vec3(clip)) + " / " + number_text(clip.w),
                         glm::vec3(clip) / clip.w);
    }
    section.equation("n_q", "axes normal / |normal|", "", in_view.n, "the surface's plane in the light's view");
}

void explain_slope(const MapSteps& steps, const PointInView& in_view, const PictureScale& scale, bool perspective,
                   Section& section) {
    const std::string texel = vector_text(scale.texel);
    section.equation("slope", perspective ? "d (n_x, -n_y) texel / -(n·q/d)" : "(n_x, -n_y) texel / n_z",
                     (perspective ? number_text(steps.distance) + " " : "") +
                         vector_text(glm::vec2(in_view.n.x, -in_view.n.y)) + " ⊗ " + texel + " / " +
                         number_text(perspective ? -glm::dot(in_view.n, steps.moved) / steps.distance : in_view.n.z),
                     std::vector<double>{steps.slope.u, steps.slope.v},
                     "how much farther the surface lies one texel to the right and down");
    section.equation("B", "(|slope_u| + |slope_v|) / 2",
                     "(|" + number_text(steps.slope.u) + "| + |" + number_text(steps.slope.v) + "|) / 2",
                     least_bias(steps.slope), "the least bias of a flat surface");
}

void explain_offset(const MapSteps& steps, const PointInView& in_view, Section& section) {
    if (steps.offset == 0.0f) return;
    section.equation("q", "q + offset n_q",
                     vector_text(in_view.q) + " + " + factor_text(steps.offset) + "·" + vector_text(in_view.n),
                     steps.moved,
                     steps.cosine < 0.0f ? "turned away from the light: looked up a little inside"
                                         : "moved along the normal by slope_bias texels (|n_x| + |n_y|) / 2");
}

/// d, what the bias takes off it, and where that lies in the map.
void explain_bias(const ShadowMap& map, const MapSteps& steps, const PointInView& in_view, const MapPoints& points,
                  Section& section) {
    const LightView& view = map.plan.views.front();
    const PictureScale scale = picture_scale(view, map.size());
    const BiasTerms terms = bias_terms(map.plan.settings, view.far - view.near);
    explain_offset(steps, in_view, section);
    section.equation("d", "-q_z", "", steps.distance, "distance along the light's axis");
    const glm::vec2 moved(steps.moved.x, -steps.moved.y);
    const std::string d = view.perspective ? number_text(steps.distance) + " " : "";
    section.equation("texel", view.perspective ? "(q_x, -q_y) / (d side) + size/2" : "(q_x, -q_y) / side + size/2",
                     vector_text(moved) + " / (" + d + vector_text(scale.texel) + ") + " + number_text(scale.half_side),
                     std::vector<double>{points.u.at(0), points.v.at(0)},
                     "side: a texel's width and height; column and row are the whole parts");
    const std::string constant = number_text(map.plan.settings.constant_bias);
    switch (map.plan.settings.bias) {
        case ShadowBias::none: section.equation("bias", "", "", 0.0f, "shadow.bias = \"none\""); break;
        case ShadowBias::constant:
        case ShadowBias::normal_offset:
            section.equation("bias", "constant_bias (far - near)", constant + " " + range_text(view), terms.constant);
            break;
        case ShadowBias::slope:
            explain_slope(steps, in_view, scale, view.perspective, section);
            section.equation("bias", "constant_bias (far - near) + slope_bias B",
                             constant + " " + range_text(view) + " + " + number_text(steps.slope_share) + "·" +
                                 number_text(least_bias(steps.slope)),
                             terms.constant + steps.slope_share * least_bias(steps.slope),
                             steps.cosine < 0.0f ? "a surface that is turned away is dark anyway: no slope_bias" : "");
            break;
    }
    section.equation("d'", "d - bias", "", points.distance.at(0), "what is compared with the map");
    const bool follows = map.plan.settings.filter != shadows::ShadowFilter::none && terms.follow_plane != 0.0f;
    if (!follows) return;
    section.equation("d'(Δ)", "d' + slope·Δ",
                     number_text(points.distance.at(0)) + " + (" + number_text(points.slope_u.at(0)) + ", " +
                         number_text(points.slope_v.at(0)) + ")·Δ",
                     std::vector<double>{}, "at a tap Δ texels beside the point: on the surface's plane");
}

Table taps_table(const char* name, const std::vector<FilterTap>& taps, const char* verdict_lit,
                 const char* verdict_dark, bool lit_means_dark) {
    Table table{name, {"tap at", "stored", "d' there", "the light is"}, {}};
    for (const FilterTap& tap : taps) {
        const bool dark = lit_means_dark ? tap.lit > 0.0f : tap.lit == 0.0f;
        table.rows.push_back({vector_text(glm::vec2(tap.u, tap.v)), stored_text(tap.stored), number_text(tap.compared),
                              dark ? verdict_dark : verdict_lit});
    }
    return table;
}

/// A picture of a filter in letters, a row a row of taps.
Table picture_of_taps(const char* name, const std::vector<FilterTap>& taps) {
    Table table{name, {}, {}};
    for (std::size_t i = 0; i < taps.size(); ++i) {
        if (i == 0 || taps[i].v != taps[i - 1].v) table.rows.push_back({""});
        const bool all = taps[i].lit == taps[i].weight;
        table.rows.back()[0] += all ? "." : "#";
    }
    return table;
}

float explain_box(const std::vector<FilterTap>& taps, Section& section) {
    float lit = 0.0f;
    for (const FilterTap& tap : taps) lit += tap.lit;
    section.say("Lit where d' <= stored:");
    if (taps.size() <= kMostTapsListed)
        section.put(taps_table("taps", taps, "let through: d' <= stored", "stopped: d' > stored", false));
    else
        section.put(picture_of_taps("taps", taps));
    const float count = static_cast<float>(taps.size());
    const float shadow = lit * (1.0f / count);
    section.equation("shadow", taps.size() == 1 ? "lit" : "lit taps / taps",
                     taps.size() == 1 ? "" : number_text(lit) + " / " + number_text(count), shadow);
    return shadow;
}

/// pcss, step one: who stands in the cone of rays to the light?
void explain_search(const shadows::SoftTaps& soft, Section& section) {
    section.equation("search", "half the cone to the light at the nearest caster, in texels", "",
                     std::vector<double>{soft.search_half_u, soft.search_half_v});
    std::vector<FilterTap> blockers;
    for (const FilterTap& tap : soft.search) {
        if (tap.lit > 0.0f) blockers.push_back(tap);
    }
    section.say(std::to_string(soft.search.size()) +
                " cells were searched; these block (stored < d', within the cone):");
    if (blockers.empty()) return;
    section.put(taps_table("blockers", blockers, "", "stopped by it", true));
    std::string sum;
    for (std::size_t i = 0; i < blockers.size() && i < 4; ++i) {
        sum += (i ? " + " : "") + number_text(blockers[i].stored);
    }
    section.equation("d_b", "Σ stored / blockers",
                     "(" + sum + (blockers.size() > 4 ? " + ..." : "") + ") / " + std::to_string(blockers.size()),
                     soft.blocker, "mean distance of the blockers");
}

void explain_penumbra(const ShadowMap& map, const MapPoints& points, const shadows::SoftTaps& soft, Section& section) {
    shadows::SoftShadow shadow;
    raster::Channel before, width;
    find_blockers(map, points, raster::lanes_for(1), shadow);
    penumbra_widths(map, points, raster::lanes_for(1), shadow, before, width);
    const bool perspective = map.plan.views.front().perspective;
    const std::string d = number_text(points.distance.at(0)), d_b = number_text(soft.blocker);
    const std::string size = number_text(map.plan.settings.light_size);
    section.equation("before", "d' - d_b", d + " - " + factor_text(soft.blocker), before.at(0),
                     "how far before the point they lie");
    section.equation("penumbra", perspective ? "light_size (d' - d_b) / d_b" : "light_size (d' - d_b)",
                     size + " (" + d + " - " + factor_text(soft.blocker) + ")" + (perspective ? " / " + d_b : ""),
                     width.at(0), "world units");
}

float explain_soft(const ShadowMap& map, const MapPoints& points, Section& section) {
    const shadows::SoftTaps soft = soft_taps(map, points);
    explain_search(soft, section);
    if (!soft.blocked) {
        section.equation("shadow", "", "", 1.0f, "nothing blocks a part of the light");
        return 1.0f;
    }
    explain_penumbra(map, points, soft, section);
    section.equation("filter", "half the penumbra in the map, at least 1/2", "",
                     std::vector<double>{soft.half_u, soft.half_v}, "texels");
    float lit = 0.0f, area = 0.0f;
    for (const FilterTap& tap : soft.filter) {
        lit += tap.lit;
        area += tap.weight;
    }
    section.say("Cells of the filter, . lit and # dark (d' > stored); each counts by the area of it that lies inside:");
    if (soft.filter.size() <= kMostTapsListed) {
        Table table{"taps", {"tap at", "stored", "d' there", "area", "of it lit"}, {}};
        for (const FilterTap& tap : soft.filter) {
            table.rows.push_back({vector_text(glm::vec2(tap.u, tap.v)), stored_text(tap.stored),
                                  number_text(tap.compared), number_text(tap.weight), number_text(tap.lit)});
        }
        section.put(table);
    } else {
        section.put(picture_of_taps("taps", soft.filter));
    }
    const float shadow = lit / (area > 0.0f ? area : 1.0f);
    section.equation("shadow", "lit area / area", number_text(lit) + " / " + number_text(area), shadow);
    return shadow;
}

}  // namespace

float explain_shadow_map(const LitPoint& point, const ShadowMap& map, Section& section) {
    const raster::Fragments& f = point.points;
    const LightView& view = map.plan.views.front();
    const bool is_cube = map.plan.views.size() > 1;
    const glm::vec3 p = f.position.at(0), normal = f.face_normal.at(0);
    const PointInView in_view = is_cube ? shadows::point_in_cube(view.origin, p, normal)
                                        : shadows::point_in_picture(view.view_from_world, view.origin, p, normal);
    const PictureScale scale = picture_scale(view, map.size());
    const BiasTerms terms = bias_terms(map.plan.settings, view.far - view.near);
    const MapSteps steps = view.perspective ? map_steps_perspective(in_view.q, in_view.n, scale, terms)
                                            : map_steps_parallel(in_view.q, in_view.n, scale, terms);
    MapPoints points{};
    locate(map, f.position, f.face_normal, raster::lanes_for(1), points);
    explain_place(point, map, in_view, section);
    explain_bias(map, steps, in_view, points, section);
    switch (map.plan.settings.filter) {
        case shadows::ShadowFilter::none: return explain_box(box_taps(map, points, 0), section);
        case shadows::ShadowFilter::pcf: return explain_box(box_taps(map, points, map.plan.settings.radius), section);
        case shadows::ShadowFilter::pcss: return explain_soft(map, points, section);
    }
    return 1.0f;
}

}  // namespace kreda::tools
