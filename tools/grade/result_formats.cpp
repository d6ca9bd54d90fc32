#include "tools/grade/result_formats.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tools/base64.hpp"
#include "tools/grade/plain_text.hpp"

namespace kreda::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHidden = "A hidden scene: what it shows is told after the due date.";

std::string dump(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string limit_text(const Measurement& measurement) {
    std::string text = measurement.name + ": " + points_text(measurement.value);
    if (measurement.limit) text += " (limit " + points_text(*measurement.limit) + ")";
    if (!measurement.text.empty()) text += ", " + measurement.text;
    return text + (measurement.ok ? "" : "  <-- here");
}

/// The message, the measurements beside their limits, and the command that repeats it.
std::string told(const TestResult& test) {
    if (test.hidden) return kHidden;
    std::string text;
    const auto add = [&](const std::string& lines) { text += (text.empty() ? "" : "\n") + plain_text(lines); };
    if (!test.message.empty()) add(test.message);
    for (const Measurement& measurement : test.measurements) add(limit_text(measurement));
    if (!test.command.empty()) add("Again: " + test.command);
    return text;
}

std::string summary(const GradeResult& result) {
    std::string text = points_text(result.points) + " of " + points_text(result.max_points) + " points";
    if (!result.error.empty()) text += "\n" + plain_text(result.error);
    if (!result.diagnosis.empty()) text += "\n" + plain_text(result.diagnosis);
    return text;
}

double share(double points, double max_points) {
    return max_points > 0.0 ? std::clamp(points / max_points, 0.0, 1.0) : 0.0;
}

std::string seconds_text(double seconds) {
    return points_text(std::max(seconds, 0.0));
}

}  // namespace

std::string gradescope_json(const GradeResult& result) {
    Json json = {{"score", result.points},        {"execution_time", static_cast<int>(std::lround(result.seconds))},
                 {"output", summary(result)},     {"output_format", "text"},
                 {"test_output_format", "text"},  {"visibility", "visible"},
                 {"stdout_visibility", "hidden"}, {"extra_data", {{"box", box_of(result)}}},
                 {"tests", Json::array()}};
    int number = 0;
    for (const TestResult& test : result.tests) {
        json["tests"].push_back({{"score", test.points},
                                 {"max_score", test.max_points},
                                 {"status", test.passed ? "passed" : "failed"},
                                 {"name", plain_text(test.name)},
                                 {"number", std::to_string(++number)},
                                 {"output", told(test)},
                                 {"output_format", "text"},
                                 {"visibility", test.hidden ? "after_published" : "visible"}});
    }
    return dump(json);
}

std::string prairielearn_json(const GradeResult& result) {
    constexpr std::size_t kMostBytes = 900'000;  // of 1 MB
    Json json = {{"gradable", true},
                 {"score", share(result.points, result.max_points)},
                 {"message", plain_text(result.error.empty() ? first_line(result.diagnosis) : result.error)},
                 {"output", summary(result)},
                 {"tests", Json::array()}};
    for (const TestResult& test : result.tests) {
        json["tests"].push_back({{"name", plain_text(test.name)},
                                 {"description", plain_text(test.teaches)},
                                 {"points", test.points},
                                 {"max_points", test.max_points},
                                 {"message", test.hidden ? kHidden : plain_text(first_line(test.message))},
                                 {"output", told(test)}});
    }
    std::size_t size = dump(json).size();
    for (std::size_t i = 0; i < result.tests.size(); ++i) {
        const TestResult& test = result.tests[i];
        if (test.passed || test.hidden) continue;
        for (const ResultImage& image : test.images) {
            std::string url = "data:image/png;base64," + base64(image.png);
            size += url.size() + 200;
            if (size > kMostBytes) return dump(json);
            json["tests"][i]["images"].push_back({{"label", image.label}, {"url", std::move(url)}});
        }
    }
    return dump(json);
}

std::string classroom_json(const GradeResult& result) {
    const bool passed = result.error.empty() && result.points >= result.max_points;
    Json json = {{"version", 1},
                 {"status", !result.error.empty() ? "error"
                            : passed              ? "pass"
                                                  : "fail"},
                 {"max_score", result.max_points},
                 {"tests", Json::array()}};
    for (const TestResult& test : result.tests) {
        json["tests"].push_back({{"name", plain_text(test.name)},
                                 {"status", test.passed ? "pass" : "fail"},
                                 {"score", test.points},
                                 {"message", test.passed ? Json() : Json(told(test))},
                                 {"test_code", test.hidden ? "" : plain_text(test.command)},
                                 {"filename", ""},
                                 {"line_no", 0}});
    }
    return dump(json);
}

std::string classroom_text(const GradeResult& result) {
    const std::string json = classroom_json(result);
    const std::vector<unsigned char> bytes(json.begin(), json.end());
    return base64(bytes) + "\n";
}

std::string vpl_text(const GradeResult& result) {
    std::string text = "<|--\n";
    const auto add_lines = [&](const std::string& lines) {
        std::istringstream stream(lines);
        for (std::string line; std::getline(stream, line);) text += ">" + line + "\n";
    };
    text += "-Points\n";
    add_lines(summary(result));
    for (const TestResult& test : result.tests) {
        text += std::string("-") + (test.passed ? "Passed: " : "Failed: ") + first_line(plain_text(test.name)) + " (" +
                points_text(test.points) + " of " + points_text(test.max_points) + ")\n";
        if (!test.passed) add_lines(told(test));
    }
    char grade[32];
    std::snprintf(grade, sizeof grade, "%.2f", 100.0 * share(result.points, result.max_points));
    return text + "--|>\nGrade :=>> " + grade + "\n";
}

std::string junit_xml(const GradeResult& result) {
    std::size_t failures = 0, errors = 0;
    for (const TestResult& test : result.tests) {
        if (!test.passed) ++(result.error.empty() ? failures : errors);
    }
    const std::string counts = "tests=\"" + std::to_string(result.tests.size()) + "\" failures=\"" +
                               std::to_string(failures) + "\" errors=\"" + std::to_string(errors) +
                               "\" skipped=\"0\" time=\"" + seconds_text(result.seconds) + "\"";
    const std::string name = markup_text(result.assignment), submission = markup_text(result.submission);
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" + name + "\" " + counts +
                      ">\n  <testsuite name=\"" + submission + "\" " + counts + ">\n    <properties>\n";
    const auto property = [&](const std::string& key, const std::string& value) {
        xml += "      <property name=\"" + key + "\" value=\"" + markup_text(value) + "\" />\n";
    };
    property("points", points_text(result.points));
    property("max_points", points_text(result.max_points));
    property("box", box_of(result));
    property("diagnosis", first_line(result.diagnosis));
    xml += "    </properties>\n";
    for (const TestResult& test : result.tests) {
        xml += "    <testcase name=\"" + markup_text(test.name) + "\" classname=\"" + name + "\" time=\"0\"";
        if (test.passed) {
            xml += " />\n";
            continue;
        }
        const std::string kind = result.error.empty() ? "failure" : "error";
        const std::string message = !result.error.empty() ? result.error : test.hidden ? kHidden : test.message;
        xml += ">\n      <" + kind + " message=\"" + markup_text(first_line(message)) + "\" type=\"" + kind + "\">" +
               markup_text(told(test)) + "</" + kind + ">\n    </testcase>\n";
    }
    return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace kreda::tools
