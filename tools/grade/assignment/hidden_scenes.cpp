#include "tools/grade/assignment/hidden_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>

#include "scene/files/image_file.hpp"
#include "tools/grade/assignment/scene_case.hpp"
#include "tools/grade/assignment/table_reader.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

/// How the numbers of a key may move: each by a share of itself and by a step, within bounds.
struct Movement {
    const char* table;
    const char* key;
    double share, step;
    double least, most;
};

constexpr double kFar = 1e9;
constexpr std::array<Movement, 22> kMovements = {{
    {"camera", "position", 0.08, 0.12, -kFar, kFar}, {"ambient", "color", 0.2, 0.0, 0.0, 1.0},
    {"light", "direction", 0.15, 0.2, -kFar, kFar},  {"light", "position", 0.1, 0.15, -kFar, kFar},
    {"light", "color", 0.25, 0.0, 0.05, 1.0},        {"light", "intensity", 0.2, 0.0, 0.0, kFar},
    {"light", "attenuation", 0.25, 0.0, 0.0, kFar},  {"fog", "color", 0.2, 0.0, 0.0, 1.0},
    {"fog", "start", 0.2, 0.0, 0.0, kFar},           {"fog", "end", 0.2, 0.0, 0.0, kFar},
    {"fog", "density", 0.25, 0.0, 0.0, kFar},        {"shadow", "constant_bias", 0.2, 0.0, 0.0, kFar},
    {"shadow", "slope_bias", 0.2, 0.0, 0.0, kFar},   {"material", "ambient", 0.2, 0.0, 0.0, 1.0},
    {"material", "diffuse", 0.25, 0.02, 0.05, 0.95}, {"material", "specular", 0.25, 0.02, 0.1, 0.9},
    {"material", "emission", 0.25, 0.0, 0.0, 1.0},   {"material", "shininess", 0.4, 0.0, 2.0, kFar},
    {"material", "albedo", 0.2, 0.02, 0.05, 0.95},   {"material", "roughness", 0.15, 0.0, 0.25, 0.9},
    {"object", "rotate", 0.0, 12.0, -kFar, kFar},    {"object", "scale", 0.06, 0.0, 0.01, kFar},
}};

/// Numbers that are the same everywhere: the standard fixes the generator, and this takes its bits.
struct Dice {
    std::mt19937 generator;
    /// In [-1, 1).
    double swing() {
        return static_cast<double>(generator() >> 8) / 8388608.0 - 1.0;
    }
};

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// Every number of a value's text, moved; brackets and commas stay.
template <class Move>
std::string move_numbers(const std::string& text, const Move& move) {
    std::string moved;
    for (std::size_t at = 0; at < text.size();) {
        char* end = nullptr;
        const bool may_start = text[at] == '-' || std::isdigit(static_cast<unsigned char>(text[at])) != 0;
        const double value = may_start ? std::strtod(text.c_str() + at, &end) : 0.0;
        if (!may_start || end == text.c_str() + at) {
            moved += text[at++];
            continue;
        }
        moved += short_number(move(value));
        at = static_cast<std::size_t>(end - text.c_str());
    }
    return moved;
}

const Movement* find_movement(const std::string& table, const std::string& key) {
    for (const Movement& m : kMovements) {
        if (table == m.table && key == m.key) return &m;
    }
    return nullptr;
}

std::string without_brackets(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" []"), end = text.find_last_not_of(" []");
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// The numbers of one line `key = value`.
std::string vary_line(const std::string& line, const std::string& table, bool by_whole_pixels, Dice& dice) {
    const std::size_t equals = line.find('=');
    const std::string key = without_brackets(line.substr(0, equals));
    const std::string value = line.substr(equals + 1);
    if (value.find('"') != std::string::npos) return line;
    if (by_whole_pixels) {
        if (table != "object" || key != "translate") return line;
        int axis = 0;
        return key + " =" +
               move_numbers(value, [&](double v) { return axis++ < 2 ? v + std::floor(4.0 * dice.swing()) : v; });
    }
    const Movement* m = find_movement(table, key);
    if (m == nullptr) return line;
    return key + " =" + move_numbers(value, [&](double v) {
               return std::clamp(v * (1.0 + m->share * dice.swing()) + m->step * dice.swing(), m->least, m->most);
           });
}

}  // namespace

std::string vary_scene(const std::string& text, std::uint32_t seed) {
    Dice dice{std::mt19937(seed)};
    const bool by_whole_pixels = text.find("orthographic") != std::string::npos;
    std::istringstream lines(text);
    std::string varied, line, table;
    while (std::getline(lines, line)) {
        const bool is_comment = line.empty() || line[0] == '#';
        if (!is_comment && line[0] == '[') table = without_brackets(line);
        if (!is_comment && line[0] != '[' && line.find('=') != std::string::npos) {
            line = vary_line(line, table, by_whole_pixels, dice);
        }
        varied += line + "\n";
    }
    return varied;
}

std::vector<fs::path> write_hidden_scenes(const Rubric& rubric, std::uint32_t seed, const fs::path& folder) {
    make_folder(folder.string());
    std::vector<fs::path> files;
    for (const fs::path& scene : rubric.scenes) {
        const fs::path file = folder / (scene.stem().string() + "_" + std::to_string(seed) + ".toml");
        write_file(file.string(), vary_scene(read_text(scene.string()), seed + 7919u * std::uint32_t(files.size())));
        files.push_back(file);
    }
    const CaseSet cases = make_cases(rubric, {folder});
    for (const SceneCase& scene : cases.scenes) {
        if (!scene.hidden) continue;
        fs::path picture = scene.file;
        scene::write_png(picture.replace_extension(".png").string(), golden_picture(rubric, cases, scene));
    }
    for (const RubricStage& stage : rubric.stages) {
        const auto is_called = [&](const StageTable& t) {
            return t.stage == stage.name && cases.scene(t.scene).hidden;
        };
        if (std::any_of(cases.inputs.begin(), cases.inputs.end(), is_called)) continue;
        throw scene::UserError("no hidden scene of this seed calls " + stage.name + "; try another seed");
    }
    return files;
}

std::vector<fs::path> write_golden_pictures(const Rubric& rubric) {
    const fs::path folder = rubric.folder() / "golden";
    make_folder(folder.string());
    const CaseSet cases = make_cases(rubric, {});
    std::vector<fs::path> files;
    for (const SceneCase& scene : cases.scenes) {
        files.push_back(folder / (scene.name + ".png"));
        scene::write_png(files.back().string(), golden_picture(rubric, cases, scene));
    }
    return files;
}

}  // namespace kreda::tools
