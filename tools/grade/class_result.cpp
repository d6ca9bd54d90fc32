#include "tools/grade/class_result.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/grade/plain_text.hpp"
#include "tools/grade/report_page.hpp"
#include "tools/grade/submission_files.hpp"

namespace kreda::tools {

namespace {

Counts sorted(const std::map<std::string, std::size_t>& counts) {
    Counts list(counts.begin(), counts.end());
    std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    return list;
}

double share_of(const GradeResult& result) {
    return result.max_points > 0.0 ? std::clamp(result.points / result.max_points, 0.0, 1.0) : 0.0;
}

/// A field of a CSV file. A leading = + - @ would be a formula of a spreadsheet: a space goes before it.
std::string field(const std::string& text) {
    std::string plain = plain_text(text, 4000);
    if (!plain.empty() && std::string("=+-@\t").find(plain[0]) != std::string::npos) plain.insert(0, " ");
    if (plain.find_first_of(",\"\n") == std::string::npos) return plain;
    std::string quoted = "\"";
    for (const char c : plain) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::vector<std::string> test_names(const std::vector<GradeResult>& results) {
    std::vector<std::string> names;
    for (const GradeResult& result : results) {
        for (const TestResult& test : result.tests) {
            if (std::find(names.begin(), names.end(), test.name) == names.end()) names.push_back(test.name);
        }
    }
    return names;
}

std::string points_of_test(const GradeResult& result, const std::string& name) {
    for (const TestResult& test : result.tests) {
        if (test.name == name) return points_text(test.points);
    }
    return "";
}

std::string bars_html(const Counts& counts, std::size_t all) {
    if (counts.empty()) return "<p>None.</p>\n";
    std::size_t largest = 1;
    for (const auto& [name, count] : counts) largest = std::max(largest, count);
    std::string html = "<div class=\"bars\">\n";
    for (const auto& [name, count] : counts) {
        html += "<span>" + markup_text(name) + "</span><div><i style=\"width:" +
                std::to_string(std::max<std::size_t>(90 * count / largest, count > 0 ? 1 : 0)) + "%\"></i><span>" +
                std::to_string(count) + (all > 0 ? " of " + std::to_string(all) : "") + "</span></div>\n";
    }
    return html + "</div>\n";
}

std::string without_head(const std::string& text, const std::string& head) {
    return text.rfind(head, 0) == 0 ? text.substr(head.size()) : text;
}

/// The first line of a diagnosis. That answers are equal goes without saying; that they are only alike does not.
std::string mistake_text(const GradeResult& result) {
    return without_head(first_line(result.diagnosis), "looks exactly like: ");
}

Counts histogram_counts(const std::vector<GradeResult>& results) {
    const std::vector<std::size_t> bins = histogram(results);
    Counts counts;
    for (std::size_t i = 0; i < bins.size(); ++i)
        counts.emplace_back(std::to_string(10 * i) + " to " + std::to_string(10 * i + 10) + " %", bins[i]);
    return counts;
}

std::string identical_html(const std::vector<std::vector<std::string>>& identical) {
    std::string html;
    for (const std::vector<std::string>& group : identical) {
        html += "<li>";
        for (const std::string& name : group) html += (name == group.front() ? "" : ", ") + markup_text(name);
        html += "</li>\n";
    }
    html = html.empty() ? "<p>None.</p>\n" : "<ul>\n" + html + "</ul>\n";
    return html +
           "<p>Files that were changed here and there are found by tools made for it: <a "
           "href=\"https://dolos.ugent.be\">Dolos</a> (<code>dolos run -f web -l cpp */student.cpp</code>) or <a "
           "href=\"https://github.com/jplag/JPlag\">JPlag</a> (<code>java -jar jplag.jar -l cpp CLASS_FOLDER "
           "-bc STUB_FOLDER</code>).</p>\n";
}

std::string table_html(const std::vector<GradeResult>& results) {
    std::string html =
        "<div class=\"wide\"><table><tr><th>submission</th><th class=\"number\">points</th><th>diagnosis</th>"
        "<th>box</th></tr>\n";
    for (const GradeResult& result : results) {
        const std::string why = result.error.empty() ? mistake_text(result) : first_line(result.error);
        html += "<tr><td><a href=\"" + markup_text(link_of(result.submission)) + "/report.html\">" +
                markup_text(result.submission) + "</a></td><td class=\"number\">" + points_text(result.points) + " / " +
                points_text(result.max_points) + "</td><td>" + markup_text(why) + "</td><td>" + box_of(result) +
                "</td></tr>\n";
    }
    return html + "</table></div>\n";
}

}  // namespace

Counts failures_of_tests(const std::vector<GradeResult>& results) {
    std::map<std::string, std::size_t> counts;
    for (const std::string& name : test_names(results)) counts[name] = 0;
    for (const GradeResult& result : results) {
        for (const TestResult& test : result.tests) counts[test.name] += test.passed ? 0 : 1;
    }
    return sorted(counts);
}

Counts diagnoses(const std::vector<GradeResult>& results) {
    std::map<std::string, std::size_t> counts;
    for (const GradeResult& result : results) {
        if (!result.diagnosis.empty()) ++counts[without_head(mistake_text(result), "looks like: ")];
    }
    return sorted(counts);
}

std::vector<std::size_t> histogram(const std::vector<GradeResult>& results) {
    std::vector<std::size_t> bins(10, 0);
    for (const GradeResult& result : results)
        ++bins[std::min<std::size_t>(static_cast<std::size_t>(10.0 * share_of(result) + 1e-9), 9)];
    return bins;
}

std::vector<std::vector<std::string>> identical_submissions(const std::filesystem::path& folder,
                                                            const std::vector<std::string>& names) {
    std::map<std::string, std::vector<std::string>> by_content;
    for (const std::string& name : names) by_content[content_of(folder / name)].push_back(name);
    std::vector<std::vector<std::string>> groups;
    for (auto& [content, group] : by_content) {
        std::sort(group.begin(), group.end());
        if (group.size() > 1) groups.push_back(group);
    }
    std::sort(groups.begin(), groups.end());
    return groups;
}

std::string class_csv(const std::vector<GradeResult>& results) {
    const std::vector<std::string> names = test_names(results);
    std::string csv = "submission,points,max_points";
    for (const std::string& name : names) csv += "," + field(name);
    csv += ",diagnosis,box,error\r\n";
    for (const GradeResult& result : results) {
        csv += field(result.submission) + "," + points_text(result.points) + "," + points_text(result.max_points);
        for (const std::string& name : names) csv += "," + points_of_test(result, name);
        csv += "," + field(first_line(result.diagnosis)) + "," + box_of(result) + "," +
               field(first_line(result.error)) + "\r\n";
    }
    return csv;
}

std::string class_html(const std::vector<GradeResult>& results,
                       const std::vector<std::vector<std::string>>& identical) {
    const std::string title = results.empty() ? "No submissions" : results.front().assignment;
    const double sum =
        std::accumulate(results.begin(), results.end(), 0.0,
                        [](double total, const GradeResult& result) { return total + share_of(result); });
    const double mean = results.empty() ? 0.0 : 100.0 * sum / double(results.size());
    return report_head(title + ": the class") + "<header><h1>" + markup_text(title) + "</h1>\n<p class=\"total\"><b>" +
           std::to_string(results.size()) + "</b> submissions, on average " +
           points_text(std::round(mean * 10.0) / 10.0) +
           " % of the points (<a href=\"results.csv\">results.csv</a>)</p></header>\n<main>\n<h2>Points</h2>\n" +
           bars_html(histogram_counts(results), 0) + "<h2>Which test fails most</h2>\n" +
           bars_html(failures_of_tests(results), results.size()) + "<h2>Which mistake is most common</h2>\n" +
           bars_html(diagnoses(results), 0) + "<h2>Identical to the byte</h2>\n" + identical_html(identical) +
           "<h2>Submissions</h2>\n" + table_html(results) + report_foot();
}

}  // namespace kreda::tools
