// The pure geometry that lighting and shadows share: unit vectors, faces of a cube, mirrors, axes, convex polygons.
#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/camera.hpp"
#include "raster/convex_polygon.hpp"
#include "raster/cube_face.hpp"
#include "raster/unit_vector.hpp"
#include "raster/vertex_stage.hpp"

using namespace kreda::raster;

namespace {

struct Random {
    std::mt19937 bits{11};
    double real(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits()) / 4294967296.0);
    }
    glm::vec3 vector(double reach) {
        const double x = real(-reach, reach), y = real(-reach, reach), z = real(-reach, reach);
        return {x, y, z};
    }
};

using Square = ConvexPolygon<glm::dvec2, 8>;

glm::dvec2 between(const glm::dvec2& inside, const glm::dvec2& outside, double t) {
    return inside + t * (outside - inside);
}

double area_of(const Square& polygon) {
    double sum = 0.0;
    for_each_of_fan(0, polygon.count, [&](int i, int j, int k) {
        const glm::dvec2 u = polygon.corner[j] - polygon.corner[i], v = polygon.corner[k] - polygon.corner[i];
        sum += 0.5 * (u.x * v.y - u.y * v.x);
    });
    return sum;
}

const Square kSquare{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 4};

}  // namespace

TEST_CASE("geometry: a unit vector has length 1 and a vector of no length stays finite") {
    Random random;
    for (const double reach : {1e-12, 1.0, 1e12}) {
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 v = random.vector(reach);
            CHECK(glm::length(glm::dvec3(unit(v))) == doctest::Approx(1.0).epsilon(3e-7));
            CHECK(double{divisible_length(v)} == doctest::Approx(glm::length(glm::dvec3(v))).epsilon(3e-7));
        }
    }
    CHECK(unit(glm::vec3(0.0f)) == glm::vec3(0.0f));
    CHECK(divisible_length(glm::vec3(0.0f)) == doctest::Approx(1e-15));
    // the normal of a triangle with sides of 1e-8: shorter than lighting's least length, not than that of shadows
    CHECK(glm::length(unit({0.0f, 1e-16f, 0.0f})) < 0.2f);
    CHECK(glm::length(unit({0.0f, 1e-16f, 0.0f}, 1e-36f)) == doctest::Approx(1.0));
}

TEST_CASE("geometry: the face of a cube is that of the greatest coordinate and ties go to x before y before z") {
    CHECK(cube_face({2, 1, -1}).face == 0);
    CHECK(cube_face({-2, 1, 1}).face == 1);
    CHECK(cube_face({0, 3, 1}).face == 2);
    CHECK(cube_face({1, -3, 2}).face == 3);
    CHECK(cube_face({1, 1, 1.5f}).face == 4);
    CHECK(cube_face({1, 1, -1.5f}).face == 5);
    CHECK(cube_face({1, -1, 1}).face == 0);
    CHECK(cube_face({0, -1, 1}).face == 3);
    CHECK(cube_face({0, 0, 0}).face == 0);
    Random random;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 d = random.vector(1.0);
        const CubeFace f = cube_face(d);
        const int axis = f.face / 2;
        CHECK(f.along == d[axis]);
        CHECK(f.sign == (f.face % 2 == 0 ? 1.0f : -1.0f));
        CHECK(f.sign * f.along >= std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
        CHECK(f.on_x() == (axis == 0));
        CHECK(f.on_y() == (axis == 1));
    }
}

TEST_CASE("geometry: a transform mirrors when an odd number of axes is turned") {
    const glm::mat3 turned(glm::rotate(glm::mat4(1.0f), 0.8f, glm::normalize(glm::vec3(1, 2, -1))));
    for (int signs = 0; signs < 8; ++signs) {
        const glm::vec3 scale(signs & 1 ? -2.0f : 1.0f, signs & 2 ? -0.5f : 3.0f, signs & 4 ? -1e-3f : 1.0f);
        glm::mat3 m = turned;
        for (int i = 0; i < 3; ++i) m[i] *= scale[i];
        const bool odd = scale.x * scale.y * scale.z < 0.0f;
        CHECK(is_mirrored(m) == odd);
    }
}

TEST_CASE("geometry: the matrix from the view's axes is that of gluLookAt") {
    Random random;
    for (int i = 0; i < 50; ++i) {
        Camera camera;
        camera.position = random.vector(5.0);
        camera.target = random.vector(5.0);
        const glm::mat4 expected(
            glm::lookAtRH(glm::dvec3(camera.position), glm::dvec3(camera.target), glm::dvec3(camera.up)));
        CHECK(view_from_world(camera) == expected);
        const ViewAxes axes = view_axes(camera);
        CHECK(glm::dot(axes.up, glm::dvec3(camera.up)) > 0.0);
        CHECK(glm::length(glm::cross(axes.right, axes.up) + axes.forward) < 1e-14);
    }
}

TEST_CASE("geometry: what a line cuts off a square and what it leaves are the square") {
    Random random;
    for (int i = 0; i < 200; ++i) {
        const double angle = random.real(0.0, 6.3), offset = random.real(-1.0, 1.0);
        const auto distance = [&](const glm::dvec2& p) {
            return std::cos(angle) * (p.x - 0.5) + std::sin(angle) * (p.y - 0.5) - offset;
        };
        const Square kept = cut_polygon(kSquare, distance, between);
        const Square rest = cut_polygon(kSquare, distance, between, false);
        for (int k = 0; k < kept.count; ++k) CHECK(distance(kept.corner[k]) >= -1e-12);
        for (int k = 0; k < rest.count; ++k) CHECK(distance(rest.corner[k]) <= 1e-12);
        CHECK(area_of(kept) + area_of(rest) == doctest::Approx(1.0));
    }
    const auto right_half = [](const glm::dvec2& p) { return p.x - 0.5; };
    CHECK(area_of(cut_polygon(kSquare, right_half, between)) == 0.5);
    CHECK(cut_polygon(
              kSquare, [](const glm::dvec2&) { return -1.0; }, between)
              .count == 0);
}

TEST_CASE("geometry: an edge is cut at the same point from both sides") {
    Random random;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec2 a(random.vector(1.0)), b(random.vector(1.0)), c(random.vector(1.0)), d(random.vector(1.0));
        const auto distance = [&](const glm::dvec2& p) { return p.x + 0.3 * p.y; };
        const Square one = cut_polygon(Square{{{a, b, c}}, 3}, distance, between);
        const Square other = cut_polygon(Square{{{b, a, d}}, 3}, distance, between);
        if ((distance(a) < 0.0) == (distance(b) < 0.0)) continue;
        int shared = 0;
        for (int k = 0; k < one.count; ++k) {
            for (int m = 0; m < other.count; ++m) shared += one.corner[k] == other.corner[m];
        }
        CHECK(shared >= 2);  // the end that is inside, and the cut
    }
}

TEST_CASE("geometry: a fan from any corner covers the polygon once") {
    const int apexes[] = {0, 1, 2, 3};
    for (const int apex : apexes) {
        double area = 0.0;
        int triangles = 0;
        for_each_of_fan(apex, 4, [&](int i, int j, int k) {
            CHECK(i == apex);
            const glm::dvec2 u = kSquare.corner[j] - kSquare.corner[i], v = kSquare.corner[k] - kSquare.corner[i];
            area += 0.5 * (u.x * v.y - u.y * v.x);
            ++triangles;
        });
        CHECK(triangles == 2);
        CHECK(area == 1.0);
    }
    for_each_of_fan(0, 2, [](int, int, int) { CHECK(false); });
}
