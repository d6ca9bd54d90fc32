// The same meshes, cameras and lights drawn by Mesa's llvmpipe, an independent renderer: where do the pictures differ?
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "raster/shapes.hpp"
#include "scene/files/mesh_file.hpp"
#include "scene/render/render.hpp"

using namespace kreda;

#if !defined(KREDA_MESA_PEER)

TEST_CASE("Pictures agree with Mesa") {
    MESSAGE("SKIPPED: Mesa's OSMesa (libosmesa6-dev) or the peer program ($KREDA_SHARED/peers/mesa) is absent");
}

#else

namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;

/// One object, as a file that both programs read, and as a mesh.
struct Subject {
    std::string name;
    std::string file;
    raster::Mesh mesh;
};

std::filesystem::path work_folder() {
    const std::filesystem::path folder = std::filesystem::path(KREDA_BINARY_DIR) / "mesa_compare";
    std::filesystem::create_directories(folder);
    return folder;
}

/// Nine digits bring every float back exactly.
void write_obj(const raster::Mesh& mesh, const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "w");
    REQUIRE(file != nullptr);
    for (const glm::vec3& p : mesh.positions) std::fprintf(file, "v %.9g %.9g %.9g\n", p.x, p.y, p.z);
    for (const glm::vec3& n : mesh.normals) std::fprintf(file, "vn %.9g %.9g %.9g\n", n.x, n.y, n.z);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const unsigned a = mesh.indices[i] + 1, b = mesh.indices[i + 1] + 1, c = mesh.indices[i + 2] + 1;
        std::fprintf(file, "f %u//%u %u//%u %u//%u\n", a, a, b, b, c, c);
    }
    std::fclose(file);
}

Subject built_in(const std::string& shape, int detail) {
    Subject subject{shape, (work_folder() / (shape + ".obj")).string(), raster::make_shape(shape, detail).value()};
    write_obj(subject.mesh, subject.file);
    return subject;
}

/// Read a PFM whose rows are written top row first.
raster::Image read_pfm(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    int width = 0, height = 0;
    double scale = 0.0;
    file >> magic >> width >> height >> scale;
    file.get();
    REQUIRE(magic == "PF");
    raster::Image image = raster::make_image(width, height, 3);
    std::vector<float> row(3 * static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        file.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(float)));
        for (int x = 0; x < width; ++x) image.set_rgb(x, y, {row[3 * x], row[3 * x + 1], row[3 * x + 2]});
    }
    REQUIRE(file.good());
    return image;
}

/// Where the camera stands so that the mesh fills the view.
struct View {
    glm::vec3 target{0.0f};
    glm::vec3 eye{0.0f};
};

View view_of(const raster::Mesh& mesh) {
    glm::vec3 least = mesh.positions[0], greatest = least;
    for (const glm::vec3& p : mesh.positions) {
        least = glm::min(least, p);
        greatest = glm::max(greatest, p);
    }
    const glm::vec3 centre = 0.5f * (least + greatest);
    return {centre, centre + 1.5f * glm::distance(least, greatest) * glm::normalize(glm::vec3(0.4f, 0.5f, 1.0f))};
}

std::string triple(const glm::vec3& v) {
    char text[96];
    std::snprintf(text, sizeof text, "%.9g,%.9g,%.9g", v.x, v.y, v.z);
    return text;
}

raster::Image render_with_mesa(const Subject& subject, const std::string& arguments) {
    const View view = view_of(subject.mesh);
    const std::string out = (work_folder() / "mesa.pfm").string();
    const std::string command =
        std::string(KREDA_MESA_PEER) + " --mesh '" + subject.file + "' --size 640x480 --eye " + triple(view.eye) +
        " --target " + triple(view.target) +
        " --fovy 45 --near 0.1 --far 1000 --cull back --light-dir 0.4,0.8,0.5 --ka 0.05,0.05,0.05"
        " --kd 0.7,0.2,0.2 --ks 0.5,0.5,0.5 --shininess 32 --out '" +
        out + "' " + arguments + " > /dev/null";
    REQUIRE(std::system(command.c_str()) == 0);
    return read_pfm(out);
}

