// Assignments as a whole: solutions, stubs, builds, hidden scenes, questions, and rubrics that are wrong.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "shadows/shadow_map.hpp"
#include "tests/grading/lab.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/grade_submission.hpp"
#include "tools/grade/assignment/hidden_scenes.hpp"
#include "tools/grade/assignment/table_reader.hpp"
#include "tools/grade/assignment/viva.hpp"

using namespace kreda;
using namespace kreda::tests;
namespace fs = std::filesystem;

namespace {

const fs::path kAssignments = fs::path(KREDA_SOURCE_DIR) / "examples" / "assignments";

tools::Rubric rubric_of(const std::string& folder) {
    return tools::read_rubric(kAssignments / folder / "rubric.toml");
}

/// A submission's folder with this text as its student.cpp.
struct Submission {
    tools::BoxFolder folder;
    explicit Submission(const std::string& text) {
        std::ofstream(folder.path() / "student.cpp") << text;
    }
};

tools::GradeOptions unboxed_if_need_be() {
    tools::GradeOptions options;
    options.allow_unsafe = true;  // these are our own files
    return options;
}

tools::Answers all_answered(const std::vector<tools::StageTable>& tables) {
    return {tables, std::vector<std::string>(tables.size())};
}

std::string failures(const tools::GradeResult& result) {
    std::string text = result.error;
    for (const tools::TestResult& test : result.tests) {
        if (!test.passed) text += test.name + ": " + test.message + "\n";
    }
    return text;
}

}  // namespace

namespace {

double points_of(const tools::Rubric& rubric, const tools::CaseSet& cases, const tools::VariantAnswers& answers) {
    const tools::Answers all = all_answered(answers.all_of(0));
    return tools::points_of(tools::score(tools::make_marking(rubric, cases, all), false));
}

void check_stub(const std::string& folder) {
    CAPTURE(folder);
    const tools::Rubric rubric = rubric_of(folder);
    const tools::BoxFolder hidden;
    (void)tools::write_hidden_scenes(rubric, 23, hidden.path() / "scenes");
    const tools::CaseSet cases = tools::make_cases(rubric, {hidden.path() / "scenes"});
    CHECK(cases.scenes.size() == 2 * rubric.scenes.size());
    const std::string text = tools::read_text((kAssignments / folder / "student.cpp").string());
    CHECK(points_of(rubric, cases, tools::answers_of_variants(rubric, cases, {{{}, {}, text}})) == 0.0);
}

}  // namespace

TEST_CASE("stubs compile and score nothing" * doctest::skip()) {
    for (const std::string& folder : assignment_folders()) check_stub(folder);
}

// Each costs two seconds of compiling.
TEST_CASE("a stub compiles and scores nothing") {
    check_stub("A5_fog");
}

TEST_CASE("solutions score all, hidden scenes too; one seed gives one text") {
    const std::string text = tools::read_text(rubric_of("A3_lights").scenes[0].string());
    CHECK(tools::vary_scene(text, 17) == tools::vary_scene(text, 17));
    CHECK(tools::vary_scene(text, 17) != tools::vary_scene(text, 18));
    CHECK(tools::vary_scene("[camera]\ntarget = [1, 2, 3]\n", 5) == "[camera]\ntarget = [1, 2, 3]\n");
    for (const std::string& folder : assignment_folders()) {
        CAPTURE(folder);
        const tools::Rubric rubric = rubric_of(folder);
        const tools::BoxFolder hidden;
        const auto files = tools::write_hidden_scenes(rubric, 17, hidden.path() / "scenes");
        CHECK(files.size() == rubric.scenes.size());
        const tools::CaseSet cases = tools::make_cases(rubric, {hidden.path() / "scenes"});
        // The catalogue's program holds the solution; the tests of mistakes compile it as well.
        const std::vector<tools::Variant> variants =
            tools::make_variants(tools::read_solution(rubric), tools::read_mistakes(rubric), true);
        const tools::Answers solved = all_answered(tools::answers_of_variants(rubric, cases, variants, 1).all_of(0));
        const tools::Marking marking = tools::make_marking(rubric, cases, solved);
        const auto tests = tools::score(marking, false);
        CHECK(tools::first_wrong_stage(marking) == "");
        CHECK(tools::points_of(tests) == tools::max_points_of(tests));
        CHECK(tools::points_of(marking) == tools::max_points_of(tests));
    }
}

