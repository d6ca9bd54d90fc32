// Views are the channels of the passes: held against geometry known by hand and against the picture itself.
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "raster/shapes.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::scene;

namespace {

/// The unit ball before an orthographic camera whose picture is two units high.
Scene viewed_ball(const std::string& more) {
    return read_scene_text(
        "[image]\nsize = [64, 64]\n[camera]\nposition = [0, 0, 4]\nprojection = \"orthographic\"\n"
        "height = 2\nnear = 1\nfar = 9\n[[light]]\ndirection = [-1, -2, -1]\n"
        "[[object]]\nmesh = \"sphere\"\ndetail = 256\nmaterial = \"m\"\n[[material]]\nname = \"m\"\n" +
            more,
        "test", "");
}

raster::Image draw(const Scene& scene, std::string_view name) {
    const View* view = find_view(name);
    REQUIRE(view);
    RenderBuffers buffers;
    render(scene, make_plan(scene, {view}), buffers);
    return buffers.views[0];
}

/// The point of the ball seen at the centre of a pixel.
glm::vec3 seen_at(int x, int y) {
    const float px = (float(x) + 0.5f) / 32.0f - 1.0f, py = 1.0f - (float(y) + 0.5f) / 32.0f;
    return {px, py, std::sqrt(1.0f - px * px - py * py)};
}

}  // namespace

TEST_CASE("views: position and normal and depth of a ball are those of the geometry") {
    const Scene scene = viewed_ball("");
    const raster::Image position = draw(scene, "position"), normal = draw(scene, "normal"),
                        depth = draw(scene, "depth");
    for (const int x : {20, 32, 45}) {
        for (const int y : {18, 32, 44}) {
            CAPTURE(x);
            CAPTURE(y);
            const glm::vec3 p = seen_at(x, y);
            // The chords of 256 segments lie at most 1 - cos(pi/256) = 8e-5 below the ball; twice that where it
            // slopes.
            CHECK(glm::distance(position.rgb(x, y), p) < 3e-4f);
            CHECK(glm::distance(normal.rgb(x, y), p) < 3e-4f);
            CHECK(depth.at(0, x, y) == doctest::Approx((4.0f - p.z - 1.0f) / 8.0f).epsilon(1e-3));
        }
    }
    CHECK(depth.at(0, 0, 0) == 1.0f);
    CHECK(normal.rgb(0, 0) == glm::vec3(0.0f));
}

TEST_CASE("views: ambient and light add up to the radiance") {
    for (const char* model : {"lambert", "phong", "blinn_phong", "ward", "cook_torrance"}) {
        CAPTURE(model);
        const Scene scene = viewed_ball("model = \"" + std::string(model) + "\"\nemission = [0.1, 0.2, 0.3]\n");
        const raster::Image ambient = draw(scene, "ambient"), light = draw(scene, "light");
        const raster::Image radiance = draw(scene, "radiance");
        for (std::size_t i = 0; i < radiance.values.size(); ++i) {
            REQUIRE(radiance.values[i] == doctest::Approx(ambient.values[i] + light.values[i]).epsilon(1e-6));
        }
    }
}

TEST_CASE("views: the radiance view is the film to the last bit and a view does not change the film") {
    const Scene scene = viewed_ball("");
    const raster::Image film = render(scene);
    CHECK(draw(scene, "radiance").values == film.values);
    RenderBuffers buffers;
    render(scene, make_plan(scene, {find_view("position"), find_view("normal")}), buffers);
    CHECK(buffers.film.values == film.values);
}

