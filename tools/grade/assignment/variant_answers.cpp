#include "tools/grade/assignment/variant_answers.hpp"

#include <cstdio>
#include <sstream>

#include "tools/grade/assignment/build_program.hpp"
#include "tools/grade/assignment/grade_cache.hpp"
#include "tools/grade/assignment/table_reader.hpp"
#include "tools/grade/assignment/variant_source.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

std::string source_of(const Rubric& rubric, const std::vector<Variant>& variants) {
    const GivenFiles files = given_files(rubric);
    std::vector<std::string> solutions;
    for (const Variant& variant : variants) solutions.push_back(variant.text);
    return variant_source(read_text(files.assignment.string()), read_text(files.stages.string()), solutions);
}

/// index.txt and answers.bin, as variant_source.hpp says.
VariantAnswers read_answers(const fs::path& folder, const CaseSet& cases, std::size_t variants) {
    VariantAnswers answers{{}, std::vector<std::vector<std::size_t>>(variants)};
    std::istringstream index(read_text((folder / "index.txt").string()));
    std::vector<StageTable> shapes;
    std::vector<std::size_t> counts;
    for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
        std::size_t number = 0;
        index >> counts.emplace_back();
        shapes.insert(shapes.end(), counts[i], cases.expected[i]);
        for (std::size_t k = 0; k < variants && index >> number; ++k) answers.number[k].push_back(number);
    }
    DecodedTables decoded = decode_tables(read_text((folder / "answers.bin").string()), shapes);
    if (!decoded.complaint.empty()) throw scene::UserError("a variant of the solution gave " + decoded.complaint);
    auto next = decoded.tables.begin();
    for (const std::size_t count : counts) {
        answers.tables.emplace_back();
        for (std::size_t k = 0; k < count; ++k) {
            answers.tables.back().push_back(std::make_shared<const StageTable>(std::move(*next++)));
        }
    }
    return answers;
}

}  // namespace

std::vector<StageTable> VariantAnswers::all_of(std::size_t variant) const {
    std::vector<StageTable> all;
    for (std::size_t i = 0; i < tables.size(); ++i) all.push_back(of(variant, i));
    return all;
}

fs::path program_of_variants(const Rubric& rubric, const std::vector<Variant>& variants) {
    const fs::path harness = given_files(rubric).harness;
    const std::string source = source_of(rubric, variants);
    const std::string name = "variants-" + content_name(read_text(harness.string()) + source);
    const fs::path built = cached_folder(name, [&](const fs::path& folder) {
        write_file((folder / "variants.cpp").string(), source);
        run_trusted({"/usr/bin/g++", "-std=c++20", "-DGLM_FORCE_XYZW_ONLY", "-O1", "-w", "-ffp-contract=off", "-I",
                     harness.parent_path().string(), (folder / "variants.cpp").string(), "-o",
                     (folder / "program").string()});
    });
    return built / "program";
}

VariantAnswers answers_of_program(const fs::path& program, const CaseSet& cases, std::size_t count) {
    const std::string inputs = encode_tables(cases.inputs), run = std::to_string(count);
    const std::string of_program = program.parent_path().filename().string();  // stands for all that it was made of
    const std::string name = "answers-" + of_program + "-" + content_name(inputs + run);
    const fs::path answered = cached_folder(name, [&](const fs::path& folder) {
        write_file((folder / "inputs.bin").string(), inputs);
        run_trusted({program.string(), (folder / "inputs.bin").string(), folder.string(), run});
        fs::remove(folder / "inputs.bin");
    });
    return read_answers(answered, cases, count);
}

std::vector<std::vector<StageTable>> answers_with_numbers(const fs::path& program,
                                                          const std::vector<StageTable>& inputs,
                                                          const std::vector<StageTable>& expected,
                                                          const std::vector<NumberedRun>& runs) {
    const BoxFolder folder;  // a folder of its own, removed at the end
    const fs::path input_file = folder.path() / "inputs.bin";
    write_file(input_file.string(), encode_tables(inputs));
    std::vector<std::string> command{program.string(), input_file.string(), folder.path().string(), "0"};
    for (const NumberedRun& run : runs) {
        command.push_back(std::to_string(run.variant));
        char number[32];
        std::snprintf(number, sizeof number, "%.9g", run.number);
        command.push_back(number);
    }
    run_trusted(command);
    std::vector<StageTable> shapes;
    for (const StageTable& table : expected) shapes.insert(shapes.end(), runs.size(), table);
    DecodedTables decoded = decode_tables(read_text((folder.path() / "answers.bin").string()), shapes);
    if (!decoded.complaint.empty()) throw scene::UserError("a variant of the solution gave " + decoded.complaint);
    std::vector<std::vector<StageTable>> answers(runs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        for (std::size_t k = 0; k < runs.size(); ++k) {
            answers[k].push_back(std::move(decoded.tables[i * runs.size() + k]));
        }
    }
    return answers;
}

}  // namespace kreda::tools
