// Triangles that are in a mesh more than once are drawn once.
#include "scene/files/repeated_triangles.hpp"

#include <array>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "tests/scene/mesh_text.hpp"

using namespace kreda::tests;
using kreda::raster::Mesh;
using kreda::scene::drop_repeated_triangles;

namespace {

using Corners = std::array<glm::vec3, 3>;

Corners corners_of(const Mesh& mesh, std::uint32_t triangle) {
    const std::uint32_t* v = &mesh.indices[3 * std::size_t{triangle}];
    return {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
}

/// The same places the same way round.
bool is_same_triangle(const Corners& a, const Corners& b) {
    return a == b || a == Corners{b[1], b[2], b[0]} || a == Corners{b[2], b[0], b[1]};
}

/// Every triangle beside every one before it in its part; also how many remain of each part.
std::vector<Corners> kept_one_by_one(const Mesh& mesh, std::vector<std::uint32_t>& counts) {
    std::vector<Corners> kept;
    for (const kreda::raster::MeshPart& part : mesh.parts) {
        const std::size_t before = kept.size();
        for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
            bool is_new = true;
            for (std::uint32_t other = part.first_triangle; other < t; ++other) {
                is_new = is_new && !is_same_triangle(corners_of(mesh, t), corners_of(mesh, other));
            }
            if (is_new) kept.push_back(corners_of(mesh, t));
        }
        counts.push_back(static_cast<std::uint32_t>(kept.size() - before));
    }
    return kept;
}

/// `triangles` between any three of seven places in each of two parts; at each place stand two vertices of both parts.
Mesh random_mesh(std::uint32_t triangles, std::uint32_t seed) {
    std::mt19937 random(seed);
    Mesh mesh;
    for (int i = 0; i < 28; ++i) mesh.positions.emplace_back(i % 7, i % 7 * (i % 7), 0.0f);
    for (std::uint32_t part = 0; part < 2; ++part) {
        mesh.parts.push_back({"", part * triangles, triangles, 0});
        for (std::uint32_t i = 0; i < triangles; ++i) {
            const std::uint32_t a = random() % 7, b = (a + 1 + random() % 3) % 7, c = (a + 4 + random() % 3) % 7;
            const bool is_turned = random() % 2 == 0;
            for (const std::uint32_t place : {a, is_turned ? c : b, is_turned ? b : c})
                mesh.indices.push_back(14 * part + 7 * (random() % 2) + place);
        }
    }
    return mesh;
}

}  // namespace

TEST_CASE("repeated triangles: those that remain are those that comparing all with all leaves") {
    for (const std::uint32_t triangles : {1u, 5u, 40u, 300u}) {
        Mesh mesh = random_mesh(triangles, triangles);
        std::vector<std::uint32_t> counts;
        const std::vector<Corners> expected = kept_one_by_one(mesh, counts);
        CHECK(drop_repeated_triangles(mesh) == 2 * triangles - expected.size());
        REQUIRE(mesh.triangle_count() == expected.size());
        for (std::uint32_t t = 0; t < expected.size(); ++t) CHECK(corners_of(mesh, t) == expected[t]);
        CHECK(mesh.parts[0].first_triangle == 0);
        CHECK(mesh.parts[0].triangle_count == counts[0]);
        CHECK(mesh.parts[1].first_triangle == counts[0]);
        CHECK(mesh.parts[1].triangle_count == counts[1]);
    }
}

TEST_CASE("repeated triangles: of an OBJ they cost one warning; the other side and other materials are no repetition") {
    const std::string face = "f 1//1 2//1 3//1\n", turned = "f 2//1 3//1 1//1\n", other_side = "f 3//1 2//1 1//1\n";
    const LoadedText result =
        load_text(kVertices + "vn 0 0 1\n" + face + turned + other_side + face + "usemtl m\n" + face);
    CHECK(result.loaded.mesh.triangle_count() == 3);
    CHECK(result.loaded.mesh.parts.size() == 2);
    REQUIRE(!result.warnings.empty());
    CHECK(result.warnings.back() == "a.obj: 2 triangles have the corners of one before; each is drawn once");
}

TEST_CASE("repeated triangles: three hundred thousand on one place are one") {
    std::string text = kVertices;
    for (int i = 0; i < 300'000; ++i) text += "f 1 2 3\n";
    const LoadedText result = load_text(text);
    CHECK(result.loaded.mesh.triangle_count() == 1);
    CHECK(result.loaded.mesh.indices == load_text(kVertices + "f 1 2 3\n").loaded.mesh.indices);
    CHECK(result.warnings.size() == 1);
}

TEST_CASE("repeated triangles: each with vertices of its own they are one, too") {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += kVertices + "f -3 -2 -1\n";
    const LoadedText result = load_text(text + "v 0 0 1e-7\nf -3 -2 -1\n");  // the last one lies a little beside
    CHECK(result.loaded.mesh.triangle_count() == 2);
    CHECK(result.warnings.size() == 1);
}
