#include "tools/grade/assignment/viva.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <sstream>

#include "tools/explain/derivation.hpp"
#include "tools/grade/assignment/argument_text.hpp"
#include "tools/grade/assignment/table_reader.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

constexpr const char* kOfPixels = "Pixels count from (0, 0), the picture's top left.\n\n";

/// Whole numbers exactly, as edge functions need them; of others enough digits to work out two of a result.
std::string digits_of(double value) {
    char text[32];
    const bool is_whole = std::abs(value) < 1e15 && value == std::round(value);
    std::snprintf(text, sizeof text, is_whole ? "%.0f" : "%.5g", value);
    return text;
}

/// Numbers of a row of one column, "(0.1, 0.2, 0.3)".
std::string cell_text(const StageColumn& c, std::size_t row) {
    return numbers_text(c.values.data() + row * c.components, c.components, digits_of);
}

std::string call_text(const StageTable& input, std::size_t row) {
    return input.stage + "(" + arguments_text(input, row, digits_of) + ")";
}

std::string pixel_text(const StageTable& input, std::size_t row) {
    if (input.pixel.empty() || input.pixel[row].x < 0) return "in the scene " + input.scene;
    return "at pixel (" + std::to_string(input.pixel[row].x) + ", " + std::to_string(input.pixel[row].y) +
           ") of the scene " + input.scene;
}

/// Everything that questions are drawn from.
struct Source {
    const Rubric& rubric;
    const CaseSet& cases;
    const Answers& answers;
    std::mt19937 dice;
    std::map<std::string, int> asked = {};  ///< function -> how many questions want a value of it

    std::size_t pick(std::size_t count) {
        return dice() % count;
    }
    /// Tables of the public scenes that are answered and whose rows are small enough to be read out.
    [[nodiscard]] std::vector<std::size_t> tables() const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
            const StageTable& t = cases.inputs[i];
            const bool is_small = std::all_of(t.columns.begin(), t.columns.end(),
                                              [](const StageColumn& c) { return c.per_row && c.components <= 4; });
            if (is_small && is_answered(answers.tables[i]) && !cases.scene(t.scene).hidden) found.push_back(i);
        }
        return found;
    }
};

bool is_interesting(const StageTable& answers, std::size_t row) {
    for (const StageColumn& c : answers.columns) {
        for (std::size_t i = 0; i < c.components; ++i) {
            const double v = std::abs(c.values[row * c.components + i]);
            if (v > 0.001 && v != 1.0 && std::isfinite(v)) return true;
        }
    }
    return false;
}

/// Are the numbers of the answer among the arguments? Then there is nothing to work out.
bool stands_in_arguments(const StageTable& input, const StageColumn& answer, std::size_t row) {
    return std::any_of(input.columns.begin(), input.columns.end(), [&](const StageColumn& c) {
        return c.per_row && c.components == answer.components && cell_text(c, row) == cell_text(answer, row);
    });
}

/// What does your function give at this pixel? Functions that were asked for least often come first.
bool ask_value(Source& s, VivaQuestion& q) {
    const std::vector<std::size_t> tables = s.tables();
    for (int tries = 0; tries < 50 && !tables.empty(); ++tries) {
        const std::size_t i = tables[s.pick(tables.size())];
        const StageTable& input = s.cases.inputs[i];
        const StageTable& out = s.answers.tables[i];
        const std::size_t row = s.pick(input.rows);
        const auto fewer = [&](std::size_t k) { return s.asked[s.cases.inputs[k].stage] < s.asked[input.stage]; };
        const bool is_late = tries < 40 && std::any_of(tables.begin(), tables.end(), fewer);
        if (is_late || !is_interesting(out, row)) continue;
        const StageColumn& column = out.columns[s.pick(out.columns.size())];
        if (stands_in_arguments(input, column, row)) continue;
        ++s.asked[input.stage];
        q.question = "Work it out by hand: " + pixel_text(input, row) + " your program calls " + call_text(input, row) +
                     ". What does your function give for " + column.name + ", to two digits?";
        q.answer = column.name + " = " + cell_text(column, row);
        q.how = "what the submission's " + input.stage + " returned";
        return true;
    }
    return false;
}

double size_of(const StageColumn& c, std::size_t row) {
    double sum = 0.0;
    for (std::size_t i = 0; i < c.components; ++i) sum += c.values[row * c.components + i];
    return sum;
}

/// Which of the lights gives more here? Rows of one pixel stand in the order of the lights.
bool ask_light(Source& s, VivaQuestion& q) {
    for (int tries = 0; tries < 50; ++tries) {
        const std::vector<std::size_t> tables = s.tables();
        if (tables.empty()) return false;
        const std::size_t i = tables[s.pick(tables.size())];
        const StageTable& input = s.cases.inputs[i];
        const StageTable& out = s.answers.tables[i];
        if (input.find("l") == nullptr || input.pixel.empty()) continue;
        const StageColumn& column = out.columns.back();
        const auto is_amount = [](double v) { return v >= 0.0; };  // of light; directions have no greatest one
        if (!std::all_of(column.values.begin(), column.values.end(), is_amount)) continue;
        const glm::ivec2 pixel = input.pixel[s.pick(input.rows)];
        std::vector<std::size_t> rows;
        for (std::size_t row = 0; row < input.rows; ++row) {
            if (input.pixel[row] == pixel) rows.push_back(row);
        }
        if (pixel.x < 0 || rows.size() < 2) continue;
        const auto less = [&](std::size_t a, std::size_t b) { return size_of(column, a) < size_of(column, b); };
        const std::size_t best = *std::max_element(rows.begin(), rows.end(), less);
        const std::size_t next = *std::min_element(rows.begin(), rows.end(), less);
        if (!(size_of(column, best) > 1.5 * size_of(column, next) + 0.01)) continue;
        const std::size_t light = static_cast<std::size_t>(std::find(rows.begin(), rows.end(), best) - rows.begin());
        q.question = "The scene has " + std::to_string(rows.size()) +
                     " lights, counted from 0 as in its file. Which of them gives the greatest " + column.name +
                     " of your " + input.stage + " " + pixel_text(input, best) +
                     ", and how do you see that in the picture?";
        q.answer = "light " + std::to_string(light) + ": " + column.name + " = " + cell_text(column, best) +
                   "; the least is " + cell_text(column, next);
        q.how = "what the submission's " + input.stage + " returned for each light";
        return true;
    }
    return false;
}

