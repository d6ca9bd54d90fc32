#include "tools/grade/assignment/scene_case.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/error.hpp"
#include "scene/files/read_scene.hpp"
#include "tools/grade/assignment/assignment.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

/// The answers of Kreda's own functions.
StageTable answers_of(const Assignment& assignment, const StageTable& input) {
    StageTable out;
    out.stage = input.stage;
    out.scene = input.scene;
    out.rows = input.rows;
    for (std::size_t i = 0; i < input.rows; ++i) assignment.reference(StageRow{input, out, i});
    return out;
}

/// The same rows, every number that is not whole moved by some 3e-7 of itself, one way or the other.
StageTable shaken(const StageTable& input, unsigned seed) {
    StageTable table = input;
    std::uint32_t state = seed;
    for (StageColumn& column : table.columns) {
        for (double& value : column.values) {
            state = state * 1664525u + 1013904223u;
            if (value != std::floor(value)) value *= 1.0 + ((state >> 16 & 1) != 0 ? 3e-7 : -3e-7);
        }
    }
    return table;
}

double scale_of(const StageColumn& column, std::size_t row) {
    double scale = 0.0;
    for (std::size_t c = 0; c < column.components; ++c) {
        scale = std::max(scale, std::abs(column.values[row * column.components + c]));
    }
    return scale;
}

/// Mark the rows whose answer jumps when they are shaken.
void mark_doubtful(const Assignment& assignment, const RubricStage& stage, const StageTable& expected,
                   StageTable& input) {
    input.doubtful.assign(input.rows, false);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const StageTable other = answers_of(assignment, shaken(input, seed));
        for (std::size_t c = 0; c < expected.columns.size(); ++c) {
            const StageColumn& column = expected.columns[c];
            for (std::size_t i = 0; i < column.values.size(); ++i) {
                const std::size_t row = i / column.components;
                const bool same = is_near(other.columns[c].values[i], column.values[i], scale_of(column, row), stage);
                if (!same) input.doubtful[row] = true;
            }
        }
    }
}

void sort_by_stages(const Rubric& rubric, std::vector<StageTable>& tables) {
    const auto place = [&](const StageTable& t) { return rubric.find_stage(t.stage) - rubric.stages.data(); };
    std::stable_sort(tables.begin(), tables.end(),
                     [&](const StageTable& a, const StageTable& b) { return place(a) < place(b); });
}

void add_case(const Rubric& rubric, const fs::path& file, bool hidden, CaseSet& set) {
    const Assignment& assignment = *find_assignment(rubric.assignment);
    const scene::Scene scene = scene::read_scene(file.string());
    if (scene.image.samples != 1 || scene.image.width > 512 || scene.image.height > 512) {
        throw scene::UserError(scene::Place{file.string()},
                               "scenes of assignments have samples = 1 and at most 512 x 512 pixels");
    }
    SceneCase added{file.stem().string(), file, hidden, {}, film_settings(scene.image)};
    std::vector<StageTable> tables;
    added.film = record_scene(scene, added.name, [&](const SceneRecord& record) { assignment.record(record, tables); });
    std::erase_if(tables, [&](const StageTable& t) { return rubric.find_stage(t.stage) == nullptr; });
    sort_by_stages(rubric, tables);
    for (StageTable& table : tables) {
        StageTable expected = answers_of(assignment, table);
        if (!table.exact) mark_doubtful(assignment, *rubric.find_stage(table.stage), expected, table);
        set.inputs.push_back(std::move(table));
        set.expected.push_back(std::move(expected));
    }
    set.scenes.push_back(std::move(added));
}

std::vector<fs::path> scenes_in(const fs::path& folder) {
    if (!fs::is_directory(folder)) {
        throw scene::UserError(scene::Place{folder.string()}, "is no folder of hidden scenes");
    }
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    if (files.empty()) throw scene::UserError(scene::Place{folder.string()}, "holds no scene, no file *.toml");
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

const SceneCase& CaseSet::scene(const std::string& name) const {
    return *std::find_if(scenes.begin(), scenes.end(), [&](const SceneCase& s) { return s.name == name; });
}

CaseSet make_cases(const Rubric& rubric, const std::vector<fs::path>& hidden) {
    CaseSet set;
    for (const fs::path& file : rubric.scenes) add_case(rubric, file, false, set);
    for (const fs::path& folder : hidden) {
        for (const fs::path& file : scenes_in(folder)) add_case(rubric, file, true, set);
    }
    std::set<std::string> names;
    for (const SceneCase& s : set.scenes) {
        if (names.insert(s.name).second) continue;
        throw scene::UserError(scene::Place{s.file.string()}, "another scene has this name; rename one of the files");
    }
    return set;
}

std::vector<StageTable> part_of(const CaseSet& cases, const std::vector<StageTable>& tables, bool hidden) {
    std::vector<StageTable> part;
    for (const StageTable& table : tables) {
        if (cases.scene(table.scene).hidden == hidden) part.push_back(table);
    }
    return part;
}

raster::Image compose(const SceneCase& scene, const RubricStage& stage, const StageTable& input,
                      const StageTable& answers) {
    raster::Image picture = stage.encoded ? develop(scene.film, scene.settings) : scene.film;
    const StageColumn& color = answers.columns.front();
    const std::size_t n = color.components;
    for (std::size_t row = 0; row < input.rows; ++row) {
        for (int c = 0; c < 3; ++c) {
            const double value = color.values[row * n + (n == 3 ? static_cast<std::size_t>(c) : 0)];
            picture.at(c, input.pixel[row].x, input.pixel[row].y) = static_cast<float>(value);
        }
    }
    return stage.encoded ? without_non_finite(picture) : develop(picture, scene.settings);
}

raster::Image golden_picture(const Rubric& rubric, const CaseSet& cases, const SceneCase& scene) {
    for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
        const RubricStage& stage = *rubric.find_stage(cases.inputs[i].stage);
        if (stage.picture && cases.inputs[i].scene == scene.name) {
            return compose(scene, stage, cases.inputs[i], cases.expected[i]);
        }
    }
    return develop(scene.film, scene.settings);
}

raster::Image doubtful_pixels(const SceneCase& scene, const StageTable& input) {
    raster::Image mask = raster::make_image(scene.film.width, scene.film.height, 1);
    for (std::size_t row = 0; row < input.doubtful.size(); ++row) {
        if (input.doubtful[row]) mask.at(0, input.pixel[row].x, input.pixel[row].y) = 1.0f;
    }
    return mask;
}

double largest(const double* values, std::size_t count) {
    double scale = 0.0;
    for (std::size_t i = 0; i < count; ++i) scale = std::max(scale, std::abs(values[i]));
    return scale;
}

double allowed_error(double scale, const RubricStage& stage) {
    return stage.absolute + stage.relative * scale;
}

bool is_near(double value, double expected, double scale, const RubricStage& stage) {
    if (value == expected) return true;  // infinities, too
    return std::isfinite(value) && std::abs(value - expected) <= allowed_error(scale, stage);
}

}  // namespace kreda::tools
