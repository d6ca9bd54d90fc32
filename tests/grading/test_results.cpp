// Every format against what its system publishes, and against students who write into it.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "scene/error.hpp"
#include "tests/grading/sample_result.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/base64.hpp"
#include "tools/grade/plain_text.hpp"
#include "tools/grade/report_page.hpp"
#include "tools/grade/result_formats.hpp"

using namespace kreda::tests;
using namespace kreda::tools;
using nlohmann::json;

namespace {

std::string format_file(const std::string& name) {
    return bytes_of(std::string(KREDA_SOURCE_DIR) + "/tests/grading/formats/" + name);
}

/// Every key is in the example, with a value of the same kind; null stands for a text that is left out.
void check_fits(const json& value, const json& example, const std::string& place) {
    CAPTURE(place);
    if (value.is_null() && example.is_string()) return;
    const bool is_same_kind = value.is_number() ? example.is_number() : value.type() == example.type();
    CHECK(is_same_kind);
    if (value.is_object() && !example.empty()) {
        for (const auto& [key, item] : value.items()) {
            CAPTURE(key);
            CHECK(example.contains(key));
            if (example.contains(key)) check_fits(item, example[key], place + "." + key);
        }
    }
    if (value.is_array()) {
        for (const json& item : value) check_fits(item, example.at(0), place + "[]");
    }
}

std::string from_base64(const std::string& text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, count = 0;
    for (const char c : text) {
        if (c == '=' || c == '\n') break;
        bits = bits << 6 | static_cast<unsigned>(letters.find(c));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xFF);
    }
    return bytes;
}

/// What Moodle's VPL makes of the output: text between <|-- and --|> is comment, the last line of a grade counts.
std::string grade_of_vpl(const std::string& output) {
    std::istringstream stream(output);
    std::string grade;
    bool is_comment = false;
    for (std::string line; std::getline(stream, line);) {
        if (line == "<|--") is_comment = true;
        if (line == "--|>") is_comment = false;
        if (!is_comment && line.starts_with("Grade :=>>")) grade += "[" + line.substr(10) + "]";
    }
    return grade;
}

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

}  // namespace

TEST_CASE("results: base 64 as in RFC 4648") {
    const auto encoded = [](const std::string& text) {
        return base64(std::vector<unsigned char>(text.begin(), text.end()));
    };
    CHECK(encoded("") == "");  // the examples of section 10
    CHECK(encoded("f") == "Zg==");
    CHECK(encoded("fo") == "Zm8=");
    CHECK(encoded("foo") == "Zm9v");
    CHECK(encoded("foobar") == "Zm9vYmFy");
}

TEST_CASE("results: plain text is valid UTF-8 without controls") {
    CHECK(plain_text("a\tb\nc é 木 😀") == "a\tb\nc é 木 😀");
    CHECK(plain_text("\x1b[0m") == "?[0m");
    CHECK(plain_text("\xff\xc3") == "??");
    CHECK(plain_text("\xc0\xaf") == "??");            // '/' written too long
    CHECK(plain_text("\xed\xa0\x80") == "???");       // half a surrogate pair
    CHECK(plain_text("\xf4\x90\x80\x80") == "????");  // beyond U+10FFFF
    CHECK(plain_text("\xef\xbf\xbf") == "???");       // U+FFFF, which XML forbids
    CHECK(plain_text(std::string(100, 'x'), 10) == "xxxxxxxxxx\n... (90 bytes more)");
}

TEST_CASE("results: Gradescope's fits its published example") {
    const json result = json::parse(gradescope_json(sample_result()));
    check_fits(result, json::parse(format_file("gradescope.json")), "");
    CHECK(result["score"] == 2.5);
    CHECK(result["tests"].size() == 3);
    CHECK(result["tests"][0]["status"] == "passed");
    CHECK(result["tests"][1]["status"] == "failed");
    CHECK(result["tests"][1]["score"] == 0.5);
    CHECK(result["tests"][1]["output"].get<std::string>().find("pixels that differ: 12 (limit 5)") !=
          std::string::npos);
    CHECK(result["tests"][2]["visibility"] == "after_published");  // "hidden" would hide the sum, too
    CHECK(result["tests"][0]["visibility"] == "visible");
    CHECK(result["extra_data"]["box"] == "landlock");
}