TEST_CASE("views: sigma and its power and Lambert's cosine rebuild what the light adds") {
    for (const char* model : {"phong", "blinn_phong"}) {
        CAPTURE(model);
        const Scene scene = viewed_ball("model = \"" + std::string(model) +
                                        "\"\ndiffuse = [0.5, 0.25, 0.125]\nspecular = [0.75, 0.5, 1]\nshininess = 9\n");
        const raster::Image cosine = draw(scene, "n_dot_l"), sigma = draw(scene, "sigma"),
                            highlight = draw(scene, "highlight"), diffuse = draw(scene, "diffuse"),
                            specular = draw(scene, "specular");
        const glm::vec3 l = glm::normalize(glm::vec3(1.0f, 2.0f, 1.0f)), v(0.0f, 0.0f, 1.0f);
        int lit = 0;
        for (int y = 4; y < 60; y += 7) {
            for (int x = 8; x < 56; x += 7) {
                CAPTURE(x);
                CAPTURE(y);
                const glm::vec3 n = seen_at(x, y);  // exact to 3e-4, as above, so is n.l; Sigma to twice that
                const float n_dot_l = glm::dot(n, l);
                const float exact = std::string(model) == "phong" ? glm::dot(v, 2.0f * n_dot_l * n - l)
                                                                  : glm::dot(n, glm::normalize(l + v));
                if (!std::isfinite(exact) || std::abs(n_dot_l) < 3e-4f) continue;
                CHECK(std::abs(cosine.at(0, x, y) - std::max(n_dot_l, 0.0f)) < 3e-4f);
                if (n_dot_l < 0.0f) {
                    CHECK(highlight.at(0, x, y) == 0.0f);
                    continue;
                }
                ++lit;
                CHECK(std::abs(sigma.at(0, x, y) - std::max(exact, 0.0f)) < 8e-4f);
                CHECK(highlight.at(0, x, y) == doctest::Approx(std::pow(sigma.at(0, x, y), 9.0)).epsilon(1e-6));
                for (int c = 0; c < 3; ++c) {
                    const float m_D = 0.5f / float(1 << c), m_S = c == 2 ? 1.0f : 0.75f - 0.25f * float(c);
                    CHECK(diffuse.at(c, x, y) == doctest::Approx(m_D * cosine.at(0, x, y)).epsilon(1e-6));
                    CHECK(specular.at(c, x, y) == doctest::Approx(m_S * highlight.at(0, x, y)).epsilon(1e-6));
                }
            }
        }
        CHECK(lit > 20);
    }
}

TEST_CASE("views: a light that is left out where it shines on the back leaves no trace in any bit") {
    // A film with a view is drawn with every light at every point; one without leaves out what adds nothing. The
    // lamps stand to the sides and behind, each lighting another part; the spot lights a patch.
    const std::string lamps =
        "[[light]]\ndirection = [-1, -2, -1]\nshadow = true\n[[light]]\ntype = \"point\"\nposition = [3, 0, "
        "0.5]\nshadow = true\n"
        "[[light]]\ntype = \"point\"\nposition = [0, 0, -3]\n"
        "[[light]]\ntype = \"spot\"\nposition = [-2, -2, 2]\ndirection = [1, 1, -1]\n"
        "[[light]]\ntype = \"directional\"\ndirection = [0, 1, 0.2]\n";
    for (const char* material :
         {"lambert", "phong", "blinn_phong", "ward", "ward\"\nward_alpha = [0.1, 0.5]\n#\"", "heidrich_seidel",
          "cook_torrance", "cook_torrance\"\nenergy_compensation = \"kulla_conty\"\n#\"",
          "phong\"\nshininess = 0\n#\""}) {
        CAPTURE(material);
        Scene scene = viewed_ball("model = \"" + std::string(material) + "\"\n");
        scene.lights = read_scene_text(lamps, "test", "").lights;
        scene.image.width = scene.image.height = 200;
        const raster::Image film = render(scene);
        RenderBuffers everything;
        render(scene, make_plan(scene, {find_view("normal")}), everything);
        CHECK(film.values == everything.film.values);
    }
}

