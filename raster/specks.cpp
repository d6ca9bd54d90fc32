#include "raster/specks.hpp"

#include <algorithm>
#include <utility>

namespace kreda::raster {

namespace {

// Measured on the meshes of docs/15_mesh.md: nothing depends much on either number.
constexpr std::uint32_t kMostOfSpeck = 3;   // triangles
constexpr std::uint32_t kLeastAround = 16;  // times as many triangles as the speck

/// A region of few triangles and another one that it borders on, both by their least triangle.
using Border = std::pair<std::uint32_t, std::uint32_t>;

/// Triangles that hang together without a crease.
struct Regions {
    Clusters triangles;
    std::vector<std::uint32_t> size;  // at a region's least triangle

    Regions(std::uint32_t count, const std::vector<SharedEdge>& edges, const std::vector<bool>& is_crease)
        : triangles(count), size(count, 0) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (!is_crease[i]) triangles.unite(edges[i].triangle_a(), edges[i].triangle_b());
        }
        for (std::uint32_t t = 0; t < count; ++t) ++size[triangles.find(t)];
    }
};

/// One entry for each edge of a region that is small enough for a speck, sorted.
std::vector<Border> borders_of_small(Regions& regions, const std::vector<SharedEdge>& edges) {
    std::vector<Border> borders;
    for (const SharedEdge& edge : edges) {
        const std::uint32_t a = regions.triangles.find(edge.triangle_a()),
                            b = regions.triangles.find(edge.triangle_b());
        if (a == b) continue;
        if (regions.size[a] <= kMostOfSpeck) borders.emplace_back(a, b);
        if (regions.size[b] <= kMostOfSpeck) borders.emplace_back(b, a);
    }
    std::ranges::sort(borders);
    return borders;
}

/// Specks and the regions around them, sorted.
std::vector<Border> find_specks(Regions& regions, const std::vector<SharedEdge>& edges) {
    const std::vector<Border> borders = borders_of_small(regions, edges);
    std::vector<Border> specks;
    for (auto first = borders.begin(); first != borders.end();) {
        const auto end = std::find_if(first, borders.end(), [&](const Border& b) { return b.first != first->first; });
        const Border middle = *(first + (end - first) / 2);  // who holds more than half of the edges stands here
        const bool is_enclosed = 2 * std::count(first, end, middle) > end - first;
        const bool is_large = regions.size[middle.second] >= kLeastAround * regions.size[middle.first];
        if (is_enclosed && is_large) specks.push_back(middle);
        first = end;
    }
    return specks;
}

}  // namespace

void smooth_over_specks(std::uint32_t triangles, const std::vector<SharedEdge>& edges, std::vector<bool>& is_crease) {
    Regions regions(triangles, edges, is_crease);
    const std::vector<Border> specks = find_specks(regions, edges);
    const auto joins = [&](std::uint32_t a, std::uint32_t b) {
        return std::ranges::binary_search(specks, Border{a, b});
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (!is_crease[i]) continue;
        const std::uint32_t a = regions.triangles.find(edges[i].triangle_a()),
                            b = regions.triangles.find(edges[i].triangle_b());
        if (joins(a, b) || joins(b, a)) is_crease[i] = false;
    }
}

}  // namespace kreda::raster
