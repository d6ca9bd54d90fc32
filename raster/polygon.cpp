#include "raster/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "raster/platform.hpp"

namespace kreda::scene {

namespace {

/// Twice the signed area of the triangle a b c: positive if it turns left.
double twice_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Seen along the Newell normal n, slanted onto the coordinate plane most across it: where n is an axis the coordinates
/// stay exactly as they are, so collinear corners stay collinear. The outline turns left (counter-clockwise).
std::vector<glm::dvec2> project(std::span<const glm::vec3> polygon, glm::dvec3 n) {
    const glm::dvec3 size = glm::abs(n);
    const int w = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
    const int u = (w + 1) % 3, v = (w + 2) % 3;
    const double slant_u = n[u] / n[w], slant_v = n[v] / n[w];
    const double side = n[w] < 0.0 ? -1.0 : 1.0;
    std::vector<glm::dvec2> outline;
    outline.reserve(polygon.size());
    for (const glm::vec3& corner : polygon) {
        const glm::dvec3 p(corner);
        outline.emplace_back(p[u] - slant_u * p[w], side * (p[v] - slant_v * p[w]));
    }
    return outline;
}

double twice_outline_area(const std::vector<glm::dvec2>& outline) {
    double area = 0.0;
    for (std::size_t i = 2; i < outline.size(); ++i) area += twice_area(outline[0], outline[i - 1], outline[i]);
    return area;
}

bool is_fan(const std::vector<glm::dvec2>& outline) {
    for (std::size_t i = 2; i < outline.size(); ++i) {
        if (!(twice_area(outline[0], outline[i - 1], outline[i]) > 0.0)) return false;
    }
    return true;
}

std::vector<std::uint32_t> fan(std::uint32_t n) {
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * (n - 2));
    for (std::uint32_t i = 2; i < n; ++i) corners.insert(corners.end(), {0, i - 1, i});
    return corners;
}

/// What is left of the polygon: a ring of corners, each knowing its neighbours.
struct Ring {
    std::vector<glm::dvec2> at;
    std::vector<std::uint32_t> previous, next;
    std::uint32_t size = 0;

