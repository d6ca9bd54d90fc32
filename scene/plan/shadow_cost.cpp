#include "scene/plan/shadow_cost.hpp"

#include <algorithm>
#include <cmath>

namespace kreda::scene {

namespace {

using shadows::ShadowMethod;

constexpr double kDrawSample = 14.0;  // as the visibility pass: a depth, compared
constexpr double kProject = 40.0;     // axes, division, scale, bias

double triangles_of(const Scene& scene, const PlannedShadow& shadow) {
    double count = 0.0;
    for (const int object : shadow.casters) {
        count += static_cast<double>(scene.objects[static_cast<std::size_t>(object)].mesh->triangle_count());
    }
    return count;
}

/// Levels of a tree whose leaves hold two triangles.
double tree_levels(double triangles) {
    return std::log2(std::max(triangles, 2.0));
}

/// Every tap of a filter: the plane's distance there, the texel, the comparison.
double map_operations(const shadows::ShadowSettings& settings) {
    constexpr double kTap = 6.0, kSearchCell = 40.0, kFilterCell = 45.0;
    constexpr double kSearchCells = 17.0 * 17.0, kFilterCells = 25.0 * 25.0;  // the most that soft_filter.cpp reads
    switch (settings.filter) {
        case shadows::ShadowFilter::none: return kProject;
        case shadows::ShadowFilter::pcf: {
            const double side = 2.0 * settings.radius + 1.0;
            return kProject + kTap * side * side;
        }
        case shadows::ShadowFilter::pcss: return kProject + kSearchCell * kSearchCells + kFilterCell * kFilterCells;
    }
    return kProject;
}

}  // namespace

PassCost shadow_pass_cost(const Scene& scene, const PlannedShadow& shadow, std::uint64_t samples) {
    const auto casters = static_cast<double>(shadow.casters.size());
    const double triangles = triangles_of(scene, shadow);
    switch (shadow.map.settings.method) {
        case ShadowMethod::map: {
            const auto side = static_cast<std::uint64_t>(shadow.map.settings.size);
            return {"texels", shadow.map.views.size() * side * side, kDrawSample};
        }
        case ShadowMethod::exact: {
            constexpr double kSort = 45.0;  // a triangle in the bins of three axes, once a level
            return {"triangles", static_cast<std::uint64_t>(triangles), kSort * tree_levels(triangles)};
        }
        case ShadowMethod::planar:
            return {"samples", samples, kDrawSample * casters * static_cast<double>(shadow.receivers.size())};
        case ShadowMethod::volume: {
            constexpr double kFaces = 2.0;  // a way in and a way out
            return {"samples", samples, kDrawSample * casters * kFaces};
        }
        case ShadowMethod::irregular: {
            constexpr double kEdges = 3.0 * 7.0;
            return {"samples", samples, kProject + casters * kEdges};
        }
    }
    return {};
}

double shadow_look_up_operations(const Scene& scene, const PlannedShadow& shadow) {
    switch (shadow.map.settings.method) {
        case ShadowMethod::map: return map_operations(shadow.map.settings);
        case ShadowMethod::exact: {
            constexpr double kTwoBoxes = 28.0, kTwoTriangles = 120.0;  // a level; a leaf
            return kTwoBoxes * tree_levels(triangles_of(scene, shadow)) + kTwoTriangles;
        }
        case ShadowMethod::planar:
        case ShadowMethod::volume:
        case ShadowMethod::irregular: return 0.0;  // found before, read by the sample's number
    }
    return 0.0;
}

}  // namespace kreda::scene