scene::Scene scene_of(const Subject& subject) {
    const View view = view_of(subject.mesh);
    scene::Scene s;
    s.image.width = kWidth;
    s.image.height = kHeight;
    s.camera.position = view.eye;
    s.camera.target = view.target;
    s.camera.far = 1000.0f;
    s.ambient = glm::vec3(1.0f);
    s.lights.resize(1);
    s.lights[0].direction = {-0.4f, -0.8f, -0.5f};
    s.materials.resize(1);
    lighting::PhongMaterial& m = s.materials[0].phong;
    m.ambient = glm::vec3(0.05f);
    m.diffuse = {0.7f, 0.2f, 0.2f};
    m.specular = glm::vec3(0.5f);
    scene::Object object;
    object.mesh = std::make_shared<raster::Mesh>(subject.mesh);
    object.part_material.assign(subject.mesh.parts.size(), 0);
    s.objects = {object};
    return s;
}

/// 1 where a triangle is seen.
raster::Image coverage_of(const Subject& subject) {
    scene::Scene s = scene_of(subject);
    s.materials[0].model = lighting::ReflectionModel::unlit;
    s.materials[0].phong.diffuse = glm::vec3(1.0f);
    return scene::render(s);
}

/// A pixel well inside what both cover: its eight neighbours are covered, too.
bool inside(const raster::Image& a, const raster::Image& b, int x, int y) {
    if (x < 1 || y < 1 || x >= kWidth - 1 || y >= kHeight - 1) return false;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (a.at(0, x + dx, y + dy) == 0.0f || b.at(0, x + dx, y + dy) == 0.0f) return false;
        }
    }
    return true;
}

float largest_component(const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The bound agreed on; float rounding alone is about 1e-5.
constexpr float kBound = 2e-3f;

struct Difference {
    float largest = 0.0f;
    int compared = 0;
    int beyond = 0;  ///< pixels beyond kBound
};

/// Is there an edge of a face, or of what lies behind, within a pixel? There the peer's picture is no longer straight
/// from one neighbour to the other: its second difference jumps. Smooth gradients, however steep, have a small one.
bool at_edge(const raster::Image& image, int x, int y, float scale) {
    constexpr float kJump = 4e-3f;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
        const glm::vec3 second = image.rgb(x - dx, y - dy) - 2.0f * image.rgb(x, y) + image.rgb(x + dx, y + dy);
        if (largest_component(second) > kJump * scale) return true;
    }
    return false;
}

/// How far is our pixel from the peer's, or at an edge from the nearest of its 3 x 3: where an edge runs through the
/// centre of a pixel the two may choose different faces (Mesa's fill rule is ours upside down, and it interpolates from
/// positions before the snap).
float distance_to_peer(const raster::Image& ours, const raster::Image& mesa, int x, int y, float scale) {
    const int reach = at_edge(mesa, x, y, scale) ? 1 : 0;
    float least = 1e9f;
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            least = std::min(least, largest_component(ours.rgb(x, y) - mesa.rgb(x + dx, y + dy)));
        }
    }
    return least;
}

/// Largest difference over the inner pixels. Relative: to the pixel's own value, and to 5 % of white where it is
/// darker; next to the shadow side the value goes through 0 and a shift of 1/512 pixel is any share of it.
Difference compare(const raster::Image& ours, const raster::Image& mesa, const raster::Image& our_mask,
                   const raster::Image& mesa_mask, bool relative) {
    Difference difference;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (!inside(our_mask, mesa_mask, x, y)) continue;
            const float scale = relative ? std::max(largest_component(mesa.rgb(x, y)), 0.05f) : 1.0f;
            const float here = distance_to_peer(ours, mesa, x, y, scale) / scale;
            difference.largest = std::max(difference.largest, here);
            difference.beyond += here > kBound ? 1 : 0;
            ++difference.compared;
        }
    }
    return difference;
}

void check_colors(const Subject& subject, const scene::Scene& s, const std::string& arguments, bool relative = false) {
    const raster::Image mesa_mask = render_with_mesa(subject, "--mode coverage");
    const Difference d =
        compare(scene::render(s), render_with_mesa(subject, arguments), coverage_of(subject), mesa_mask, relative);
    std::printf("%-11s %-58s largest difference %.1e, %d of %d pixels beyond 2e-3\n", subject.name.c_str(),
                arguments.c_str(), static_cast<double>(d.largest), d.beyond, d.compared);
    CAPTURE(subject.name);
    CAPTURE(arguments);
    CHECK(d.compared > 5000);
    // Nearly edge-on triangles, narrower than a pixel, change over 1/512 pixel (our snap; Mesa interpolates from
    // positions before it) by more than the bound: measured at most 29 of 26,000 pixels, on the teapot with
    // Cook-Torrance.
    CHECK(d.beyond <= d.compared / 500);
    CHECK(d.largest <= 0.05f);
}

