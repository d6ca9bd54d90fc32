// A scene far from 0 must look as at 0: in the mesh file, by translate, with every kind of light and shadow. And what
// the near and far planes do to a picture is said.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "scene/files/mesh_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/origin.hpp"
#include "scene/render/render.hpp"
#include "scene/view_warnings.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using namespace kreda::scene;
using kreda::tests::TempFolder;

namespace {

std::string at(const glm::dvec3& p) {
    char text[128];
    std::snprintf(text, sizeof text, "[%.17g, %.17g, %.17g]", p.x, p.y, p.z);
    return text;
}

/// A ball of rings and segments about a place, every number with 17 digits.
std::string ball_obj(const glm::dvec3& middle, double radius) {
    constexpr int kRings = 16, kSegments = 24;
    std::string text;
    for (int ring = 0; ring <= kRings; ++ring) {
        const double theta = std::numbers::pi * ring / kRings;
        for (int segment = 0; segment < kSegments; ++segment) {
            const double phi = 2.0 * std::numbers::pi * segment / kSegments;
            const glm::dvec3 p = middle + radius * glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                                                              std::sin(theta) * std::cos(phi));
            char line[128];
            std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
            text += line;
        }
    }
    for (int ring = 0; ring < kRings; ++ring) {
        for (int segment = 0; segment < kSegments; ++segment) {
            const int a = ring * kSegments + segment + 1, b = ring * kSegments + (segment + 1) % kSegments + 1;
            text += "f " + std::to_string(a) + " " + std::to_string(a + kSegments) + " " +
                    std::to_string(b + kSegments) + " " + std::to_string(b) + "\n";
        }
    }
    return text;
}

struct Case {
    std::string light = "directional";
    std::string method = "map";
    bool in_file = false;  ///< the ball's place is in the OBJ rather than in translate
    std::string more = "";
};

/// A ball on a floor, the camera and the light, all moved by `offset`.
Scene moved(const TempFolder& folder, const Case& c, const glm::dvec3& offset) {
    const glm::dvec3 ball = offset + glm::dvec3(0.0, 1.0, 0.0);
    folder.write("ball.obj", ball_obj(c.in_file ? ball : glm::dvec3(0.0), 1.0));
    const std::string text =
        "[image]\nsize = [96, 64]\nbackground = [0.2, 0.3, 0.4]\n[camera]\nposition = " +
        at(offset + glm::dvec3(1.0, 2.5, 5.0)) + "\ntarget = " + at(offset + glm::dvec3(0.0, 0.75, 0.0)) +
        "\nnear = 1\nfar = 20\n[[light]]\nshadow = true\ntype = \"" + c.light +
        "\"\nposition = " + at(offset + glm::dvec3(2.0, 5.0, 1.5)) +
        "\ndirection = [-2, -5, -1.5]\n[shadow]\nsize = 256\nmethod = \"" + c.method + "\"\n" + c.more +
        "[[object]]\nmesh = \"ball.obj\"\n" + (c.in_file ? "" : "translate = " + at(ball) + "\n") +
        "[[object]]\nmesh = \"plane\"\nscale = 4\ntranslate = " + at(offset) + "\n";
    return read_scene_text(text, "moved", folder.path.string());
}

struct Pictures {
    raster::Image film, depth;
};

Pictures draw(const Scene& scene) {
    RenderBuffers buffers;
    render(scene, make_plan(scene, {find_view("depth")}), buffers);
    return {buffers.film, buffers.views[0]};
}

/// Pixels whose centre lies on an edge of the ball or of a shadow may fall to the other side: they are counted apart.
struct Difference {
    int on_edges = 0;
    double depth = 0.0, color = 0.0;  ///< the largest elsewhere
};

