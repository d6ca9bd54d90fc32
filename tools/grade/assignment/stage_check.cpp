#include "tools/grade/assignment/stage_check.hpp"

#include <algorithm>
#include <cmath>

#include "tools/explain/derivation.hpp"
#include "tools/grade/assignment/argument_text.hpp"

namespace kreda::tools {

namespace {

/// By how much one result of a row is off, in units of what is allowed; NaN counts as endless.
double error_of(const RubricStage& stage, const double* expected, const double* value, std::size_t count) {
    const double scale = largest(expected, count);
    double error = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        if (is_near(value[i], expected[i], scale, stage)) continue;
        const double off = std::abs(value[i] - expected[i]) / allowed_error(scale, stage);
        error = std::max(error, std::isfinite(off) ? std::max(off, 1.0) : HUGE_VAL);
    }
    return error;
}

bool all_finite(const double* values, std::size_t count) {
    return std::all_of(values, values + count, [](double v) { return std::isfinite(v); });
}

std::string at_text(const StageTable& input, std::size_t row) {
    const glm::ivec2 pixel = input.pixel.empty() ? glm::ivec2(-1) : input.pixel[row];
    if (pixel.x < 0) return " in " + input.scene;
    return " at pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ") of " + input.scene;
}

}  // namespace

StageCheck check_stage(const RubricStage& stage, const StageTable& input, const StageTable& expected,
                       const StageTable& answers) {
    StageCheck check;
    double most = 0.0;
    for (std::size_t row = 0; row < input.rows; ++row) {
        const bool doubtful = !input.doubtful.empty() && input.doubtful[row];
        bool wrong = false, finite = true;
        for (std::size_t c = 0; c < expected.columns.size(); ++c) {
            const std::size_t n = expected.columns[c].components;
            const double* e = expected.columns[c].values.data() + row * n;
            const double* a = answers.columns[c].values.data() + row * n;
            if (all_finite(e, n) && !all_finite(a, n)) finite = false;
            const double error = doubtful && finite ? 0.0 : error_of(stage, e, a, n);
            wrong = wrong || error > 0.0;
            if (error <= most) continue;
            most = error;
            check.worst = row;
            check.column = c;
        }
        check.not_finite += finite ? 0 : 1;
        check.rows += doubtful ? 0 : 1;
        check.wrong += wrong && !doubtful ? 1 : 0;
    }
    return check;
}

bool same_answers(const RubricStage& stage, const StageTable& input, const StageTable& a, const StageTable& b,
                  double share) {
    const auto doubtful = [&](std::size_t row) { return !input.doubtful.empty() && input.doubtful[row]; };
    std::size_t rows = 0, different = 0;
    for (std::size_t row = 0; row < input.rows; ++row) rows += doubtful(row) ? 0 : 1;
    const double most = share * static_cast<double>(rows);
    for (std::size_t row = 0; row < input.rows && static_cast<double>(different) <= most; ++row) {
        bool same = true;
        for (std::size_t c = 0; c < a.columns.size() && same; ++c) {
            const std::size_t n = a.columns[c].components;
            const double* x = a.columns[c].values.data() + row * n;
            const double* y = b.columns[c].values.data() + row * n;
            const bool both_broken = !all_finite(x, n) && !all_finite(y, n);
            same = both_broken || error_of(stage, x, y, n) <= 4.0;
        }
        different += same || doubtful(row) ? 0 : 1;
    }
    return static_cast<double>(different) <= most;
}

std::string describe_wrong_row(const RubricStage& stage, const StageTable& input, const StageTable& expected,
                               const StageTable& answers, const StageCheck& check) {
    const StageColumn& e = expected.columns[check.column];
    const StageColumn& a = answers.columns[check.column];
    const std::size_t at = check.worst * e.components;
    std::string text = stage.name + "(" + arguments_text(input, check.worst, number_text) + ")" +
                       at_text(input, check.worst) + ": yours gives " + e.name + " = " +
                       numbers_text(a.values.data() + at, a.components, number_text) + ", the lecture " +
                       numbers_text(e.values.data() + at, e.components, number_text);
    if (!stage.formula.empty()) text += ";  " + stage.formula;
    if (!stage.page.empty()) text += ", " + page_text(stage.page, stage.equation);
    return text;
}

std::string page_text(const std::string& page, int equation) {
    const std::string number = page.substr(0, page.find('_'));
    const std::string name = "page " + number + " (docs/" + page + ".md)";
    return equation > 0 ? "equation (" + std::to_string(equation) + ") of " + name : name;
}

}  // namespace kreda::tools
