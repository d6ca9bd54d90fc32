#include "tools/grade/assignment/score.hpp"

#include <algorithm>
#include <cmath>

#include "scene/files/image_file.hpp"
#include "scene/files/png_bytes.hpp"
#include "tools/compare/compare_pictures.hpp"
#include "tools/explain/derivation.hpp"

namespace kreda::tools {

namespace {

std::vector<unsigned char> png_of(const raster::Image& encoded) {
    scene::PngPicture picture{encoded.width, encoded.height, encoded.channels, {}};
    for (int y = 0; y < encoded.height; ++y) {
        for (int x = 0; x < encoded.width; ++x) {
            for (int c = 0; c < encoded.channels; ++c) {
                picture.values.push_back(scene::byte_from_encoded(encoded.at(c, x, y)));
            }
        }
    }
    return scene::encode_png("a picture of the report", picture);
}

/// The tables that a test looks at: indices into CaseSet::inputs.
std::vector<std::size_t> tables_of(const RubricTest& test, const CaseSet& cases) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
        const StageTable& t = cases.inputs[i];
        const bool wanted = t.stage == test.stage && (test.scene.empty() || t.scene == test.scene);
        if (wanted && cases.scene(t.scene).hidden == test.hidden) found.push_back(i);
    }
    return found;
}

/// Say what is wrong, the first time.
void fail(TestResult& result, const std::string& message) {
    if (result.passed) result.message = message;
    result.passed = false;
}

void test_rows(const RubricStage& stage, const CaseSet& cases, const Answers& answers, std::size_t i,
               TestResult& result) {
    const StageTable& input = cases.inputs[i];
    const StageCheck check = check_stage(stage, input, cases.expected[i], answers.tables[i]);
    result.measurements.push_back(
        {"wrong rows, " + input.scene, static_cast<double>(check.wrong), 0.0,
         "of " + std::to_string(check.rows) + "; a number may be off by " + number_text(stage.relative * 100.0) + " %",
         check.wrong == 0});
    if (check.passed()) return;
    const std::string count = std::to_string(check.wrong) + " of " + std::to_string(check.rows) + " rows wrong";
    const std::string broken =
        check.not_finite > 0 ? "; " + std::to_string(check.not_finite) + " with NaN or infinity" : "";
    fail(result, count + broken + "\n" + describe_wrong_row(stage, input, cases.expected[i], answers.tables[i], check));
}

void test_picture(const Rubric& rubric, const RubricStage& stage, const CaseSet& cases, const Answers& answers,
                  std::size_t i, bool with_pictures, TestResult& result) {
    const StageTable& input = cases.inputs[i];
    const SceneCase& scene = cases.scene(input.scene);
    const StageCheck check = check_stage(stage, input, cases.expected[i], answers.tables[i]);
    const raster::Image expected = compose(scene, stage, input, cases.expected[i]);
    const raster::Image student = compose(scene, stage, input, answers.tables[i]);
    const raster::Image mask = doubtful_pixels(scene, input);
    const Comparison comparison = compare(student, expected, {256}, rubric.picture, &mask);
    result.measurements.push_back({"pixels with NaN or infinity, " + scene.name, static_cast<double>(check.not_finite),
                                   0.0, "", check.not_finite == 0});
    for (Measurement m : comparison.checks) {
        m.name += ", " + scene.name;
        result.measurements.push_back(m);
    }
    if (check.not_finite > 0) fail(result, std::to_string(check.not_finite) + " pixels with NaN or infinity");
    if (!comparison.passed) {
        fail(result,
             describe(comparison) +
                 (check.wrong > 0 ? "\n" + describe_wrong_row(stage, input, cases.expected[i], answers.tables[i], check)
                                  : ""));
    }
    if (!with_pictures) return;
    result.images.push_back({"student", png_of(student)});
    result.images.push_back({"expected", png_of(expected)});
    result.images.push_back({"difference", png_of(heat_map(comparison, expected, {256}))});
}

