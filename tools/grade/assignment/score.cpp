#include "tools/grade/assignment/score.hpp"

#include <algorithm>
#include <cmath>

#include "scene/files/image_file.hpp"
#include "tools/compare/compare_pictures.hpp"
#include "tools/explain/derivation.hpp"

namespace kreda::tools {

namespace {

std::vector<unsigned char> png_of(const raster::Image& encoded) {
    return scene::png_file_of("a picture of the report", encoded);
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

std::string wrong_row(const Marking& m, std::size_t i) {
    return describe_wrong_row(m.stage(i), m.cases.inputs[i], m.cases.expected[i], *m.answers[i], m.checks[i]);
}

void test_rows(const Marking& m, std::size_t i, TestResult& result) {
    const StageCheck& check = m.checks[i];
    result.measurements.push_back({"wrong rows, " + m.cases.inputs[i].scene, static_cast<double>(check.wrong), 0.0,
                                   "of " + std::to_string(check.rows) + "; a number may be off by " +
                                       number_text(m.stage(i).relative * 100.0) + " %",
                                   check.wrong == 0});
    if (check.passed()) return;
    const std::string count = std::to_string(check.wrong) + " of " + std::to_string(check.rows) + " rows wrong";
    const std::string broken =
        check.not_finite > 0 ? "; " + std::to_string(check.not_finite) + " with NaN or infinity" : "";
    fail(result, count + broken + "\n" + wrong_row(m, i));
}

void test_picture(const Marking& m, std::size_t i, bool with_pictures, TestResult& result) {
    const StageTable& input = m.cases.inputs[i];
    const SceneCase& scene = m.cases.scene(input.scene);
    const StageCheck& check = m.checks[i];
    const raster::Image expected = compose(scene, m.stage(i), input, m.cases.expected[i]);
    const raster::Image student = compose(scene, m.stage(i), input, *m.answers[i]);
    const raster::Image mask = doubtful_pixels(scene, input);
    const Comparison comparison = compare(student, expected, {256}, m.rubric.picture, &mask);
    result.measurements.push_back({"pixels with NaN or infinity, " + scene.name, static_cast<double>(check.not_finite),
                                   0.0, "", check.not_finite == 0});
    for (Measurement measurement : comparison.checks) {
        measurement.name += ", " + scene.name;
        result.measurements.push_back(measurement);
    }
    if (check.not_finite > 0) fail(result, std::to_string(check.not_finite) + " pixels with NaN or infinity");
    if (!comparison.passed) fail(result, describe(comparison) + (check.wrong > 0 ? "\n" + wrong_row(m, i) : ""));
    if (!with_pictures) return;
    result.images.push_back({"student", png_of(student)});
    result.images.push_back({"expected", png_of(expected)});
    result.images.push_back({"difference", png_of(heat_map(comparison, expected, {256}))});
}

/// A counter's sum beside what Kreda needs.
void test_work(const Marking& m, const RubricTest& test, std::size_t i, TestResult& result) {
    const auto sum = [&](const StageTable& table) {
        double total = 0.0;
        for (const double v : table.find(test.work)->values) total += v >= 0.0 ? v : HUGE_VAL;  // NaN, too
        return total;
    };
    const double most = sum(m.cases.expected[i]) * test.most_work;
    const double work = sum(*m.answers[i]);
    const std::string name = m.cases.inputs[i].scene;
    result.measurements.push_back({test.work + ", " + name, work, most, "at most", work <= most});
    if (work > most) {
        fail(result, test.work + ": " + number_text(work) + " in " + name + ", at most " + number_text(most));
    }
}

/// Is `stage` called by the function of table i? A picture calls all that stand before it.
bool calls(const Marking& m, std::size_t i, const std::string& stage) {
    const std::vector<std::string>& names = m.stage(i).calls;
    if (names.empty()) return m.stage(i).picture;
    return std::find(names.begin(), names.end(), stage) != names.end();
}

/// What is right although a function that it calls is wrong is right by accident: two mistakes cancel out.
void test_called(const Marking& m, std::size_t i, TestResult& result) {
    for (std::size_t k = 0; k < i; ++k) {
        const StageTable& before = m.cases.inputs[k];
        if (before.scene != m.cases.inputs[i].scene || !calls(m, i, before.stage) || m.is_right(k)) continue;
        fail(result, "this counts once " + before.stage + " is right: here another mistake makes up for it");
    }
}

void test_table(const Marking& m, const RubricTest& test, std::size_t i, bool with_pictures, TestResult& result) {
    if (m.answers[i] == nullptr) return fail(result, m.why[i]);
    if (m.stage(i).picture) {
        test_picture(m, i, with_pictures && test.work.empty(), result);
    } else {
        test_rows(m, i, result);
    }
    if (result.passed) test_called(m, i, result);
    if (!test.work.empty()) test_work(m, test, i, result);
}

/// Would run_test() pass it? What is cheap is asked first: a picture is drawn only where all it calls is right.
bool passes(const Marking& m, const RubricTest& test) {
    const std::vector<std::size_t> tables = tables_of(test, m.cases);
    TestResult result;
    result.passed = !tables.empty();
    for (const std::size_t i : tables) {
        if (m.answers[i] == nullptr || !(m.stage(i).picture || m.checks[i].passed())) return false;
        test_called(m, i, result);
    }
    for (const std::size_t i : tables) {
        if (!result.passed) return false;
        if (m.stage(i).picture) test_picture(m, i, false, result);
        if (!test.work.empty()) test_work(m, test, i, result);
    }
    return result.passed;
}

TestResult run_test(const Marking& m, const RubricTest& test, bool with_pictures) {
    TestResult result{test.name, test.teaches, 0.0, test.points, true, test.hidden, "", {}, {}, ""};
    const std::vector<std::size_t> tables = tables_of(test, m.cases);
    if (tables.empty()) fail(result, "no scene calls " + test.stage);
    for (const std::size_t i : tables) test_table(m, test, i, with_pictures, result);
    if (result.passed) result.points = test.points;
    return result;
}

bool any_hidden(const CaseSet& cases) {
    return std::any_of(cases.scenes.begin(), cases.scenes.end(), [](const SceneCase& s) { return s.hidden; });
}

}  // namespace

const RubricStage& Marking::stage(std::size_t i) const {
    return *rubric.find_stage(cases.inputs[i].stage);
}

Marking make_marking(const Rubric& rubric, const CaseSet& cases, const Answers& answers) {
    Marking m{rubric, cases, {}, answers.why, std::vector<StageCheck>(cases.inputs.size())};
    for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
        m.answers.push_back(is_answered(answers.tables[i]) ? &answers.tables[i] : nullptr);
        if (m.answers[i] == nullptr) continue;
        m.checks[i] = check_stage(m.stage(i), cases.inputs[i], cases.expected[i], answers.tables[i]);
    }
    return m;
}

std::vector<TestResult> score(const Marking& marking, bool with_pictures) {
    const bool has_hidden = any_hidden(marking.cases);
    std::vector<TestResult> results;
    for (const RubricTest& test : marking.rubric.tests) {
        if (!test.hidden || has_hidden) results.push_back(run_test(marking, test, with_pictures));
    }
    return results;
}

double points_of(const Marking& marking) {
    const bool has_hidden = any_hidden(marking.cases);
    double sum = 0.0;
    for (const RubricTest& test : marking.rubric.tests) {
        if ((!test.hidden || has_hidden) && passes(marking, test)) sum += test.points;
    }
    return sum;
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

namespace {

/// The first wrong stage of the public scenes or of the hidden ones, whose numbers are not told.
std::string first_wrong_of(const Marking& m, bool hidden) {
    std::string right;
    for (const RubricStage& stage : m.rubric.stages) {
        for (std::size_t i = 0; i < m.cases.inputs.size(); ++i) {
            const StageTable& input = m.cases.inputs[i];
            if (input.stage != stage.name || m.cases.scene(input.scene).hidden != hidden || m.is_right(i)) continue;
            const std::string before = right.empty() ? "" : right + "; ";
            if (m.answers[i] == nullptr) return before + stage.name + ": " + m.why[i];
            if (hidden) return before + stage.name + " wrong on a hidden scene";
            return before + wrong_row(m, i);
        }
        right += (right.empty() ? "" : ", ") + stage.name + " right";
    }
    return "";
}

}  // namespace

std::string first_wrong_stage(const Marking& marking) {
    const std::string on_public = first_wrong_of(marking, false);
    return on_public.empty() ? first_wrong_of(marking, true) : on_public;
}

}  // namespace kreda::tools
