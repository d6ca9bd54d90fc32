#include "shadows/bvh.hpp"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

#include "raster/scalar_math.hpp"

namespace kreda::shadows {

namespace {

constexpr int kBins = 16;
constexpr std::uint32_t kLeafTriangles = 4;
constexpr std::size_t kMaxDepth = 64;  // of the traversal's stack; deeper nodes become leaves

struct Box {
    glm::vec3 low{raster::kInfinity};
    glm::vec3 high{-raster::kInfinity};

    void add(const glm::vec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void add(const Box& box) {
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    [[nodiscard]] double half_area() const {
        const glm::dvec3 d = glm::max(glm::dvec3(high) - glm::dvec3(low), glm::dvec3(0.0));
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

/// What building moves about: a triangle's number, box and centre.
struct Item {
    std::uint32_t triangle = 0;
    Box box;
    glm::vec3 centre{0.0f};
};

struct Range {
    std::uint32_t node = 0, begin = 0, end = 0, depth = 0;
};

bool is_finite(const glm::vec3& p) {
    return raster::is_finite(p.x) && raster::is_finite(p.y) && raster::is_finite(p.z);
}

/// A little wider on every side, by some roundings of float: what is rounded in the test of a ray, in double, must not
/// lose a triangle that lies in a face of its box.
Box widened(const Box& box) {
    const glm::vec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
    const glm::vec3 margin(0x1p-22f * std::max({reach.x, reach.y, reach.z}));
    return {box.low - margin, box.high + margin};
}

/// Along which axis to split, and at which centre.
struct Split {
    int axis = 0;
    float at = 0.0f;
    double cost = std::numeric_limits<double>::infinity();  ///< sum over both sides of half area x triangles
};

Split best_split_along(int axis, std::span<const Item> items, const Box& centres) {
    const float low = centres.low[axis], extent = centres.high[axis] - low;
    if (!(extent > 0.0f)) return {};
    const auto bin_of = [&](const Item& item) {
        return std::clamp(static_cast<int>((item.centre[axis] - low) / extent * kBins), 0, kBins - 1);
    };
    Box box[kBins];
    std::uint32_t count[kBins] = {};
    for (const Item& item : items) {
        box[bin_of(item)].add(item.box);
        ++count[bin_of(item)];
    }
    double right_cost[kBins] = {};  // of bins b ..
    Box right;
    std::uint32_t right_count = 0;
    for (int b = kBins - 1; b > 0; --b) {
        right.add(box[b]);
        right_count += count[b];
        right_cost[b] = right.half_area() * right_count;
    }
    Split best;
    Box left;
    std::uint32_t left_count = 0;
    for (int b = 1; b < kBins; ++b) {
        left.add(box[b - 1]);
        left_count += count[b - 1];
        const double cost = left.half_area() * left_count + right_cost[b];
        const bool both_sides = left_count > 0 && left_count < items.size();
        if (both_sides && cost < best.cost) best = {axis, low + extent * static_cast<float>(b) / kBins, cost};
    }
    return best;
}

/// Reorder the items of a range; returns where its right half begins, or range.begin where it is to stay a leaf.
std::uint32_t partition(std::vector<Item>& items, const Range& range, const Box& box) {
    const std::uint32_t count = range.end - range.begin;
    if (count <= kLeafTriangles || range.depth + 1 >= kMaxDepth) return range.begin;
    const std::span<Item> part(items.data() + range.begin, count);
    Box centres;
    for (const Item& item : part) centres.add(item.centre);
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        const Split split = best_split_along(axis, part, centres);
        if (split.cost < best.cost) best = split;
    }
    const bool worth_it = best.cost < box.half_area() * count || count > 4 * kLeafTriangles;
    if (!worth_it || best.cost == std::numeric_limits<double>::infinity()) return range.begin;
    const auto middle =
        std::partition(part.begin(), part.end(), [&](const Item& item) { return item.centre[best.axis] < best.at; });
    const auto begin_right = static_cast<std::uint32_t>(middle - part.begin());
    return begin_right == count ? range.begin : range.begin + begin_right;
}

/// A ray as the boxes see it. Where D has no component the reciprocal is huge instead of infinite, so that 0 * it is 0.
struct BoxRay {
    glm::dvec3 origin, inverse;
};

BoxRay box_ray(const LightRay& ray) {
    BoxRay result{ray.origin, {}};
    for (int k = 0; k < 3; ++k) {
        const double d = ray.direction[k];
        result.inverse[k] = 1.0 / (std::abs(d) > 1e-300 ? d : std::copysign(1e-300, d));
    }
    return result;
}

/// Does the ray pass through the node's box before its end?                           Kay & Kajiya 1986
inline bool meets_box(const BoxRay& ray, const BvhNode& node, double end) {
    const glm::dvec3 t_low = (glm::dvec3(node.low) - ray.origin) * ray.inverse;
    const glm::dvec3 t_high = (glm::dvec3(node.high) - ray.origin) * ray.inverse;
    const glm::dvec3 t_in = glm::min(t_low, t_high);
    const glm::dvec3 t_out = glm::max(t_low, t_high);
    const double enter = std::max({t_in.x, t_in.y, t_in.z, 0.0});
    const double leave = std::min({t_out.x, t_out.y, t_out.z, end});
    return enter <= leave;
}

/// Ask about every triangle whose box the ray meets, until one answers true. Returns whether one did.
template <class Ask>
inline bool meet_triangles(const Bvh& bvh, const LightRay& ray, Ask ask) {
    if (bvh.nodes.empty()) return false;
    const BoxRay box = box_ray(ray);
    std::uint32_t stack[kMaxDepth + 1];
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
        const BvhNode& node = bvh.nodes[stack[--waiting]];
        if (!meets_box(box, node, ray.end)) continue;
        for (std::uint32_t i = 0; i < node.count; ++i) {
            if (ask(bvh.triangles[node.first + i])) return true;
        }
        if (node.count > 0) continue;
        stack[waiting++] = node.first;
        stack[waiting++] = node.first + 1;
    }
    return false;
}

}  // namespace

std::vector<Triangle> gather_triangles(std::span<const Occluder> occluders) {
    std::size_t most = 0;
    for (const Occluder& occluder : occluders) most += occluder.indices.size() / 3;
    std::vector<Triangle> triangles;
    triangles.reserve(most);
    for (const Occluder& occluder : occluders) {
        for (std::size_t i = 0; i + 2 < occluder.indices.size(); i += 3) {
            const Triangle t{occluder.positions[occluder.indices[i]], occluder.positions[occluder.indices[i + 1]],
                             occluder.positions[occluder.indices[i + 2]]};
            if (is_finite(t.a) && is_finite(t.b) && is_finite(t.c)) triangles.push_back(t);
        }
    }
    return triangles;
}

std::size_t bytes_to_build_bvh(std::size_t triangles) {
    return triangles * (sizeof(Triangle) + sizeof(Item));
}

Bvh build_bvh(std::vector<Triangle> triangles) {
    Bvh bvh;
    if (triangles.empty()) return bvh;
    std::vector<Item> items(triangles.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        const Triangle& t = triangles[i];
        items[i].triangle = i;
        for (const glm::vec3& corner : {t.a, t.b, t.c}) items[i].box.add(corner);
        items[i].centre = 0.5f * items[i].box.low + 0.5f * items[i].box.high;
    }
    bvh.nodes.emplace_back();
    std::vector<Range> todo = {{0, 0, static_cast<std::uint32_t>(items.size()), 0}};
    while (!todo.empty()) {
        const Range range = todo.back();
        todo.pop_back();
        Box box;
        for (std::uint32_t i = range.begin; i < range.end; ++i) box.add(items[i].box);
        const std::uint32_t middle = partition(items, range, box);
        const Box wide = widened(box);
        BvhNode& node = bvh.nodes[range.node];
        node = {wide.low, range.begin, wide.high, range.end - range.begin};
        if (middle == range.begin) continue;
        node.first = static_cast<std::uint32_t>(bvh.nodes.size());
        node.count = 0;
        todo.push_back({node.first, range.begin, middle, range.depth + 1});
        todo.push_back({node.first + 1, middle, range.end, range.depth + 1});
        bvh.nodes.resize(bvh.nodes.size() + 2);
    }
    bvh.triangles.reserve(items.size());
    for (const Item& item : items) bvh.triangles.push_back(triangles[item.triangle]);
    return bvh;
}

bool any_shadow(const Bvh& bvh, const glm::dvec4& light, const glm::vec3& p) {
    const LightRay ray = light_ray(light, p);
    return meet_triangles(bvh, ray, [&](const Triangle& t) { return shadows_point(ray, t, light, p); });
}

double distance_to_last_blocker(const Bvh& bvh, const glm::dvec4& light, const glm::vec3& p) {
    const LightRay ray = light_ray(light, p);
    double last = 0.0;
    meet_triangles(bvh, ray, [&](const Triangle& t) {
        if (shadows_point(ray, t, light, p)) last = std::max(last, hit_parameter(ray, t));
        return false;
    });
    return last * glm::length(ray.direction);
}

bool any_shadow(std::span<const Triangle> triangles, const glm::dvec4& light, const glm::vec3& p) {
    const LightRay ray = light_ray(light, p);
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](const Triangle& t) { return shadows_point(ray, t, light, p); });
}

}  // namespace kreda::shadows