Difference difference(const Pictures& a, const Pictures& b) {
    Difference d;
    for (int y = 0; y < a.film.height; ++y) {
        for (int x = 0; x < a.film.width; ++x) {
            const glm::dvec3 color = glm::abs(glm::dvec3(a.film.rgb(x, y)) - glm::dvec3(b.film.rgb(x, y)));
            const double depth = std::abs(double{a.depth.at(0, x, y)} - double{b.depth.at(0, x, y)});
            const double largest = std::max({color.x, color.y, color.z});
            if (depth > 1e-3 || largest > 0.02) {
                ++d.on_edges;
                continue;
            }
            d.depth = std::max(d.depth, depth);
            d.color = std::max(d.color, largest);
        }
    }
    return d;
}

const glm::dvec3 kOffsets[] = {
    {1.25, 0.5, -2.75}, {1e3 + 0.25, 100.5, -1e3}, {500000.25, 100.5, 4600000.75}, {1e9 + 0.25, -1e9, 1e9 + 0.75}};

int warnings_with(const Scene& scene, const std::string& words) {
    int count = 0;
    for (const std::string& warning : scene.warnings) count += warning.find(words) != std::string::npos;
    return count;
}

}  // namespace

TEST_CASE("Far from 0: a ball in the file or by translate looks as at 0") {
    const TempFolder folder;
    for (const bool in_file : {false, true}) {
        const Pictures here = draw(moved(folder, {"directional", "exact", in_file}, glm::dvec3(0.0)));
        for (const glm::dvec3& offset : kOffsets) {
            const Difference d = difference(here, draw(moved(folder, {"directional", "exact", in_file}, offset)));
            CAPTURE(in_file);
            CAPTURE(offset.x);
            MESSAGE("in_file " << in_file << " offset " << offset.x << ": depth " << d.depth << ", colour " << d.color
                               << ", pixels on edges " << d.on_edges);
            CHECK(d.depth < 1e-5);
            CHECK(d.color < 1e-4);
            CHECK(d.on_edges <= 8);
        }
    }
}

TEST_CASE("Far from 0: every light with every shadow method looks as at 0") {
    const TempFolder folder;
    const std::string fog = "[fog]\nmode = \"linear\"\nstart = 2\nend = 15\n";
    for (const char* const method : {"map", "planar", "volume", "irregular", "exact"}) {
        for (const char* const light : {"directional", "point", "spot"}) {
            const Case c{light, method, true, fog};
            const Pictures here = draw(moved(folder, c, glm::dvec3(0.0)));
            for (const glm::dvec3& offset : {kOffsets[2], kOffsets[3]}) {
                const Difference d = difference(here, draw(moved(folder, c, offset)));
                CAPTURE(method);
                CAPTURE(light);
                CAPTURE(offset.x);
                CHECK(d.depth < 1e-5);
                CHECK(d.color < 1e-4);
                CHECK(d.on_edges <= 30);
            }
        }
    }
}

TEST_CASE("Far from 0: scenes near 0 are computed from 0 and their meshes are as in the file") {
    const TempFolder folder;
    const Scene scene = moved(folder, {"point", "map", true}, glm::dvec3(3.0, 1.0, -2.0));
    CHECK(scene.origin == glm::dvec3(0.0));
    CHECK(scene.objects[0].mesh->origin == glm::dvec3(0.0));
    CHECK(scene.objects[0].mesh->unit == 1.0);
    CHECK(read_scene_text(built_in_scene_text(), "built in", "").origin == glm::dvec3(0.0));
}

TEST_CASE("Far from 0: the origin is near the camera or near what it looks at from afar") {
    CameraPlace camera{glm::dvec3(1e6, 0.0, 4.0), glm::dvec3(1e6, 0.0, 0.0), {}};
    const std::vector<ObjectPlace> two{{glm::dvec3(0.0), 1.0}, {glm::dvec3(1e6, 0.0, 0.0), 1.0}};
    CHECK(loss_about(choose_origin(camera, two), camera, two) < 10.0);  // what is far away may be coarse

    camera = {glm::dvec3(0.0), glm::dvec3(1e6, 0.0, 0.0), {}};  // a telescope
    camera.lens.vertical_fov_deg = 2e-4f;
    const std::vector<ObjectPlace> one{{glm::dvec3(1e6, 0.0, 0.0), 1.0}};
    const glm::dvec3 origin = choose_origin(camera, one);
    CHECK(glm::distance(origin, one[0].middle) < 4.0);

    camera = {glm::dvec3(0.0, 0.0, 1e6), glm::dvec3(0.0), {}};  // parallel rays may come from afar
    camera.lens.projection = raster::Projection::orthographic;
    CHECK(choose_origin(camera, {{glm::dvec3(0.0), 1.0}}) == glm::dvec3(0.0));
}