/// The light's picture as the peer draws it: a cube around the target, seen from its face next to the light.
shadows::LightView box_around(const glm::vec3& target, const glm::vec3& to_light, float half_side) {
    shadows::LightView view;
    view.view_from_world = shadows::light_axes(-to_light);
    view.origin = target + half_side * to_light;
    view.half_size = glm::vec2(half_side);
    view.near = 0.0f;
    view.far = 2.0f * half_side;
    return view;
}

std::vector<Subject> shapes() {
    return {built_in("sphere", 64), built_in("torus", 64),       built_in("terrain", 64),
            built_in("cube", 4),    built_in("torus_knot", 128), built_in("teapot", 8)};
}

}  // namespace

TEST_CASE("Coverage agrees with Mesa in 99.99 percent of the pixels") {
    std::vector<Subject> subjects = shapes();
    subjects.push_back(built_in("plane", 4));
    for (const char* name : {"bunny", "teapot", "spot"}) {
        const std::string file = std::string(KREDA_SHARED_DIR) + "/data/" + name + ".obj";
        if (std::filesystem::exists(file)) subjects.push_back({name, file, scene::load_mesh_file(file).mesh});
    }
    for (const Subject& subject : subjects) {
        const raster::Image ours = coverage_of(subject);
        const raster::Image mesa = render_with_mesa(subject, "--mode coverage");
        int different = 0, covered = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool here = ours.at(0, x, y) > 0.0f;
                different += here != (mesa.at(0, x, y) > 0.0f) ? 1 : 0;
                covered += here ? 1 : 0;
            }
        }
        std::printf("%-11s covers %6d pixels, %d differ\n", subject.name.c_str(), covered, different);
        CAPTURE(subject.name);
        CHECK(covered > 5000);
        CHECK(different <= kWidth * kHeight / 10000);
    }
}

TEST_CASE("Colours of flat and Gouraud and Phong shading agree with Mesa") {
    for (const Subject& subject : shapes()) {
        scene::Scene s = scene_of(subject);
        s.shading.frequency = scene::ShadingFrequency::flat;
        check_colors(subject, s, "--mode flat --flat-eval face --no-vertex-clamp");
        s.shading.frequency = scene::ShadingFrequency::gouraud;
        check_colors(subject, s, "--mode gouraud --no-vertex-clamp");
        s.shading.frequency = scene::ShadingFrequency::phong;
        check_colors(subject, s, "--mode blinn");
        s.materials[0].model = lighting::ReflectionModel::phong;
        check_colors(subject, s, "--mode phong");
    }
}

TEST_CASE("Every fog agrees with Mesa") {
    const Subject subject = built_in("terrain", 64);
    for (const char* mode : {"linear", "exp", "exp2"}) {
        for (const char* distance : {"planar", "radial"}) {
            scene::Scene s = scene_of(subject);
            s.materials[0].model = lighting::ReflectionModel::phong;
            s.fog.mode = std::string(mode) == "linear" ? lighting::FogMode::linear
                         : std::string(mode) == "exp"  ? lighting::FogMode::exp
                                                       : lighting::FogMode::exp2;
            s.fog.distance =
                std::string(distance) == "planar" ? lighting::FogDistance::planar : lighting::FogDistance::radial;
            s.fog.start = 3.0f;
            s.fog.end = 6.0f;
            s.fog.density = 0.2f;
            s.fog.color = {0.5f, 0.6f, 0.7f};
            check_colors(subject, s,
                         std::string("--mode phong --fog ") + mode + " --fog-coord " + distance +
                             " --fog-start 3 --fog-end 6 --fog-density 0.2 --fog-color 0.5,0.6,0.7");
        }
    }
}

TEST_CASE("Cook-Torrance agrees with Mesa to 2 in 1000 of the value") {
    for (const Subject& subject : shapes()) {
        for (const float roughness : {0.3f, 0.7f}) {
            scene::Scene s = scene_of(subject);
            s.materials[0].model = lighting::ReflectionModel::cook_torrance;
            lighting::CookTorranceMaterial& m = s.materials[0].cook_torrance;
            m.albedo = {0.7f, 0.2f, 0.2f};
            m.metallic = 0.2f;
            m.roughness = roughness;
            check_colors(
                subject, s,
                "--mode cooktorrance --albedo 0.7,0.2,0.2 --metallic 0.2 --roughness " + std::to_string(roughness),
                true);
        }
    }
}

