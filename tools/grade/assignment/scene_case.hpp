// The scenes that a submission is tested on: the rows of every stage, Kreda's answers, the golden picture.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "raster/film.hpp"
#include "raster/image.hpp"
#include "tools/grade/assignment/rubric.hpp"
#include "tools/grade/assignment/stage_table.hpp"

namespace kreda::tools {

struct SceneCase {
    std::string name;
    std::filesystem::path file;
    bool hidden = false;
    raster::Image film;  ///< linear radiance, as `kreda render` draws it: the background of composed pictures
    raster::FilmSettings settings;
};

/// All scenes of a grading, public ones first. Tables lie scene by scene, in the order of the rubric's stages.
struct CaseSet {
    std::vector<SceneCase> scenes;
    std::vector<StageTable> inputs;
    std::vector<StageTable> expected;  ///< outputs; expected[i] belongs to inputs[i]

    [[nodiscard]] const SceneCase& scene(const std::string& name) const;
};

/// Draw the rubric's scenes, and all *.toml of the hidden folders, and record them. Throws UserError.
[[nodiscard]] CaseSet make_cases(const Rubric& rubric, const std::vector<std::filesystem::path>& hidden);

/// The tables of the public scenes alone, or of the hidden ones.
[[nodiscard]] std::vector<StageTable> part_of(const CaseSet& cases, const std::vector<StageTable>& tables, bool hidden);

/// A stage's answers as a picture: its rows laid over the scene's film, developed; values 0..1, encoded.
[[nodiscard]] raster::Image compose(const SceneCase& scene, const RubricStage& stage, const StageTable& input,
                                    const StageTable& answers);

/// The golden picture of a scene: what the rubric's picture stage should give, developed.
[[nodiscard]] raster::Image golden_picture(const Rubric& rubric, const CaseSet& cases, const SceneCase& scene);

/// White where rounding may decide.
[[nodiscard]] raster::Image doubtful_pixels(const SceneCase& scene, const StageTable& input);

/// The size of the largest of these numbers; 0 where there are none.
[[nodiscard]] double largest(const double* values, std::size_t count);

/// By how much a number may be off. `scale`: the largest of the numbers of the expected vector.
[[nodiscard]] double allowed_error(double scale, const RubricStage& stage);

/// May `value` stand for the expected one? `scale`: the largest of the numbers of the expected vector.
[[nodiscard]] bool is_near(double value, double expected, double scale, const RubricStage& stage);

}  // namespace kreda::tools