TEST_CASE("a solution through the box scores all with every compiler and level") {
    const tools::Rubric rubric = rubric_of("A3_lights");
    const tools::CaseSet cases = tools::make_cases(rubric, {});
    std::string reordered = tools::read_solution(rubric);  // another order of additions
    REQUIRE(tools::apply(
        {{"glm::vec3 sum = point.ambient_light * m.ambient + m.emission;", "glm::vec3 sum(0.0f);"},
         {"return sum;", "return m.emission + (sum + m.ambient * point.ambient_light);"},
         {"a.constant + a.linear * d + a.quadratic * d * d", "(a.quadratic * d + a.linear) * d + a.constant"}},
        reordered));
    std::vector<std::pair<std::string, tools::CompileOptions>> builds = {
        {tools::read_solution(rubric), {"/usr/bin/g++", {"-O0"}}},
        {reordered, {"/usr/bin/g++", {"-O3", "-march=native", "-ffp-contract=fast"}}},
        {reordered, {"/usr/bin/g++", {"-O2", "-ffast-math"}}}};
    if (fs::exists("/usr/bin/clang++")) builds.push_back({reordered, {"/usr/bin/clang++", {"-O2", "-mfma"}}});
    for (const auto& [text, compile] : builds) {
        const Submission submission(text);
        const tools::GradeResult result =
            tools::grade_submission(rubric, cases, submission.folder.path(), unboxed_if_need_be(), compile);
        CHECK(failures(result) == "");
        CHECK(result.points == result.max_points);
        CHECK(result.diagnosis == "");
    }
}

TEST_CASE("a crash costs one function and is told") {
    const tools::Rubric rubric = rubric_of("A3_lights");
    const tools::CaseSet cases = tools::make_cases(rubric, {});
    std::string text = tools::read_solution(rubric);
    REQUIRE(tools::apply(
        {{"return t * t * (3.0f - 2.0f * t);", "return t * t * (3.0f - 2.0f * t) * *(volatile float*)nullptr;"}},
        text));
    const Submission submission(text);
    const tools::GradeResult result =
        tools::grade_submission(rubric, cases, submission.folder.path(), unboxed_if_need_be());
    CHECK(result.tests[0].passed);
    CHECK_FALSE(result.tests[1].passed);
    CHECK(result.tests[1].message.find("signal 11") != std::string::npos);
    CHECK(result.tests[3].passed);
    CHECK(result.tests[4].passed);
}

TEST_CASE("a wrong submission is told which function and why, with numbers") {
    const tools::Rubric rubric = rubric_of("A3_lights");
    const Lab& l = lab("A3_lights");
    std::string text = tools::read_solution(rubric);
    REQUIRE(tools::apply({{"glm::normalize(point.normal)", "point.normal"}}, text));
    const Submission submission(text);
    tools::GradeOptions options = unboxed_if_need_be();
    options.viva = 4;
    const tools::GradeResult result = tools::grade_submission(rubric, l.cases, submission.folder.path(), options);
    CHECK(result.points == 8.0);
    CHECK(result.diagnosis.find("looks exactly like: the normal is not renormalised after interpolation (page 24)") ==
          0);
    CHECK(result.diagnosis.find("phong right; shade(") != std::string::npos);
    CHECK(result.diagnosis.find("yours gives color = (") != std::string::npos);
    CHECK(result.diagnosis.find("equation (1) of page 22") != std::string::npos);
    CHECK(result.viva.find("1. ") != std::string::npos);
    CHECK(result.viva.find("4. ") != std::string::npos);
    CHECK(result.viva.find("**") == std::string::npos);
    CHECK(result.viva_key.find("**") != std::string::npos);
}

namespace {

/// As a PNG holds it.
raster::Image in_bytes(raster::Image encoded) {
    for (float& v : encoded.values) v = static_cast<float>(scene::byte_from_encoded(v)) / 255.0f;
    return encoded;
}

}  // namespace