TEST_CASE("The split sum of an environment agrees with Mesa") {
    const Subject subject = built_in("sphere", 64);
    const raster::Image mask = coverage_of(subject);
    for (const float roughness : {0.2f, 0.4f, 0.8f}) {
        scene::Scene s = scene_of(subject);
        s.ambient = glm::vec3(0.0f);
        s.environment.on = true;
        s.environment.sky = lighting::Sky::gradient;  // the same formula in both programs
        s.materials[0].model = lighting::ReflectionModel::cook_torrance;
        lighting::CookTorranceMaterial& m = s.materials[0].cook_torrance;
        m.albedo = {0.7f, 0.2f, 0.2f};
        m.metallic = 0.2f;
        m.roughness = roughness;
        const raster::Image ours = scene::render(s);
        const raster::Image mesa = render_with_mesa(
            subject, "--mode ibl --albedo 0.7,0.2,0.2 --metallic 0.2 --roughness " + std::to_string(roughness));
        double sum = 0.0, worst = 0.0;
        int compared = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                if (!inside(mask, mask, x, y)) continue;
                const double here = glm::distance(ours.rgb(x, y), mesa.rgb(x, y)) / largest_component(mesa.rgb(x, y));
                sum += here;
                worst = std::max(worst, here);
                ++compared;
            }
        }
        std::printf("environment, roughness %.1f: mean difference %.2e, largest %.2e of %d pixels\n",
                    static_cast<double>(roughness), sum / compared, worst, compared);
        CAPTURE(roughness);
        // The programs bake their maps on other grids (cube against equirectangular, levels by alpha against levels by
        // roughness), so they agree to the error of either map, not to rounding.
        CHECK(sum / compared < 2e-3);  // measured 1.2e-3
        CHECK(worst < 0.05);           // measured 3.6e-2, beside the sun
    }
}

TEST_CASE("A shadow map with three by three taps agrees with Mesa") {
    // The peer draws its map in a box of its own; the plan is told to look through the same one.
    const glm::vec3 to_light = glm::normalize(glm::vec3(0.8f, 0.35f, 0.3f));
    for (const Subject& subject : {built_in("terrain", 64), built_in("torus_knot", 128)}) {
        scene::Scene s = scene_of(subject);
        s.lights[0].direction = -to_light;
        s.lights[0].shadow = true;
        s.shadow.size = 512;
        s.shadow.filter = shadows::ShadowFilter::pcf;
        s.shadow.bias = shadows::ShadowBias::constant;
        s.shadow.constant_bias = 0.004f;
        const float half = 2.0f;
        scene::RenderPlan plan = make_plan(s, {scene::find_view("shadow")});
        REQUIRE(plan.shadows.size() == 1);
        plan.shadows[0].map.views = {box_around(view_of(subject.mesh).target, to_light, half)};
        scene::RenderBuffers buffers;
        render(s, plan, buffers);
        const std::string where = "--light-dir " + triple(to_light) + " --light-box 2 --shadow-size 512 --bias 0.004";
        const raster::Image mesa = render_with_mesa(subject, "--mode shadow " + where);
        const raster::Image mask = coverage_of(subject), mesa_mask = render_with_mesa(subject, "--mode coverage");
        int compared = 0, beyond = 0, dark = 0;
        double sum = 0.0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                if (!inside(mask, mesa_mask, x, y)) continue;
                const float here = distance_to_peer(buffers.film, mesa, x, y, 1.0f);
                beyond += here > kBound;
                sum += double{here};
                dark += buffers.views[0].at(0, x, y) < 1.0f;
                ++compared;
            }
        }
        std::printf("%-11s shadow map: mean difference %.1e, %d of %d pixels beyond 2e-3, %d of them in shadow\n",
                    subject.name.c_str(), sum / compared, beyond, compared, dark);
        CAPTURE(subject.name);
        CHECK(dark > compared / 20);
        // The texels are the same to the snap of 1/256. At a caster's outline the two fill rules choose differently,
        // and one tap of nine is a ninth of the light: measured 25 and 28 of some 30,000 pixels.
        CHECK(beyond <= compared / 500);
        CHECK(sum / compared < 1e-4);  // measured 3e-5
    }
}

#endif
