#include "tools/grade/assignment/mistakes.hpp"

#include <unistd.h>

#include "tools/grade/assignment/build_program.hpp"
#include "tools/grade/assignment/table_reader.hpp"
#include "tools/grade/assignment/variant_source.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

std::vector<TextChange> read_way(TableReader& reader) {
    std::vector<std::string> from, to;
    reader.require("from");
    reader.require("to");
    reader.read("from", from);
    reader.read("to", to);
    if (from.size() != to.size()) reader.complain("to", "expected as many texts as in 'from'");
    std::vector<TextChange> changes;
    for (std::size_t i = 0; i < from.size(); ++i) changes.emplace_back(from[i], to[i]);
    return changes;
}

void check_fits(const std::vector<TextChange>& changes, const std::string& solution, const TableReader& reader) {
    for (const TextChange& change : changes) {
        const std::size_t at = solution.find(change.first);
        const bool once = at != std::string::npos && solution.find(change.first, at + 1) == std::string::npos;
        if (!once) reader.complain("from", "this text must stand in the solution exactly once: " + change.first);
    }
}

Mistake read_mistake(const scene::Value& table, const std::string& solution) {
    TableReader reader(table, "[[mistake]]");
    Mistake mistake;
    for (const char* key : {"name", "says", "page"}) reader.require(key);
    reader.read("name", mistake.name);
    reader.read("says", mistake.says);
    reader.read("page", mistake.page);
    mistake.ways.push_back(read_way(reader));
    check_fits(mistake.ways.back(), solution, reader);
    for (const scene::Value* other : reader.tables("also")) {
        TableReader way(*other, "[[mistake.also]]");
        mistake.ways.push_back(read_way(way));
        check_fits(mistake.ways.back(), solution, way);
        way.done();
    }
    reader.done();
    return mistake;
}

std::string source_of(const Rubric& rubric, const std::vector<Variant>& variants) {
    const GivenFiles files = given_files(rubric);
    std::vector<std::string> solutions;
    for (const Variant& variant : variants) solutions.push_back(variant.text);
    return variant_source(read_text(files.assignment.string()), read_text(files.stages.string()), solutions);
}

/// Make a folder under another name, then rename it: another grader may be at the same work.
template <class Fill>
void make_folder_once(const fs::path& folder, const Fill& fill) {
    if (fs::exists(folder)) return;
    const fs::path unfinished = folder.string() + "." + std::to_string(getpid());
    fs::create_directories(unfinished);
    fill(unfinished);
    std::error_code error;
    fs::rename(unfinished, folder, error);
    if (error) fs::remove_all(unfinished);  // somebody else was first
}

}  // namespace

std::string read_solution(const Rubric& rubric) {
    return read_text((rubric.folder() / "teacher" / "solution.cpp").string());
}

std::vector<Mistake> read_mistakes(const Rubric& rubric, const fs::path& file) {
    const std::string solution = read_solution(rubric);
    const scene::Value root = scene::parse_toml(read_text(file.string()), file.string());
    TableReader reader(root, "the catalogue");
    std::vector<Mistake> mistakes;
    for (const scene::Value* table : reader.tables("mistake")) mistakes.push_back(read_mistake(*table, solution));
    reader.done();
    return mistakes;
}

std::vector<Mistake> read_mistakes(const Rubric& rubric) {
    return read_mistakes(rubric, rubric.folder() / "teacher" / "mistakes.toml");
}

bool apply(const std::vector<TextChange>& changes, std::string& text) {
    for (const TextChange& change : changes) {
        const std::size_t at = text.find(change.first);
        if (at == std::string::npos || text.find(change.first, at + 1) != std::string::npos) return false;
        text.replace(at, change.first.size(), change.second);
    }
    return true;
}

std::vector<Variant> make_variants(const std::string& solution, const std::vector<Mistake>& mistakes, bool with_pairs) {
    std::vector<Variant> variants{{{}, solution}};
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        for (const std::vector<TextChange>& way : mistakes[i].ways) {
            Variant variant{{i}, solution};
            if (apply(way, variant.text)) variants.push_back(variant);
        }
    }
    for (std::size_t i = 0; with_pairs && i < mistakes.size(); ++i) {
        for (std::size_t j = i + 1; j < mistakes.size(); ++j) {
            Variant variant{{i, j}, solution};
            if (!apply(mistakes[i].ways[0], variant.text)) continue;
            if (apply(mistakes[j].ways[0], variant.text)) variants.push_back(variant);
        }
    }
    return variants;
}

std::vector<std::vector<StageTable>> answers_of_variants(const Rubric& rubric, const CaseSet& cases,
                                                         const std::vector<Variant>& variants) {
    const GivenFiles files = given_files(rubric);
    const std::string source = source_of(rubric, variants);
    const std::string name = content_name(read_text(files.harness.string()) + source);
    const fs::path built = grade_cache(rubric) / ("variants-" + name);
    make_folder_once(built, [&](const fs::path& folder) {
        write_file((folder / "variants.cpp").string(), source);
        run_trusted({"/usr/bin/g++", "-std=c++20", "-DGLM_FORCE_XYZW_ONLY", "-O1", "-w", "-ffp-contract=off", "-I",
                     files.harness.parent_path().string(), (folder / "variants.cpp").string(), "-o",
                     (folder / "program").string()});
    });
    const std::string inputs = encode_tables(cases.inputs);
    const fs::path answered = built / ("answers-" + content_name(inputs));
    make_folder_once(answered, [&](const fs::path& folder) {
        write_file((folder / "inputs.bin").string(), inputs);
        run_trusted({(built / "program").string(), (folder / "inputs.bin").string(), folder.string()});
        fs::remove(folder / "inputs.bin");
    });
    std::vector<std::vector<StageTable>> answers;
    for (std::size_t k = 0; k < variants.size(); ++k) {
        DecodedTables decoded = decode_tables(read_text((answered / std::to_string(k)).string()), cases.expected);
        if (!decoded.complaint.empty()) throw scene::UserError("a variant of the solution gave " + decoded.complaint);
        answers.push_back(std::move(decoded.tables));
    }
    return answers;
}

}  // namespace kreda::tools