/// The functions whose answers a change of the code changes, in the rubric's order.
std::string changed_functions(const Source& s, const Answers& changed) {
    std::string text;
    for (const RubricStage& stage : s.rubric.stages) {
        bool differs = false;
        for (std::size_t i = 0; i < s.cases.inputs.size(); ++i) {
            if (s.cases.inputs[i].stage != stage.name || s.cases.scene(s.cases.inputs[i].scene).hidden) continue;
            if (!is_answered(changed.tables[i]) || !is_answered(s.answers.tables[i])) return "";
            differs = differs || !same_answers(stage, s.cases.inputs[i], s.answers.tables[i], changed.tables[i], 0.0);
        }
        if (differs) text += (text.empty() ? "" : ", ") + stage.name;
    }
    return text;
}

/// Does a text stand in a line more than once?
bool is_repeated(const std::string& line, const std::string& text) {
    return line.find(text) != line.rfind(text);
}

/// What if this + were a -? The changed code is compiled and run.
bool ask_change(Source& s, const fs::path& submission, const GradeOptions& options, VivaQuestion& q) {
    const std::vector<ChangedLine> changes = changed_lines(read_text((submission / s.rubric.student_file).string()));
    for (int tries = 0; tries < 4 && !changes.empty(); ++tries) {
        const ChangedLine& change = changes[s.pick(changes.size())];
        const BoxFolder box, copy;
        write_file((copy.path() / s.rubric.student_file).string(), change.source);
        const Program program = compile_submission(s.rubric, copy.path(), box, options);
        if (program.file.empty()) continue;
        const std::string functions = changed_functions(s, run_submission(s.rubric, program, s.cases, options));
        if (functions.empty()) continue;
        const std::string op = " " + change.from + " ", which = is_repeated(change.text, op) ? "first " : "";
        q.question = "Line " + std::to_string(change.line) + " of your " + s.rubric.student_file + " is\n\n        " +
                     change.text + "\n\n    What if its " + which + "`" + change.from + "` were `" + change.to +
                     "`? Which of your functions would give other results on the public scenes, and how would the "
                     "picture change?";
        q.answer = functions;
        q.how = "the changed file was compiled and run: other answers of these functions";
        return true;
    }
    return false;
}

std::string numbered(const std::vector<VivaQuestion>& questions, bool with_answers) {
    std::string text;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        text += std::to_string(i + 1) + ". " + questions[i].question + "\n";
        if (with_answers) text += "\n    **" + questions[i].answer + "** (" + questions[i].how + ")\n";
        text += "\n";
    }
    return text;
}

}  // namespace

std::vector<ChangedLine> changed_lines(const std::string& source) {
    static const std::map<std::string, std::string> kSwaps = {{" + ", " - "}, {" - ", " + "}, {" * ", " + "},
                                                              {" / ", " * "}, {" < ", " > "}, {" > ", " < "}};
    std::vector<ChangedLine> changes;
    std::size_t begin = 0;
    for (int number = 1; begin < source.size(); ++number) {
        const std::size_t end = std::min(source.find('\n', begin), source.size());
        const std::string line = source.substr(begin, end - begin);
        const std::size_t comment = std::min(line.find("//"), line.size());
        for (const auto& [from, to] : kSwaps) {
            const std::size_t at = line.find(from);
            if (line.empty() || line[0] != ' ' || at == std::string::npos || at >= comment) continue;
            std::string changed = source;
            changed.replace(begin + at, from.size(), to);
            changes.push_back({number, line.substr(line.find_first_not_of(' ')), from.substr(1, 1), to.substr(1, 1),
                               std::move(changed)});
        }
        begin = end + 1;
    }
    return changes;
}

std::vector<VivaQuestion> make_viva(const Rubric& rubric, const CaseSet& cases, const fs::path& submission,
                                    const Answers& answers, int count, const GradeOptions& options) {
    const std::string seed = content_name(read_text((submission / rubric.student_file).string()));
    Source source{rubric, cases, answers, std::mt19937(static_cast<std::uint32_t>(std::stoull(seed, nullptr, 16)))};
    std::vector<VivaQuestion> questions;
    for (int tries = 0; tries < 3 * count && static_cast<int>(questions.size()) < count; ++tries) {
        VivaQuestion q;
        const bool asked = tries % 3 == 0   ? ask_value(source, q)
                           : tries % 3 == 1 ? ask_change(source, submission, options, q)
                                            : ask_light(source, q) || ask_value(source, q);
        const auto same = [&](const VivaQuestion& other) { return other.question == q.question; };
        if (asked && std::none_of(questions.begin(), questions.end(), same)) questions.push_back(q);
    }
    return questions;
}

std::string viva_sheet(const std::string& title, const std::vector<VivaQuestion>& questions) {
    return "# " + title + "\n\n" + kOfPixels + numbered(questions, false);
}

std::string viva_key(const std::string& title, const std::vector<VivaQuestion>& questions) {
    return "# " + title + ": answers, not for the student\n\n" + kOfPixels + numbered(questions, true);
}

}  // namespace kreda::tools
