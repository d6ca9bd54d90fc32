#include "raster/polygon.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

using kreda::scene::newell_normal;
using kreda::scene::PolygonTriangles;
using kreda::scene::triangulate_polygon;

namespace {

using Polygon = std::vector<glm::vec3>;

glm::dvec3 triangle_vector(const Polygon& p, const PolygonTriangles& cut, std::size_t t) {
    const glm::dvec3 a(p[cut.corners[t]]), b(p[cut.corners[t + 1]]), c(p[cut.corners[t + 2]]);
    return 0.5 * glm::cross(b - a, c - a);
}

/// Sum of the areas, each positive whatever side the triangle lies on.
double covered_area(const Polygon& p, const PolygonTriangles& cut) {
    double area = 0.0;
    for (std::size_t t = 0; t < cut.corners.size(); t += 3) area += glm::length(triangle_vector(p, cut, t));
    return area;
}

/// What any right triangulation satisfies: n - 2 triangles, none turned over, their areas sum to the polygon's.
void check_triangulation(const Polygon& p, double area) {
    const PolygonTriangles cut = triangulate_polygon(p);
    REQUIRE(cut.corners.size() == 3 * (p.size() - 2));
    CHECK(cut.area_agrees);
    CHECK(covered_area(p, cut) == doctest::Approx(area).epsilon(1e-6));  // corners are rounded to float
    const glm::dvec3 normal = newell_normal(p);
    for (std::size_t t = 0; t < cut.corners.size(); t += 3) {
        CHECK(glm::dot(triangle_vector(p, cut, t), normal) >= -1e-9 * glm::dot(normal, normal));
    }
}

/// The polygon in a plane that is aligned with nothing; the axes are orthonormal.
Polygon tilted(const Polygon& flat) {
    const glm::dvec3 u = glm::normalize(glm::dvec3(1, 2, 3));
    const glm::dvec3 v = glm::normalize(glm::cross(u, glm::dvec3(-2, 1, 1)));
    Polygon result;
    for (const glm::vec3& p : flat) result.emplace_back(u * double(p.x) + v * double(p.y) + glm::dvec3(5, -7, 11));
    return result;
}

/// The same polygon from each of its corners on, in both directions, in two planes.
void check_all_starts(const Polygon& polygon, double area) {
    const std::size_t n = polygon.size();
    for (std::size_t start = 0; start < n; ++start) {
        CAPTURE(start);
        Polygon forward, backward;
        for (std::size_t i = 0; i < n; ++i) forward.push_back(polygon[(start + i) % n]);
        backward.assign(forward.rbegin(), forward.rend());
        check_triangulation(forward, area);
        check_triangulation(backward, area);
        check_triangulation(tilted(forward), area);
    }
}

Polygon star(int points, double inner) {
    Polygon p;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = 3.14159265358979 * i / points, r = i % 2 == 0 ? 1.0 : inner;
        p.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
    }
    return p;
}

/// A band of width 0.1 rolled up three times.
Polygon spiral(int steps) {
    Polygon p;
    const auto add = [&](int i, double offset) {
        const double angle = 6.0 * 3.14159265358979 * i / steps, r = 0.5 + angle * 0.05 + offset;
        p.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
    };
    for (int i = 0; i <= steps; ++i) add(i, 0.1);
    for (int i = steps; i >= 0; --i) add(i, 0.0);
    return p;
}

double area_of(const Polygon& p) {
    return 0.5 * glm::length(newell_normal(p));
}

}  // namespace

