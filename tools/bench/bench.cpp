#include "tools/bench/bench.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include <nlohmann/json.hpp>

#include "raster/shapes.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tools/bench/time_report.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    if (!file)
        throw scene::UserError({path.string()},
                               "cannot be opened; --workloads names the folder with W1.toml and W1.mesa");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Run a command and return what it prints.
std::string output_of(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    if (!pipe) throw scene::UserError("cannot run: " + command);
    std::string text;
    std::array<char, 4096> buffer;
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe.get())) text += buffer.data();
    return text;
}

/// One turn of Mesa's peer program with the libraries of a folder; "" is the system's.
double time_mesa(const BenchOptions& options, const std::string& libraries, std::string arguments,
                 const std::string& format) {
    std::replace(arguments.begin(), arguments.end(), '\n', ' ');
    const std::string path = libraries.empty() ? "" : "LD_LIBRARY_PATH='" + libraries + "' ";
    const std::string command = path + "LP_NUM_THREADS=" + std::to_string(options.threads) + " '" + options.mesa +
                                "' " + arguments + " --frames " + std::to_string(options.frames) + " --format " +
                                format;
    const nlohmann::json line = nlohmann::json::parse(output_of(command), nullptr, false);
    if (line.is_discarded()) throw scene::UserError("no JSON came from: " + command);
    return line.at("ms_median").get<double>();
}

std::string spread_text(const Spread& s) {
    char text[64];
    std::snprintf(text, sizeof text, "%.2f (%.2f..%.2f)", s.median, s.least, s.greatest);
    return text;
}

/// The rounds of one Mesa, in its two formats.
struct MesaTimes {
    std::vector<double> rgba8, rgba32f;
};

/// Two cells: the faster format, and the ratio.
std::string mesa_cells(const MesaTimes& times, const Spread& us) {
    const bool bytes_faster = spread_of(times.rgba8).median < spread_of(times.rgba32f).median;
    const Spread them = spread_of(bytes_faster ? times.rgba8 : times.rgba32f);
    char ratio[32];
    std::snprintf(ratio, sizeof ratio, "%.2f", them.median / us.median);
    return " " + spread_text(them) + (bytes_faster ? " rgba8 | " : " rgba32f | ") + ratio + " |";
}

void compare_workload(const BenchOptions& options, const std::string& name) {
    const fs::path folder = options.workloads;
    scene::Scene scene;
    try {
        scene = scene::read_scene((folder / (name + ".toml")).string());
    } catch (const scene::UserError& error) {
        std::printf("| %s | %s |\n", name.c_str(), error.what());
        return;
    }
    const std::string arguments = options.mesa.empty() ? "" : text_of(folder / (name + ".mesa"));
    std::vector<double> ours;
    std::vector<MesaTimes> theirs(options.libraries.size());
    for (int round = 0; round < options.rounds; ++round) {
        ours.push_back(time_frames(scene, options.frames, options.threads));
        for (std::size_t m = 0; m < theirs.size(); ++m) {
            theirs[m].rgba8.push_back(time_mesa(options, options.libraries[m], arguments, "rgba8"));
            theirs[m].rgba32f.push_back(time_mesa(options, options.libraries[m], arguments, "rgba32f"));
        }
    }
    const Spread us = spread_of(ours);
    std::string row = "| " + name + " | " + spread_text(us) + " |";
    for (const MesaTimes& times : theirs) row += mesa_cells(times, us);
    std::printf("%s\n", row.c_str());
    std::fflush(stdout);
}

/// A ball that fills the picture, Phong per pixel, one light.
scene::Scene growth_scene(const std::string& shape, int detail, int width, int height, int lights) {
    scene::Scene scene;
    scene.image.width = width;
    scene.image.height = height;
    scene.camera.position = {0.0f, shape == "terrain" ? 1.2f : 0.0f, shape == "terrain" ? 1.8f : 1.4f};
    scene.camera.near = 0.1f;
    scene.lights.resize(static_cast<std::size_t>(lights));
    scene.materials.resize(1);
    scene.materials[0].model = lighting::ReflectionModel::phong;
    scene::Object object;
    object.mesh = std::make_shared<raster::Mesh>(raster::make_shape(shape, detail).value());
    object.part_material.assign(object.mesh->parts.size(), 0);
    scene.objects = {object};
    return scene;
}

