#include "tools/grade/report_page.hpp"

#include <algorithm>
#include <cstdio>

#include "tools/base64.hpp"
#include "tools/grade/plain_text.hpp"
#include "tools/grade/report_style.hpp"
#include "tools/page_style.hpp"

namespace kreda::tools {

namespace {

std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string image_html(const ResultImage& image) {
    return "<img alt=\"" + markup_text(image.label) + "\" src=\"data:image/png;base64," + base64(image.png) + "\">";
}

const ResultImage* image_named(const TestResult& test, const std::string& label) {
    for (const ResultImage& image : test.images) {
        if (image.label == label) return &image;
    }
    return nullptr;
}

/// Student over expected, uncovered by a slider.
std::string slider_html(const ResultImage& student, const ResultImage& expected) {
    return "<figure><div class=\"slide\">" + image_html(expected) + image_html(student) +
           "<div class=\"line\"></div><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"how much "
           "of "
           "the student's picture is shown\" oninput=\"this.parentNode.style.setProperty('--at', this.value + '%')\">"
           "</div><div class=\"sides\"><span>student</span><span>expected</span></div></figure>\n";
}

std::string figure_html(const ResultImage& image) {
    return "<figure>" + image_html(image) + "<figcaption>" + markup_text(image.label) + "</figcaption></figure>\n";
}

std::string pictures_html(const TestResult& test) {
    if (test.images.empty()) return {};
    const ResultImage* student = image_named(test, "student");
    const ResultImage* expected = image_named(test, "expected");
    const bool is_pair = student && expected;
    std::string html = "<div class=\"pair\">\n" + (is_pair ? slider_html(*student, *expected) : std::string());
    for (const ResultImage& image : test.images) {
        if (!is_pair || (&image != student && &image != expected)) html += figure_html(image);
    }
    return html + "</div>\n";
}

std::string measurements_html(const TestResult& test) {
    if (test.measurements.empty()) return {};
    std::string html =
        "<div class=\"wide\"><table><tr><th>measured</th><th class=\"number\">value</th><th class=\"number\">limit</th>"
        "<th></th></tr>\n";
    for (const Measurement& measurement : test.measurements) {
        html += std::string(measurement.ok ? "<tr>" : "<tr class=\"wrong\">") + "<td>" + markup_text(measurement.name) +
                "</td><td class=\"number\">" + number_text(measurement.value) + "</td><td class=\"number\">" +
                (measurement.limit ? number_text(*measurement.limit) : "") + "</td><td>" +
                markup_text(measurement.text) + "</td></tr>\n";
    }
    return html + "</table></div>\n";
}

std::string test_html(const TestResult& test, Reader reader) {
    const bool is_secret = test.hidden && reader == Reader::student;
    std::string html = std::string("<article class=\"") + (test.passed ? "passed" : "failed") + "\">\n<h3>" +
                       markup_text(test.name) + (test.hidden ? " <span>hidden</span>" : "") + "<span class=\"points " +
                       (test.passed ? "good" : "bad") + "\">" + points_text(test.points) + " / " +
                       points_text(test.max_points) + "</span></h3>\n";
    if (!test.teaches.empty()) html += "<p class=\"teaches\">" + markup_text(test.teaches) + "</p>\n";
    if (is_secret) return html + "<p>A hidden scene: what it shows is told after the due date.</p>\n</article>\n";
    if (!test.message.empty()) html += "<pre>" + markup_text(test.message) + "</pre>\n";
    html += measurements_html(test) + pictures_html(test);
    if (!test.command.empty()) html += "<p class=\"again\">Again: <code>" + markup_text(test.command) + "</code></p>\n";
    return html + "</article>\n";
}

/// What it looks like, which may need several lines of the page, and below it the first wrong function.
std::string diagnosis_html(const std::string& diagnosis) {
    const std::size_t end = std::min(diagnosis.find('\n'), diagnosis.size());
    return "<p class=\"first\"><b>" + markup_text(diagnosis.substr(0, end)) + "</b>" +
           markup_text(diagnosis.substr(end)) + "</p>\n";
}

std::string summary_html(const GradeResult& result) {
    const std::string due = result.deadline.empty() ? "" : ", due " + result.deadline;
    std::string html = "<header><h1>" + markup_text(result.submission) + "</h1>\n<p>" +
                       markup_text(result.assignment + due) + "</p>\n<p class=\"total\"><b>" +
                       points_text(result.points) + "</b> of " + points_text(result.max_points) + " points</p>\n";
    if (!result.error.empty()) html += "<pre class=\"bad\">" + markup_text(result.error) + "</pre>\n";
    if (!result.diagnosis.empty()) html += diagnosis_html(result.diagnosis);
    return html + "</header>\n<main>\n";
}

}  // namespace

std::string report_head(const std::string& title) {
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
           "'unsafe-inline'; script-src 'unsafe-inline'\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           markup_text(title) + "</title>\n<style>" + kPageStyle + kReportStyle + "</style>\n</head>\n<body>\n";
}

std::string report_foot() {
    return "</main>\n</body>\n</html>\n";
}

std::string report_html(const GradeResult& result, Reader reader) {
    std::string failed, passed;
    std::size_t failures = 0, successes = 0;
    for (const TestResult& test : result.tests) {
        (test.passed ? passed : failed) += test_html(test, reader);
        ++(test.passed ? successes : failures);
    }
    std::string html = report_head(result.submission + ": " + result.assignment) + summary_html(result);
    if (failures > 0) html += "<h2 class=\"bad\">" + std::to_string(failures) + " failed</h2>\n" + failed;
    if (successes > 0) {
        html += std::string("<details") + (failures == 0 ? " open" : "") + "><summary><h2 class=\"good\">" +
                std::to_string(successes) + " passed</h2></summary>\n" + passed + "</details>\n";
    }
    html += result.tier ? "<footer>The submission was compiled and run in the box \"" + box_of(result) + "\", in " +
                              number_text(result.seconds) + " s.</footer>\n"
                        : "<footer>Nothing of the submission was run.</footer>\n";
    return html + report_foot();
}

}  // namespace kreda::tools