TEST_CASE("Far from 0: a mesh keeps its shape in float whatever its place and size") {
    const TempFolder folder;
    struct Row {
        glm::dvec3 middle;
        double radius;
    };
    for (const Row& row : {Row{{500000.25, 100.5, 4600000.75}, 1.0}, Row{{1e9, -1e9, 3e9}, 2.0}, Row{{0, 0, 0}, 1e-8},
                           Row{{0, 0, 0}, 1e37}, Row{{1e-3, 2e-3, 0}, 1e-8}}) {
        CAPTURE(row.middle.x);
        CAPTURE(row.radius);
        const raster::Mesh mesh = load_mesh_file(folder.write("ball.obj", ball_obj(row.middle, row.radius)), {}).mesh;
        double worst = 0.0;
        for (const glm::vec3& p : mesh.positions) {
            const glm::dvec3 of_file = mesh.origin + mesh.unit * glm::dvec3(p);
            worst = std::max(worst, std::abs(glm::distance(of_file, row.middle) - row.radius));
        }
        // A float about the middle is within 2^-23 of the radius; the file's doubles are rounded by 2^-52 of the place.
        const double allowed = 3e-7 * row.radius + 4e-16 * glm::length(row.middle);
        CHECK(worst < allowed);
    }
}

TEST_CASE("Far from 0: numbers that double cannot keep apart are warned of") {
    const TempFolder folder;
    CHECK(warnings_with(moved(folder, {}, kOffsets[3]), "16 digits") == 0);
    CHECK(warnings_with(moved(folder, {}, glm::dvec3(1e14, 0.0, 0.0)), "16 digits") == 1);
}

TEST_CASE("Near and far: a picture without anything and one without depths say so") {
    const auto scene_with = [](const std::string& camera) {
        return read_scene_text("[camera]\nposition = [0, 0, 4]\n" + camera + "[[object]]\nmesh = \"sphere\"\n", "s",
                               "");
    };
    CHECK(scene_with("").warnings.empty());
    CHECK(scene_with("near = 0.001\n").warnings.empty());
    CHECK(warnings_with(scene_with("near = 1e-7\n"), "hidden surfaces show through; try near = ") == 1);
    CHECK(warnings_with(scene_with("near = 1e-8\n"), "hidden surfaces show through; try near = ") == 1);
    CHECK(warnings_with(scene_with("projection = \"orthographic\"\nfar = 1e9\n"), "hidden surfaces") == 1);
    CHECK(warnings_with(scene_with("far = 2\n"), "everything lies beyond camera.far = 2") == 1);
    CHECK(warnings_with(scene_with("near = 6\n"), "everything lies before camera.near = 6") == 1);
    CHECK(warnings_with(scene_with("target = [0, 0, 8]\n"), "everything lies behind the camera") == 1);
}

TEST_CASE("Near and far: the depth step is the distance at which two floats differ") {
    raster::Camera camera;
    for (const double near : {0.1, 1e-3, 1e-5}) {
        camera.near = static_cast<float>(near);
        const double step = depth_step_at(camera, 4.0), n = camera.near, f = camera.far;
        const auto depth = [&](double z) { return f * (z - n) / (z * (f - n)); };
        CHECK((depth(4.0 + 0.5 * step) - depth(4.0 - 0.5 * step)) * std::exp2(24.0) ==
              doctest::Approx(1.0).epsilon(0.01));  // the slope changes a little over a large step
    }
}
