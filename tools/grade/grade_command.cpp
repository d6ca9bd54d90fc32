// kreda grade: a submission, or a class of them, against an assignment.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "scene/files/toml_tree.hpp"
#include "tools/commands.hpp"
#include "tools/grade/grade_run.hpp"
#include "tools/grade/plain_text.hpp"

namespace kreda::tools {

namespace {

using scene::UserError;

constexpr const char* kFooter = R"(
The submission is compiled and run in a box: bubblewrap, or Landlock with seccomp and, for root, a user of its own; with
neither it is refused. Which one is in every result. Reports (report.html for the teacher, student.html without what the
hidden tests show) and the formats asked for go to OUT; result.json is written last.
Exit code 0: graded, with whatever points; 2: it could not be graded, in one line.

Formats: gradescope   OUT/gradescope/results.json        prairielearn  OUT/prairielearn/results.json
         classroom    OUT/classroom.txt (base 64)        vpl           OUT/vpl.txt
         junit        OUT/junit.xml

Examples:
  kreda grade anna --rubric A3/rubric.toml -o graded/anna
  kreda grade anna --rubric A3/rubric.toml --hidden hidden/A3 -o out --formats gradescope
  kreda grade --class submissions --rubric A3/rubric.toml --hidden hidden/A3 -o graded     again: goes on where it ended)";

struct CommandOptions {
    std::string folder, class_folder, rubric, out = "graded", formats = "all", box;
    std::vector<std::string> hidden;
    bool unsafe = false, resume = false;
    int jobs = 0;
    int viva = 0;
};

std::vector<std::string> formats_named(const std::string& words) {
    if (words == "all") return grade_formats();
    if (words == "none") return {};
    std::vector<std::string> formats;
    std::istringstream stream(words);
    for (std::string word; std::getline(stream, word, ',');) {
        const std::vector<std::string>& known = grade_formats();
        if (std::find(known.begin(), known.end(), word) == known.end())
            throw UserError("--formats " + words + ": there is no format '" + word + "'" +
                            scene::did_you_mean(word, known, "formats"));
        formats.push_back(word);
    }
    return formats;
}

GradeRun run_of(const CommandOptions& options) {
    if (options.folder.empty() == options.class_folder.empty())
        throw UserError("kreda grade: name a submission's folder, or --class and the folder of all of them");
    GradeRun run;
    run.folder = options.folder.empty() ? options.class_folder : options.folder;
    run.rubric = options.rubric;
    run.out = options.out;
    run.formats = formats_named(options.formats);
    run.options.hidden.assign(options.hidden.begin(), options.hidden.end());
    run.options.allow_unsafe = options.unsafe;
    for (const BoxTier tier : {BoxTier::bubblewrap, BoxTier::landlock, BoxTier::unsafe}) {
        if (name_of(tier) == options.box) run.options.tier = tier;
    }
    run.jobs = options.jobs;
    run.options.viva = options.viva;
    return run;
}

void print(const GradeResult& result, const GradeRun& run) {
    std::cout << result.assignment << ": " << points_text(result.points) << " of " << points_text(result.max_points)
              << " points (box: " << box_of(result) << ")\n";
    if (!result.error.empty()) std::cout << plain_text(result.error) << "\n";
    for (const TestResult& test : result.tests) {
        std::cout << (test.passed ? "  passed  " : "  FAILED  ") << std::left << std::setw(30) << plain_text(test.name)
                  << " " << points_text(test.points) << " / " << points_text(test.max_points);
        if (!test.passed) std::cout << "  " << plain_text(first_line(test.message));
        std::cout << "\n";
    }
    if (!result.diagnosis.empty()) std::cout << plain_text(result.diagnosis) << "\n";
    std::cerr << "see " << (run.out / "report.html").string() << "\n";
}

void grade_command(const CommandOptions& options) {
    const GradeRun run = run_of(options);
    if (!options.folder.empty()) {
        const std::optional<GradeResult> before = options.resume ? result_of_before(run) : std::nullopt;
        print(before ? *before : grade_one(run), run);
        return;
    }
    const ClassSummary summary = grade_class(run);
    std::cout << summary.submissions << " submissions: " << summary.graded << " graded now, "
              << summary.submissions - summary.graded - summary.failed << " before";
    if (summary.failed > 0)
        std::cout << ", " << summary.failed << " without a result (see grader.txt in their folders; run again)";
    std::cout << "\n";
    std::cerr << "wrote " << (run.out / "index.html").string() << " and results.csv\n";
    if (summary.failed > 0) throw UserError("kreda grade: some submissions could not be graded");
}

}  // namespace

void add_grade_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("grade", "Grade a student's work, or a class's, against an assignment");
    command->footer(kFooter);
    const auto options = std::make_shared<CommandOptions>();
    command->add_option("DIR", options->folder, "The submission's folder");
    command->add_option("--class", options->class_folder, "A folder with a folder for each submission")
        ->type_name("DIR");
    command->add_option("--rubric", options->rubric, "rubric.toml of the assignment")->type_name("FILE")->required();
    command->add_option("--hidden", options->hidden, "A folder of hidden scenes; several may be named")
        ->type_name("DIR")
        ->take_all();
    command->add_option("-o,--output", options->out, "Where reports and results go")
        ->type_name("OUT")
        ->capture_default_str();
    command->add_option("--formats", options->formats, "all, none, or names with commas; see below")
        ->capture_default_str();
    command->add_option("--box", options->box, "Use this box or none; otherwise the strongest that works here")
        ->check(CLI::IsMember({"bubblewrap", "landlock"}));
    command->add_flag("--unsafe", options->unsafe, "Where there is no box, run with limits alone");
    command->add_flag("--resume", options->resume,
                      "Keep a result in OUT that is of these very files (--class always does)");
    command->add_option("--jobs", options->jobs, "With --class: submissions at a time; default: one a core")
        ->check(CLI::Range(1, 1024));
    command
        ->add_option("--viva", options->viva,
                     "Also N questions about this very submission: viva.md, and the answers in viva_key.md")
        ->type_name("N")
        ->check(CLI::Range(1, 50));
    command->callback([options] { grade_command(*options); });
}

}  // namespace kreda::tools
