// An assignment in the browser: what `kreda grade` does, without the box. The page compiles the student's program and
// runs it; rows of numbers go out, answers come in, points and pictures go back. Text in, JSON out, as in
// web_module.cpp.
#include <string>

#include <nlohmann/json.hpp>

#include "tools/base64.hpp"
#include "tools/grade/assignment/score.hpp"
#include "tools/grade/assignment/table_reader.hpp"
#include "tools/grade/result_formats.hpp"

#define KREDA_WEB extern "C" __attribute__((used, visibility("default")))

namespace kreda::tools {

/// Nothing is boxed here but by the browser: no result has a tier.
std::string name_of(BoxTier) {
    return "none";
}

}  // namespace kreda::tools

namespace {

using Json = nlohmann::ordered_json;
using namespace kreda::tools;

struct Grading {
    Rubric rubric;
    CaseSet cases;
    Answers answers;
    std::string inputs;  ///< what the program reads
};

Grading& grading() {
    static Grading only;
    return only;
}

template <class Work>
const char* answer(Work work) {
    static std::string text;
    Json json;
    try {
        json = work();
    } catch (const std::exception& error) { json = {{"error", error.what()}}; }
    text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.c_str();
}

/// The tables of one stage ("": of all) that have no answer yet.
std::vector<std::size_t> unanswered(const Grading& g, const std::string& stage) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < g.cases.inputs.size(); ++i) {
        const bool is_wanted = stage.empty() || g.cases.inputs[i].stage == stage;
        if (is_wanted && !is_answered(g.answers.tables[i])) found.push_back(i);
    }
    return found;
}

Json pictures_of(const GradeResult& result) {
    Json pictures = Json::array();
    for (const TestResult& test : result.tests) {
        for (const ResultImage& image : test.images) {
            pictures.push_back({{"test", test.name}, {"label", image.label}, {"png", base64(image.png)}});
        }
    }
    return pictures;
}

}  // namespace

/// Draw the scenes of an assignment and record them.
KREDA_WEB const char* kreda_assignment(const char* rubric_file) {
    return answer([&] {
        Grading& g = grading();
        g.rubric = read_rubric(rubric_file);
        g.cases = make_cases(g.rubric, {});
        Json tests = Json::array();
        for (const RubricTest& test : g.rubric.tests) {
            const bool is_picture = g.rubric.find_stage(test.stage)->picture;
            tests.push_back({{"name", test.name}, {"stage", test.stage}, {"picture", is_picture}});
        }
        return Json{{"title", g.rubric.assignment + " " + g.rubric.title}, {"tests", tests}};
    });
}

/// A submission begins: nothing is answered. What its program reads, "size" bytes at "at".
KREDA_WEB const char* kreda_submission() {
    return answer([] {
        Grading& g = grading();
        g.answers = {std::vector<StageTable>(g.cases.inputs.size()), std::vector<std::string>(g.cases.inputs.size())};
        g.inputs = encode_tables(g.cases.inputs);
        return Json{{"at", reinterpret_cast<std::uintptr_t>(g.inputs.data())}, {"size", g.inputs.size()}};
    });
}

/// What the program wrote when it was asked for one stage ("": for all), a file; `why` it ended early, or "". "left":
/// the stages that have no answer.
KREDA_WEB const char* kreda_answers(const char* file, const char* stage, const char* why) {
    return answer([&] {
        Grading& g = grading();
        const std::vector<std::size_t> wanted = unanswered(g, stage);
        std::vector<StageTable> expected;
        for (const std::size_t i : wanted) expected.push_back(g.cases.expected[i]);
        DecodedTables decoded = decode_tables(read_text(file), expected);
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            if (k < decoded.tables.size())
                g.answers.tables[wanted[k]] = std::move(decoded.tables[k]);
            else
                g.answers.why[wanted[k]] = *why != '\0' ? why : decoded.complaint;
        }
        Json left = Json::array();
        for (const RubricStage& s : g.rubric.stages) {
            if (!unanswered(g, s.name).empty()) left.push_back(s.name);
        }
        return Json{{"left", left}};
    });
}

/// The points: "file" is the result.json of `kreda grade`, "pictures" PNG in base 64. `error`: why there was no program
/// to run, or "".
KREDA_WEB const char* kreda_result(const char* submission, const char* error, double seconds) {
    return answer([&] {
        Grading& g = grading();
        GradeResult result;
        result.assignment = g.rubric.assignment + " " + g.rubric.title;
        result.submission = submission;
        result.error = error;
        result.seconds = seconds;
        if (*error != '\0') g.answers.why.assign(g.cases.inputs.size(), "there is no program to test");
        const Marking marking = make_marking(g.rubric, g.cases, g.answers);
        result.tests = score(marking, *error == '\0');
        result.points = points_of(result.tests);
        result.max_points = max_points_of(result.tests);
        if (*error == '\0') result.diagnosis = first_wrong_stage(marking);
        return Json{{"file", result_json(result, "")}, {"pictures", pictures_of(result)}};
    });
}