TEST_CASE("polygon: a square has two triangles and area one") {
    check_triangulation({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 1.0);
}

TEST_CASE("polygon: Newell normal of an L of three unit squares is twice its area") {
    const Polygon l = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    CHECK(newell_normal(l) == glm::dvec3(0, 0, 6));
}

TEST_CASE("polygon: a concave quad is cut along its inner diagonal wherever it starts") {
    // An arrow head: (0,0) (2,-1) (0,2) (-2,-1), concave at the first corner. Area by the shoelace formula: 4.
    check_all_starts({{0, 0, 0}, {2, -1, 0}, {0, 2, 0}, {-2, -1, 0}}, 4.0);
}

TEST_CASE("polygon: an L keeps its area whichever corner comes first and whichever way it winds") {
    check_all_starts({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, 3.0);
}

TEST_CASE("polygon: collinear corners stay corners") {
    // A unit square with the middle of each side as a corner.
    check_triangulation({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}, {1, .5, 0}, {1, 1, 0}, {.5, 1, 0}, {0, 1, 0}, {0, .5, 0}},
                        1.0);
}

TEST_CASE("polygon: holes reached by cuts stay open whichever corner comes first") {
    // A 4 x 4 square with a 2 x 2 hole in the middle; the cut runs from (0,0) to (1,1) and back.
    check_all_starts(
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}},
        16.0 - 4.0);
    // Two holes of one unit, both reached from the corner (0,0), one of them straight along the diagonal through the
    // other.
    check_all_starts({{0, 0, 0},
                      {5, 0, 0},
                      {5, 5, 0},
                      {0, 5, 0},
                      {0, 0, 0},
                      {1, 1, 0},
                      {1, 2, 0},
                      {2, 2, 0},
                      {3, 3, 0},
                      {3, 4, 0},
                      {4, 4, 0},
                      {4, 3, 0},
                      {3, 3, 0},
                      {2, 2, 0},
                      {2, 1, 0},
                      {1, 1, 0}},
                     25.0 - 2.0);
}

TEST_CASE("polygon: outlines that touch themselves keep their area whichever corner comes first") {
    // Two unit squares that share the corner (1,1), then a square with a notch whose tip touches its far side.
    check_all_starts({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}}, 2.0);
    check_all_starts({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0}, {2, 0, 0}, {1, 4, 0}, {0, 4, 0}}, 12.0);
}

TEST_CASE("polygon: skylines on a coarse grid with many collinear corners keep their area") {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> height(1, 3);
    for (int round = 0; round < 60; ++round) {
        CAPTURE(round);
        Polygon p;
        double area = 0.0;
        const int columns = 6;
        for (int x = 0; x <= columns; ++x) p.emplace_back(x, 0, 0);
        for (int x = columns - 1; x >= 0; --x) {
            const int h = height(random);
            area += h;
            p.emplace_back(x + 1, h, 0);  // equal heights side by side give a corner twice
            p.emplace_back(x, h, 0);
        }
        check_all_starts(p, area);
    }
}

TEST_CASE("polygon: stars and spirals keep their area in any plane of space") {
    for (const Polygon& flat : {star(5, 0.38), star(64, 0.1), spiral(30), spiral(200)}) {
        CAPTURE(flat.size());
        check_triangulation(flat, area_of(flat));
        check_triangulation(tilted(flat), area_of(flat));
    }
}

TEST_CASE("polygon: random star-shaped polygons are covered exactly once") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> radius(0.1, 1.0);
    std::uniform_int_distribution<int> corner_count(4, 60);
    for (int i = 0; i < 300; ++i) {
        CAPTURE(i);
        Polygon p;
        const int n = corner_count(random);
        for (int k = 0; k < n; ++k) {
            const double angle = 2.0 * 3.14159265358979 * k / n, r = radius(random);
            p.emplace_back(0.25f, float(r * std::cos(angle)), float(r * std::sin(angle)));
        }
        check_triangulation(p, area_of(p));
    }
}

TEST_CASE("polygon: an outline that crosses itself is reported") {
    const Polygon bow_tie = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}};
    const PolygonTriangles cut = triangulate_polygon(bow_tie);
    CHECK(cut.corners.size() == 6);
    CHECK_FALSE(cut.area_agrees);
}

TEST_CASE("polygon: without any area it is reported and still has n - 2 triangles") {
    const PolygonTriangles cut = triangulate_polygon(Polygon{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 1, 1}});
    CHECK(cut.corners.size() == 9);
    CHECK_FALSE(cut.area_agrees);
}

TEST_CASE("polygon: ten thousand corners of a spiral keep their area") {
    const Polygon p = spiral(4999);
    check_triangulation(p, area_of(p));
}