/// A counter's sum beside what Kreda needs; rows must be right for it to count.
void test_work(const RubricTest& test, const CaseSet& cases, const Answers& answers, std::size_t i,
               TestResult& result) {
    const auto sum = [&](const StageTable& table) {
        double total = 0.0;
        for (const double v : table.find(test.work)->values) total += std::isfinite(v) && v > 0.0 ? v : 1e12;
        return total;
    };
    const double most = sum(cases.expected[i]) * test.most_work;
    const double work = sum(answers.tables[i]);
    const std::string name = cases.inputs[i].scene;
    result.measurements.push_back({test.work + ", " + name, work, most, "at most", work <= most});
    if (work > most) {
        fail(result, test.work + ": " + number_text(work) + " in " + name + ", at most " + number_text(most));
    }
}

/// A picture that is right although a function before it is wrong is right by accident: two mistakes cancel out.
void test_functions_before(const Rubric& rubric, const CaseSet& cases, const Answers& answers, std::size_t i,
                           TestResult& result) {
    for (std::size_t k = 0; k < i; ++k) {
        if (cases.inputs[k].scene != cases.inputs[i].scene) continue;
        const RubricStage& before = *rubric.find_stage(cases.inputs[k].stage);
        if (is_answered(answers.tables[k]) &&
            check_stage(before, cases.inputs[k], cases.expected[k], answers.tables[k]).passed()) {
            continue;
        }
        fail(result, "the picture counts once " + before.name + " is right: here another mistake makes up for it");
    }
}

void test_table(const Rubric& rubric, const RubricTest& test, const CaseSet& cases, const Answers& answers,
                std::size_t i, bool with_pictures, TestResult& result) {
    const RubricStage& stage = *rubric.find_stage(test.stage);
    if (!is_answered(answers.tables[i])) return fail(result, answers.why[i]);
    if (!test.work.empty()) return test_work(test, cases, answers, i, result);
    if (!stage.picture) return test_rows(stage, cases, answers, i, result);
    test_picture(rubric, stage, cases, answers, i, with_pictures, result);
    if (result.passed) test_functions_before(rubric, cases, answers, i, result);
}

TestResult run_test(const Rubric& rubric, const RubricTest& test, const CaseSet& cases, const Answers& answers,
                    bool with_pictures) {
    TestResult result{test.name, test.teaches, 0.0, test.points, true, test.hidden, "", {}, {}, ""};
    const std::vector<std::size_t> tables = tables_of(test, cases);
    if (tables.empty()) fail(result, "no scene calls " + test.stage);
    for (const std::size_t i : tables) test_table(rubric, test, cases, answers, i, with_pictures, result);
    if (result.passed) result.points = test.points;
    return result;
}

}  // namespace

std::vector<TestResult> score(const Rubric& rubric, const CaseSet& cases, const Answers& answers, bool with_pictures) {
    const bool has_hidden =
        std::any_of(cases.scenes.begin(), cases.scenes.end(), [](const SceneCase& s) { return s.hidden; });
    std::vector<TestResult> results;
    for (const RubricTest& test : rubric.tests) {
        if (!test.hidden || has_hidden) results.push_back(run_test(rubric, test, cases, answers, with_pictures));
    }
    return results;
}

double points_of(const std::vector<TestResult>& tests) {
    double sum = 0.0;
    for (const TestResult& test : tests) sum += test.points;
    return sum;
}

double max_points_of(const std::vector<TestResult>& tests) {
    double sum = 0.0;
    for (const TestResult& test : tests) sum += test.max_points;
    return sum;
}

std::string first_wrong_stage(const Rubric& rubric, const CaseSet& cases, const Answers& answers) {
    std::string right;
    for (const RubricStage& stage : rubric.stages) {
        for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
            if (cases.inputs[i].stage != stage.name) continue;
            const std::string before = right.empty() ? "" : right + "; ";
            if (!is_answered(answers.tables[i])) return before + stage.name + ": " + answers.why[i];
            const StageCheck check = check_stage(stage, cases.inputs[i], cases.expected[i], answers.tables[i]);
            if (check.passed()) continue;
            return before + describe_wrong_row(stage, cases.inputs[i], cases.expected[i], answers.tables[i], check);
        }
        right += (right.empty() ? "" : ", ") + stage.name + " right";
    }
    return "";
}

}  // namespace kreda::tools