TEST_CASE("golden pictures are what kreda renders or what its functions answer") {
    for (const std::string& folder : assignment_folders()) {
        const tools::Rubric rubric = rubric_of(folder);
        const tools::CaseSet cases = tools::make_cases(rubric, {});
        for (const tools::SceneCase& scene : cases.scenes) {
            CAPTURE(scene.file.string());
            const raster::Image expected = golden_picture(rubric, cases, scene);
            const raster::Image golden =
                scene::read_image((rubric.folder() / "golden" / (scene.name + ".png")).string());
            const tools::Comparison exact = tools::compare(golden, in_bytes(expected), {256}, tools::kExact);
            CHECK_MESSAGE(exact.passed, describe(exact));
            // What the functions answer, pixel by pixel, is the picture that `kreda render` draws.
            const bool is_film = folder[1] >= '3' && folder[1] <= '6';
            if (!is_film) continue;
            CHECK(tools::compare(expected, develop(scene.film, scene.settings), {256}).passed);
        }
    }
}

TEST_CASE("a wrong rubric is one line with its place") {
    const tools::BoxFolder folder;
    const fs::path file = folder.path() / "rubric.toml";
    const std::string good = tools::read_text((kAssignments / "A3_lights" / "rubric.toml").string());
    const auto complaint = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        REQUIRE(tools::apply({{from, to}}, text));
        std::ofstream(file) << text;
        try {
            (void)tools::read_rubric(file);
        } catch (const scene::UserError& error) { return std::string(error.what()); }
        return std::string("read");
    };
    CHECK(complaint("assignment = \"A3\"", "assignment = \"A9\"").find("rubric.toml:2:14: 'assignment'") !=
          std::string::npos);
    CHECK(complaint("stage = \"attenuate\"", "stage = \"atenuate\"").find("no [[stage]]") != std::string::npos);
    CHECK(complaint("blob = 4", "blop = 4").find("did you mean 'blob'?") != std::string::npos);
    CHECK(complaint("name = \"2 spot's edge\"", "name = \"1 attenuation\"").find("two tests") != std::string::npos);
    CHECK(complaint("points = 4", "points = -4").find("from 0 to") != std::string::npos);
    CHECK(complaint("scene = \"spot\"", "scene = \"sport\"").find("is named sport.toml") != std::string::npos);
}

TEST_CASE("answers of the wrong shape are refused whole") {
    tools::TableBuilder builder("mirror_vector", "spot");
    builder.add("r", glm::vec3(1.0f, 2.0f, 3.0f));
    builder.end_row();
    const std::vector<tools::StageTable> expected = {builder.table};
    const std::string bytes = tools::encode_tables(expected);
    CHECK(tools::decode_tables(bytes, expected).tables.size() == 1);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const tools::DecodedTables cut = tools::decode_tables(bytes.substr(0, length), expected);
        CHECK(cut.tables.empty());
        CHECK(cut.complaint == "no whole result of mirror_vector for the scene spot");
    }
    std::string longer = bytes;
    longer.replace(longer.find(" 3 1 3"), 6, " 3 1 9");
    CHECK(tools::decode_tables(longer, expected).tables.empty());
}

TEST_CASE("two mistakes that cancel out do not count") {
    const tools::Rubric rubric = rubric_of("A8_image_light");
    const tools::CaseSet cases = tools::make_cases(rubric, {});
    std::string text = tools::read_solution(rubric);  // v upside down, and rows read from the bottom
    REQUIRE(tools::apply({{"const float v = 0.5f - std::asin(", "const float v = 0.5f + std::asin("},
                          {"image.texels[row * image.width", "image.texels[(image.height - 1 - row) * image.width"}},
                         text));
    const tools::Answers answers = all_answered(tools::answers_of_variants(rubric, cases, {{{}, {}, text}}).all_of(0));
    for (const tools::TestResult& test : tools::score(tools::make_marking(rubric, cases, answers), false)) {
        CAPTURE(test.name);
        const bool stands_alone =
            test.name == "3 cosine-weighted directions" || test.name == "5 half vectors" || test.name == "6 mip level";
        CHECK(test.passed == stands_alone);
        if (test.name == "4 irradiance")
            CHECK(test.message.find("counts once equirect_point is right") != std::string::npos);
    }
}