TEST_CASE("views: a cook_torrance material shows its constants and D V F rebuild the highlight") {
    const Scene scene =
        viewed_ball("model = \"cook_torrance\"\nalbedo = [0.2, 0.4, 0.6]\nmetallic = 0.25\nroughness = 0.5\n");
    CHECK(draw(scene, "albedo").rgb(32, 32) == glm::vec3(0.2f, 0.4f, 0.6f));
    CHECK(draw(scene, "metallic").at(0, 32, 32) == 0.25f);
    CHECK(draw(scene, "roughness").at(0, 32, 32) == 0.5f);
    const glm::vec3 n = draw(scene, "normal").rgb(40, 20), l = draw(scene, "to_light").rgb(40, 20);
    const float D = draw(scene, "D").at(0, 40, 20), V = draw(scene, "V").at(0, 40, 20),
                G = draw(scene, "G").at(0, 40, 20);
    const glm::vec3 F = draw(scene, "F").rgb(40, 20), specular = draw(scene, "specular").rgb(40, 20);
    const float n_dot_l = glm::dot(n, l), n_dot_v = n.z;
    CHECK(G == doctest::Approx(4.0f * n_dot_l * n_dot_v * V).epsilon(1e-5));
    for (int c = 0; c < 3; ++c) CHECK(specular[c] == doctest::Approx(D * V * F[c] * n_dot_l).epsilon(1e-5));
}

TEST_CASE("views: the grain of threads runs up the ball along its meridians") {
    const Scene scene = viewed_ball("model = \"heidrich_seidel\"\ngrain = [0, 2, 0]\n");
    const raster::Image grain = draw(scene, "grain"), normal = draw(scene, "normal");
    for (const int y : {10, 32, 50}) {
        const glm::vec3 n = normal.rgb(40, y), t = grain.rgb(40, y);
        CHECK(std::abs(glm::dot(n, t)) < 1e-6f);
        CHECK(t.y == doctest::Approx(std::sqrt(1.0 - n.y * n.y)).epsilon(1e-5));
    }
    CHECK_FALSE(can_show(make_plan(viewed_ball("model = \"ward\"\n"), {}), viewed_ball("model = \"ward\"\n"),
                         *find_view("grain")));
}

TEST_CASE("views: what a scene does not write cannot be shown") {
    const Scene phong = viewed_ball("model = \"phong\"\n");
    const auto can = [](const Scene& scene, const char* name) {
        const View* view = find_view(name);
        REQUIRE(view);
        return can_show(make_plan(scene, {view}), scene, *view);
    };
    CHECK(can(phong, "diffuse"));
    CHECK_FALSE(can(phong, "D"));
    CHECK_FALSE(can(phong, "fog"));
    Scene flat = phong;
    flat.shading.frequency = ShadingFrequency::flat;
    CHECK_FALSE(can(flat, "diffuse"));
    CHECK(can(flat, "position"));
    CHECK(draw(flat, "position").rgb(32, 32) == draw(phong, "position").rgb(32, 32));
    Scene dark = phong;
    dark.lights[0].on = false;
    CHECK_FALSE(can(dark, "to_light"));
}

TEST_CASE("views: names are unique and every view says what it shows and needs") {
    std::set<std::string_view> names;
    for (const View& view : all_views()) {
        CAPTURE(view.name);
        CHECK(names.insert(view.name).second);
        CHECK(!view.meaning.empty());
        CHECK(!view.requires_what.empty());
        CHECK((view.components == 1 || view.components == 3));
    }
    CHECK(find_view("nothing") == nullptr);
}

TEST_CASE("views: a range picture runs from black to white over what is seen") {
    const Scene scene = viewed_ball("");
    const View* view = find_view("depth");
    const ViewPicture picture = picture_of(*view, draw(scene, "depth"), scene);
    REQUIRE(picture.ranges.size() == 1);
    CHECK(picture.encoded.at(0, 0, 0) == 1.0f);  // nothing seen
    const float* values = picture.encoded.plane(0);
    CHECK(*std::min_element(values, values + picture.encoded.plane_size()) == 0.0f);
    CHECK(picture.ranges[0].least == doctest::Approx(2.0 / 8.0).epsilon(1e-3));  // the ball's nearest point, z = 1
}
