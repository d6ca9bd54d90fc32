#include "tools/grade/assignment/build_program.hpp"

#include <cstdio>
#include <fstream>
#include <span>

#include "scene/files/hash_of_bytes.hpp"
#include "tools/grade/assignment/grade_cache.hpp"
#include "tools/grade/assignment/table_reader.hpp"
#include "tools/shell_quotes.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kLanguage = {"-std=c++20", "-DGLM_FORCE_XYZW_ONLY"};

/// The first lines of what a compiler says.
std::string first_lines(const std::string& text, int most) {
    std::size_t end = 0;
    for (int i = 0; i < most && end != std::string::npos; ++i) end = text.find('\n', end + (i > 0 ? 1 : 0));
    return end == std::string::npos ? text : text.substr(0, end) + "\n...";
}

void copy_in(const fs::path& from, const fs::path& to) {
    fs::copy_file(from, to, fs::copy_options::overwrite_existing);
    fs::permissions(to, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read |
                            fs::perms::owner_write | (fs::status(from).permissions() & fs::perms::owner_exec) |
                            ((fs::status(from).permissions() & fs::perms::owner_exec) != fs::perms::none
                                 ? fs::perms::others_exec | fs::perms::group_exec
                                 : fs::perms::none));
}

/// A folder inside the box's that the boxed program can read (and, as a work folder, write).
fs::path subfolder(const BoxFolder& box, const std::string& name) {
    fs::path folder = box.path() / name;
    fs::create_directories(folder);
    fs::permissions(folder, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                                fs::perms::others_read | fs::perms::others_exec);
    return folder;
}

/// The outputs that a program should write for these tables.
std::vector<StageTable> expected_for(const CaseSet& cases, const std::vector<std::size_t>& wanted) {
    std::vector<StageTable> expected;
    for (const std::size_t i : wanted) expected.push_back(cases.expected[i]);
    return expected;
}

/// One run of the program on some tables (all of one stage if `stage` is not empty). Fills the answers that came.
void run_once(const Rubric& rubric, const Program& program, const CaseSet& cases, const std::string& stage,
              const std::vector<std::size_t>& wanted, const GradeOptions& options, Answers& answers) {
    std::vector<StageTable> inputs;
    for (const std::size_t i : wanted) inputs.push_back(cases.inputs[i]);
    const fs::path work = program.folder / "work";
    fs::remove_all(work);
    fs::create_directories(work);
    const fs::path input_file = program.folder / "inputs.bin";
    write_file(input_file.string(), encode_tables(inputs));
    fs::permissions(input_file, fs::perms::others_read | fs::perms::group_read, fs::perm_options::add);
    BoxRequest request{{program.file.string(), input_file.string(), "outputs.bin"},
                       {program.file, input_file},
                       work,
                       rubric.run,
                       options.tier};
    if (!stage.empty()) request.command.push_back(stage);
    const BoxOutcome outcome = run_in_box(request, options.allow_unsafe);
    std::string why;
    if (outcome.end != BoxOutcome::End::exited || outcome.code != 0)
        why = "your program " + describe(outcome, rubric.run);
    const fs::path output = work / "outputs.bin";
    std::string bytes;
    std::error_code error;
    if (fs::symlink_status(output, error).type() == fs::file_type::regular &&
        fs::file_size(output, error) <= rubric.run.output_bytes) {
        bytes = read_text(output.string());
    }
    DecodedTables decoded = decode_tables(bytes, expected_for(cases, wanted));
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        if (k < decoded.tables.size()) {
            answers.tables[wanted[k]] = std::move(decoded.tables[k]);
        } else {
            answers.why[wanted[k]] = why.empty() ? decoded.complaint : why;
        }
    }
}

}  // namespace

GivenFiles given_files(const Rubric& rubric) {
    const fs::path folder = rubric.folder();
    GivenFiles files{folder.parent_path() / "harness.hpp", folder.parent_path() / "main.cpp", folder / "assignment.hpp",
                     folder / "stages.cpp"};
    for (const fs::path& file : {files.harness, files.main, files.assignment, files.stages}) {
        if (!fs::is_regular_file(file)) {
            throw scene::UserError(scene::Place{file.string()}, "is missing; an assignment's folder lies beside it");
        }
    }
    return files;
}