TEST_CASE("results: PrairieLearn's fits its published example and its limit of 1 MB") {
    GradeResult sample = sample_result();
    const json example = json::parse(format_file("prairielearn.json"));
    const json result = json::parse(prairielearn_json(sample));
    check_fits(result, example, "");
    CHECK(result["score"].get<double>() == doctest::Approx(2.5 / 9.0));
    REQUIRE(result["tests"][1]["images"].size() == 3);
    CHECK(result["tests"][1]["images"][0]["url"] == "data:image/png;base64,AQID");  // the bytes 1, 2, 3
    CHECK_FALSE(result["tests"][2].contains("images"));
    sample.tests[1].images[0].png.resize(700'000);
    sample.tests[1].images[1].png.resize(700'000);
    const std::string large = prairielearn_json(sample);
    CHECK(large.size() < 1'000'000);
    check_fits(json::parse(large), example, "");
}

TEST_CASE("results: GitHub Classroom's is base 64 of what its reporter reads") {
    const std::string text = classroom_text(sample_result());
    CHECK(line_count(text) == 1);
    const json result = json::parse(from_base64(text));
    check_fits(result, json::parse(format_file("classroom.json")), "");
    CHECK(result["status"] == "fail");
    CHECK(result["max_score"] == 9.0);
    double sum = 0.0;
    for (const json& test : result["tests"]) sum += test["score"].get<double>();
    CHECK(sum == 2.5);
    CHECK(result["tests"][0]["message"].is_null());
    GradeResult broken = sample_result();
    broken.error = "does not compile";
    CHECK(json::parse(classroom_json(broken))["status"] == "error");
}

TEST_CASE("results: no line of a student's becomes a grade of VPL's") {
    const std::string text = vpl_text(sample_result());
    CHECK(grade_of_vpl(text) == "[ 27.78]");  // 100 * 2.5 / 9
    CHECK(text.ends_with("--|>\nGrade :=>> 27.78\n"));
    CHECK(count_of(text, "\n--|>\n") == 1);
}

TEST_CASE("results: JUnit XML is well-formed and has only elements and attributes that are common") {
    if (!std::filesystem::exists("/usr/bin/python3")) {
        MESSAGE("SKIPPED: python3 reads the XML");
        return;
    }
    const TempFolder folder;
    folder.write("junit.xml", junit_xml(sample_result()));
    const std::string script =
        "import sys, xml.etree.ElementTree as tree\n"
        "known = {line.split()[0]: set(line.split()[1:]) for line in open(sys.argv[2])}\n"
        "root = tree.parse(sys.argv[1]).getroot()\n"
        "for e in root.iter():\n"
        "    assert e.tag in known, e.tag\n"
        "    assert set(e.attrib) <= known[e.tag], e.attrib\n"
        "suite = root.find('testsuite')\n"
        "cases = suite.findall('testcase')\n"
        "print(suite.get('tests'), suite.get('failures'), suite.get('errors'), len(cases),\n"
        "      sum(c.find('failure') is not None for c in cases), cases[1].get('name'),\n"
        "      cases[1].find('failure').get('message'))\n";
    const std::string formats = std::string(KREDA_SOURCE_DIR) + "/tests/grading/formats/junit.txt";
    const Outcome outcome =
        run_program("/usr/bin/python3", {"-c", script, folder.file("junit.xml"), formats}, folder.path.string());
    CHECK(outcome.err == "");
    CHECK(outcome.out == "3 2 0 3 2 2 <depth> 12 rows wrong\n");
}

TEST_CASE("results: students' formats tell nothing of hidden tests but name and points") {
    const GradeResult sample = sample_result();
    for (const std::string& text : {gradescope_json(sample), prairielearn_json(sample), classroom_json(sample),
                                    vpl_text(sample), junit_xml(sample), report_html(sample, Reader::student)}) {
        CHECK(text.find("SECRET") == std::string::npos);
        CHECK(text.find("CQkJ") == std::string::npos);  // the picture's bytes 9, 9, 9 in base 64
        CHECK(text.find("3 hidden") != std::string::npos);
    }
    CHECK(report_html(sample, Reader::teacher).find("SECRET") != std::string::npos);
}

TEST_CASE("results: the page needs no network and runs no script of a student's") {
    const std::string page = report_html(sample_result(), Reader::teacher);
    CHECK(page.find("<script>alert") == std::string::npos);
    CHECK(page.find("&lt;script&gt;alert") != std::string::npos);
    CHECK(count_of(page, "src=\"") == count_of(page, "src=\"data:image/png;base64,"));
    CHECK(page.find("href=\"http") == std::string::npos);
    CHECK(page.find("2 failed") < page.find("1 passed"));
    CHECK(page.find(">landlock<") == std::string::npos);
    CHECK(page.find("\"landlock\"") != std::string::npos);
}

TEST_CASE("results: Kreda's own file is read again as it was") {
    const StoredResult stored = read_result_json(result_json(sample_result(), "key"), "file");
    CHECK(stored.key == "key");
    CHECK(stored.result.points == 2.5);
    CHECK(stored.result.tier == BoxTier::landlock);
    REQUIRE(stored.result.tests.size() == 3);
    CHECK(stored.result.tests[1].name == "2 <depth>");
    CHECK(stored.result.tests[1].measurements[0].limit == 5.0);
    CHECK_FALSE(stored.result.tests[1].measurements[0].ok);
    CHECK(stored.result.tests[2].hidden);
    for (const char* text : {"", "{}", "{\"format\": 99}", "[1]", "{\"format\": 1, \"key\": 3}"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(static_cast<void>(read_result_json(text, "file")), kreda::scene::UserError);
    }
}
