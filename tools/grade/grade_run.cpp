#include "tools/grade/grade_run.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <system_error>

#include "scene/error.hpp"
#include "tools/grade/assignment/grade_submission.hpp"
#include "tools/grade/report_page.hpp"
#include "tools/grade/result_formats.hpp"
#include "tools/grade/submission_files.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

struct Format {
    std::string name;
    std::string file;  ///< below the result's folder; Gradescope and PrairieLearn both want a results.json
    std::string (*text)(const GradeResult& result);
};

const std::vector<Format>& formats() {
    static const std::vector<Format> all = {{"gradescope", "gradescope/results.json", gradescope_json},
                                            {"prairielearn", "prairielearn/results.json", prairielearn_json},
                                            {"classroom", "classroom.txt", classroom_text},
                                            {"vpl", "vpl.txt", vpl_text},
                                            {"junit", "junit.xml", junit_xml}};
    return all;
}

}  // namespace

const std::vector<std::string>& grade_formats() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Format& format : formats()) list.push_back(format.name);
        return list;
    }();
    return names;
}

std::string grade_key(const GradeRun& run) {
    std::string key = content_of(run.folder) + content_of(fs::absolute(run.rubric).parent_path());
    for (const fs::path& hidden : run.options.hidden) key += content_of(hidden);
    for (const std::string& format : run.formats) key += "," + format;
    if (run.options.viva > 0) key += ",viva " + std::to_string(run.options.viva);
    return key;
}

void write_results(const GradeRun& run, const GradeResult& result) {
    make_folder(run.out.string());
    write_file((run.out / "report.html").string(), report_html(result, Reader::teacher));
    write_file((run.out / "student.html").string(), report_html(result, Reader::student));
    for (const Format& format : formats()) {
        if (std::find(run.formats.begin(), run.formats.end(), format.name) == run.formats.end()) continue;
        const fs::path file = run.out / format.file;
        make_folder(file.parent_path().string());
        write_file(file.string(), format.text(result));
    }
    if (!result.viva.empty()) {
        write_file((run.out / "viva.md").string(), result.viva);
        write_file((run.out / "viva_key.md").string(), result.viva_key);
    }
    write_file((run.out / "result.json").string(), result_json(result, grade_key(run)));
}

std::optional<GradeResult> result_of_before(const GradeRun& run) {
    const fs::path file = run.out / "result.json";
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    try {
        const StoredResult stored = read_result_json(text, file.string());
        if (stored.key == grade_key(run)) return stored.result;
    } catch (const scene::UserError&) {  // of another version: it is graded again
    }
    return std::nullopt;
}

GradeResult grade_one(const GradeRun& run) {
    std::error_code unreadable;
    if (!fs::is_directory(run.folder, unreadable))
        throw scene::UserError(scene::Place{run.folder.string()}, "is no folder; a submission is a folder");
    GradeResult result = grade_submission(read_rubric(run.rubric), fs::absolute(run.folder), run.options);
    write_results(run, result);
    return result;
}

}  // namespace kreda::tools