std::string content_name(const std::string& bytes) {
    char name[17];
    const std::uint64_t hash = scene::hash_of_bytes(std::as_bytes(std::span(bytes.data(), bytes.size())));
    std::snprintf(name, sizeof name, "%016llx", static_cast<unsigned long long>(hash));
    return name;
}

void run_trusted(const std::vector<std::string>& command) {
    std::string line;
    for (const std::string& word : command) line += in_shell_quotes(word) + " ";
    FILE* pipe = popen((line + "2>&1").c_str(), "r");
    if (pipe == nullptr) throw scene::UserError("cannot run " + command[0]);
    std::string printed;
    char buffer[4096];
    for (std::size_t n = 0; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) printed.append(buffer, n);
    if (pclose(pipe) != 0) throw scene::UserError(command[0] + " failed:\n" + first_lines(printed, 20));
}

GivenObjects given_objects(const Rubric& rubric) {
    const GivenFiles files = given_files(rubric);
    const std::string name = content_name(read_text(files.harness.string()) + read_text(files.main.string()) +
                                          read_text(files.assignment.string()) + read_text(files.stages.string()));
    const fs::path made = cached_folder("given-" + name, [&](const fs::path& folder) {
        const auto compile = [&](const fs::path& source, const std::string& object) {
            run_trusted({"/usr/bin/g++", kLanguage[0], kLanguage[1], "-O1", "-ffp-contract=off", "-I",
                         files.harness.parent_path().string(), "-I", rubric.folder().string(), "-c", source.string(),
                         "-o", (folder / object).string()});
        };
        compile(files.main, "main.o");
        compile(files.stages, "stages.o");
    });
    return {made / "main.o", made / "stages.o"};
}

Program compile_submission(const Rubric& rubric, const fs::path& submission, const BoxFolder& box,
                           const GradeOptions& options, const CompileOptions& compile) {
    Program program;
    program.folder = box.path();
    const fs::path source = submission / rubric.student_file;
    if (!fs::is_regular_file(fs::symlink_status(source))) {
        program.error = "there is no file " + rubric.student_file + " in the submission";
        return program;
    }
    const fs::path given = subfolder(box, "given");
    const GivenObjects objects = given_objects(rubric);
    copy_in(source, given / "student.cpp");
    copy_in(given_files(rubric).assignment, given / "assignment.hpp");
    copy_in(objects.main, given / "main.o");
    copy_in(objects.stages, given / "stages.o");
    const fs::path work = box.path() / "compile";
    fs::create_directories(work);
    BoxRequest request{{compile.compiler}, {given}, work, rubric.compile, options.tier};
    request.command.insert(request.command.end(), kLanguage.begin(), kLanguage.end());
    request.command.insert(request.command.end(), compile.flags.begin(), compile.flags.end());
    request.command.insert(request.command.end(),
                           {"-I", given.string(), (given / "student.cpp").string(), (given / "stages.o").string(),
                            (given / "main.o").string(), "-o", "program"});
    const BoxOutcome outcome = run_in_box(request, options.allow_unsafe);
    program.tier = outcome.tier;
    if (outcome.end != BoxOutcome::End::exited || outcome.code != 0) {
        program.error = rubric.student_file + " does not compile: the compiler " + describe(outcome, rubric.compile) +
                        "\n" + first_lines(outcome.err, 30);
        return program;
    }
    if (!fs::is_regular_file(fs::symlink_status(work / "program"))) {
        program.error = "the compiler left no program";
        return program;
    }
    program.file = given / "program";
    copy_in(work / "program", program.file);
    return program;
}

Answers run_submission(const Rubric& rubric, const Program& program, const CaseSet& cases,
                       const GradeOptions& options) {
    Answers answers{std::vector<StageTable>(cases.inputs.size()), std::vector<std::string>(cases.inputs.size())};
    for (const bool hidden : {false, true}) {
        std::vector<std::size_t> wanted;
        for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
            if (cases.scene(cases.inputs[i].scene).hidden == hidden) wanted.push_back(i);
        }
        if (wanted.empty()) continue;
        run_once(rubric, program, cases, "", wanted, options, answers);
        for (const RubricStage& stage : rubric.stages) {
            std::vector<std::size_t> left;
            for (const std::size_t i : wanted) {
                if (cases.inputs[i].stage == stage.name && !is_answered(answers.tables[i])) left.push_back(i);
            }
            if (!left.empty()) run_once(rubric, program, cases, stage.name, left, options, answers);
        }
    }
    return answers;
}

}  // namespace kreda::tools