    explicit Ring(std::vector<glm::dvec2> outline) : at(std::move(outline)), size(std::uint32_t(at.size())) {
        for (std::uint32_t i = 0; i < size; ++i) {
            previous.push_back((i + size - 1) % size);
            next.push_back((i + 1) % size);
        }
    }
    [[nodiscard]] double turn(std::uint32_t i) const {
        return twice_area(at[previous[i]], at[i], at[next[i]]);
    }
    void remove(std::uint32_t i) {
        next[previous[i]] = next[i];
        previous[next[i]] = previous[i];
        --size;
    }
};

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// Directions from one point: does d lie within the turn to the left from `first` to `last`, a turn of less than 180
/// degrees? `first` itself is within, `last` is not.
bool is_within_turn(glm::dvec2 first, glm::dvec2 d, glm::dvec2 last) {
    const double from_first = cross(first, d);
    return (from_first > 0.0 || (from_first == 0.0 && glm::dot(first, d) > 0.0)) && cross(d, last) > 0.0;
}

/// p is another corner at the place of the ear's tip b. Where p turns right, the wedge on its right is outside of the
/// polygon (the end of a notch or a hole that touches b): is that wedge within the ear's?
bool notch_is_within_ear(const Ring& ring, std::uint32_t p, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    if (ring.turn(p) > 0.0) return false;
    const glm::dvec2 to_previous = ring.at[ring.previous[p]] - b, to_next = ring.at[ring.next[p]] - b;
    const bool starts_within = is_within_turn(c - b, to_previous, a - b);
    const bool ends_within = cross(c - b, to_next) > 0.0 && cross(to_next, a - b) >= 0.0;
    return starts_within && ends_within;
}

/// The tip turns left and no other corner lies in the ear or on its border. A corner that only shares the place of an
/// end of the cut (polygons that touch themselves) does not count.
bool is_ear(const Ring& ring, std::uint32_t tip) {
    if (!(ring.turn(tip) > 0.0)) return false;
    const glm::dvec2 a = ring.at[ring.previous[tip]], b = ring.at[tip], c = ring.at[ring.next[tip]];
    const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    for (std::uint32_t p = ring.next[ring.next[tip]]; p != ring.previous[tip]; p = ring.next[p]) {
        const glm::dvec2 q = ring.at[p];
        if (q.x < low.x || q.x > high.x || q.y < low.y || q.y > high.y || q == a || q == c) continue;
        if (q == b) {
            if (notch_is_within_ear(ring, p, a, b, c)) return false;
            continue;
        }
        if (twice_area(a, b, q) >= 0.0 && twice_area(b, c, q) >= 0.0 && twice_area(c, a, q) >= 0.0) return false;
    }
    return true;
}

/// No ear: cut where the outline goes straight on or back (area 0), else where it turns left, else anywhere.
std::uint32_t least_bad_tip(const Ring& ring, std::uint32_t start) {
    std::uint32_t left = start;
    std::uint32_t i = start;
    do {
        const double turn = ring.turn(i);
        if (turn == 0.0) return i;
        if (turn > 0.0) left = i;
        i = ring.next[i];
    } while (i != start);
    return left;
}

/// Cuts ears until a triangle is left. Whether a corner is an ear can change only for the two neighbours of a cut, or
/// when the corner that was in its way goes: so the walk goes on behind a cut, and gives up after a round without one.
std::vector<std::uint32_t> clip_ears(Ring ring) {
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * (ring.size - 2));
    std::uint32_t tip = 0;
    std::uint32_t walked = 0;
    while (ring.size > 3) {
        if (walked < ring.size && !is_ear(ring, tip)) {
            tip = ring.next[tip];
            ++walked;
            continue;
        }
        if (walked == ring.size) tip = least_bad_tip(ring, tip);
        corners.insert(corners.end(), {ring.previous[tip], tip, ring.next[tip]});
        ring.remove(tip);
        tip = ring.next[ring.next[tip]];
        walked = 0;
    }
    corners.insert(corners.end(), {ring.previous[tip], tip, ring.next[tip]});
    return corners;
}

/// A triangle that lies on the wrong side makes the sum of the unsigned areas larger than the outline's signed area.
bool areas_agree(const std::vector<glm::dvec2>& outline, const std::vector<std::uint32_t>& corners) {
    double unsigned_sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        unsigned_sum += std::abs(twice_area(outline[corners[i]], outline[corners[i + 1]], outline[corners[i + 2]]));
    }
    // Rounding of at most 10,000 sums in double is below 1e-11 of the sum.
    return unsigned_sum > 0.0 && std::abs(unsigned_sum - twice_outline_area(outline)) <= 1e-9 * unsigned_sum;
}

}  // namespace

glm::dvec3 newell_normal(std::span<const glm::vec3> polygon) {
    KREDA_EXPECT(!polygon.empty());
    const glm::dvec3 origin(polygon[0]);  // keeps digits where the polygon is far from 0
    glm::dvec3 normal(0.0);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        normal += glm::cross(glm::dvec3(polygon[i - 1]) - origin, glm::dvec3(polygon[i]) - origin);
    }
    return normal;
}

PolygonTriangles triangulate_polygon(std::span<const glm::vec3> polygon) {
    KREDA_EXPECT(polygon.size() >= 3);
    const std::uint32_t n = static_cast<std::uint32_t>(polygon.size());
    if (n == 3) return {{0, 1, 2}, true};
    const glm::dvec3 normal = newell_normal(polygon);
    if (normal == glm::dvec3(0.0)) return {fan(n), false};
    std::vector<glm::dvec2> outline = project(polygon, normal);
    if (is_fan(outline)) return {fan(n), true};
    std::vector<std::uint32_t> corners = clip_ears(Ring(outline));
    const bool agrees = areas_agree(outline, corners);
    return {std::move(corners), agrees};
}

}  // namespace kreda::scene