struct Point {
    double size = 0.0, ms = 0.0;
};

/// Exponent of a power law through the first and the last point: 1 is linear.
double exponent(const std::vector<Point>& points) {
    return std::log(points.back().ms / points.front().ms) / std::log(points.back().size / points.front().size);
}

void print_growth(const char* what, const char* unit, const std::vector<Point>& points) {
    std::printf("\n| %s | ms | ms a %s |\n| --- | --- | --- |\n", what, unit);
    for (const Point& p : points) std::printf("| %g | %.2f | %.3g |\n", p.size, p.ms, p.ms / p.size);
    const Point &first = points[points.size() - 2], &last = points.back();
    std::printf("\nSlope between the last two: %.3g ms a %s; exponent over all: %.2f\n",
                (last.ms - first.ms) / (last.size - first.size), unit, exponent(points));
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    return {median(values), *least, *greatest};
}

double time_frames(const scene::Scene& scene, int frames, int threads) {
    const scene::RenderPlan plan = make_plan(scene);
    scene::RenderBuffers buffers;
    render(scene, plan, buffers, threads);  // a frame to warm up: memory is asked for once
    std::vector<double> ms;
    for (int i = 0; i < frames; ++i) ms.push_back(render(scene, plan, buffers, threads).times.total_ms);
    return median(ms);
}

void compare_with_mesa(const BenchOptions& given) {
    BenchOptions options = given;
    if (options.mesa.empty()) options.libraries.clear();
    if (!options.mesa.empty() && options.libraries.empty()) options.libraries = {""};
    std::printf(
        "%d threads, %d rounds in turn, median of %d frames each; milliseconds: median (least..greatest) of the "
        "rounds\n\n",
        options.threads, options.rounds, options.frames);
    std::string head = "| workload | kreda |", line = "| --- | --- |";
    for (const std::string& libraries : options.libraries) {
        head += " llvmpipe" + (libraries.empty() ? "" : " of " + libraries) + ", its faster format | ratio |";
        line += " --- | --- |";
    }
    std::printf("%s\n%s\n", head.c_str(), line.c_str());
    for (const char* name : {"W1", "W2", "W3", "W4", "W5", "W6", "W7"}) compare_workload(options, name);
}

void measure_growth(int frames, int threads) {
    std::vector<Point> pixels, triangles, lights;
    for (const int side : {512, 724, 1024, 1448, 2048, 2896}) {
        const double megapixels = side * static_cast<double>(side) * 1e-6;
        pixels.push_back({megapixels, time_frames(growth_scene("sphere", 64, side, side, 1), frames, threads)});
    }
    print_growth("megapixels", "megapixel", pixels);
    for (const int detail : {24, 70, 224, 707, 1414}) {
        const double thousands = 2.0 * detail * detail * 1e-3;
        triangles.push_back({thousands, time_frames(growth_scene("terrain", detail, 1920, 1080, 1), frames, threads)});
    }
    print_growth("thousand triangles", "thousand", triangles);
    for (const int count : {1, 4, 16, 64}) {
        lights.push_back(
            {static_cast<double>(count), time_frames(growth_scene("sphere", 64, 1920, 1080, count), frames, threads)});
    }
    print_growth("lights", "light", lights);
    std::printf("\n| threads | ms |\n| --- | --- |\n");
    for (const int count : {1, 2}) {
        std::printf("| %d | %.2f |\n", count, time_frames(growth_scene("torus", 700, 1920, 1080, 1), frames, count));
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("\nPeak memory of the whole run (8.4 megapixels; 4 million triangles): %.0f MB\n",
                static_cast<double>(usage.ru_maxrss) / 1024.0);
}

}  // namespace kreda::tools
