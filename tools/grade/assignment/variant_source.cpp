#include "tools/grade/assignment/variant_source.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>

namespace kreda::tools {

namespace {

bool is_prototype(const std::string& line) {
    return line.size() > 2 && line[0] != ' ' && line[0] != '/' && line.compare(line.size() - 2, 2, ");") == 0;
}

std::string last_word(const std::string& text) {
    const std::size_t end = text.find_last_not_of(' ') + 1;
    const std::size_t begin = text.find_last_of(" &*", end - 1) + 1;
    return text.substr(begin, end - begin);
}

/// Declarations and definitions that a formatter broke into several lines, each on one line again.
std::string unbroken(const std::string& text) {
    std::istringstream lines(text);
    std::string joined, line, next;
    while (std::getline(lines, line)) {
        const bool is_code = !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0;
        const auto is_open = [&] { return line.back() == ',' || line.back() == '('; };
        while (is_code && line.find('(') != std::string::npos && is_open() && std::getline(lines, next)) {
            line += " " + next.substr(std::min(next.find_first_not_of(' '), next.size()));
        }
        joined += line + "\n";
    }
    return joined;
}

/// Lines `#include <...>` go to `heads`, other directives and prototypes away; the rest comes back.
std::string body_of(const std::string& text, std::set<std::string>& heads, bool with_prototypes) {
    std::istringstream lines(unbroken(text));
    std::string body, line;
    while (std::getline(lines, line)) {
        if (line.rfind("#include <", 0) == 0) heads.insert(line);
        if (line.starts_with('#') || (!with_prototypes && is_prototype(line))) line.clear();
        body += line + "\n";
    }
    return body;
}

/// Each prototype's function has versions, each in a namespace of its own; a variant is a choice among them.
struct Versions {
    const std::vector<Prototype>& prototypes;
    std::map<std::string, std::size_t> helpers;                 ///< text -> number
    std::vector<std::map<std::string, std::size_t>> functions;  ///< one a prototype: text -> number
    std::vector<std::vector<std::size_t>> choices;              ///< one a variant: the version of each function
    std::string text;                                           ///< the namespaces

    explicit Versions(const std::vector<Prototype>& all) : prototypes(all), functions(all.size()) {}
    void add_variant(const SolutionParts& parts);

private:
    std::string add_helpers(const SolutionParts& parts);
};

/// The namespace of what stands around the functions. A solution that was not split stands there whole.
std::string Versions::add_helpers(const SolutionParts& parts) {
    const bool is_whole = parts.functions.empty();
    const auto [found, is_new] = helpers.emplace(parts.helpers, helpers.size());
    std::string name = "helpers_" + std::to_string(found->second);
    if (!is_new) return name;
    text += "namespace " + name + " {\n";
    for (const Prototype& p : prototypes) {
        text += is_whole ? p.declaration + ";\n" : "using dispatch::" + p.name + ";\n";
    }
    text += parts.helpers + "}\n";
    return name;
}

void Versions::add_variant(const SolutionParts& parts) {
    const std::string around = add_helpers(parts);
    std::vector<std::size_t> choice;
    for (std::size_t f = 0; f < prototypes.size(); ++f) {
        const Prototype& p = prototypes[f];
        const std::string body = parts.functions.empty() ? p.declaration + " {\n    return " + around + "::" + p.name +
                                                               "(" + p.arguments + ");\n}\n"
                                                         : "using namespace " + around + ";\n" + parts.functions[f];
        const auto [found, is_new] = functions[f].emplace(body, functions[f].size());
        choice.push_back(found->second);
        if (is_new) text += "namespace " + p.name + "_" + std::to_string(found->second) + " {\n" + body + "}\n";
    }
    choices.push_back(choice);
}

/// A function that hands the call to the version of the variant whose turn it is, and notes that it was called.
std::string dispatcher(const Prototype& p, std::size_t function, std::size_t versions) {
    const std::string number = std::to_string(function);
    std::string list;
    for (std::size_t k = 0; k < versions; ++k) list += p.name + "_" + std::to_string(k) + "::" + p.name + ",";
    return p.declaration + " {\n    static constexpr decltype(&" + p.name + "_0::" + p.name + ") kVersions[] = {" +
           list + "};\n    called[" + number + "] = true;\n    return kVersions[kChoice[current][" + number + "]](" +
           p.arguments + ");\n}\n";
}

std::string choice_table(const std::vector<std::vector<std::size_t>>& choices, std::size_t functions) {
    std::string text = "constexpr std::size_t kVariants = " + std::to_string(choices.size()) +
                       ", kFunctions = " + std::to_string(functions) +
                       ";\nconstexpr unsigned short kChoice[kVariants][kFunctions] = {\n";
    for (const std::vector<std::size_t>& choice : choices) {
        text += "{";
        for (const std::size_t version : choice) text += std::to_string(version) + ",";
        text += "},\n";
    }
    return text + "};\n";
}

const char* const kMain = R"(
/// What one variant did on a table: which functions it called, and the number of its answer.
struct Run {
    std::size_t variant, answer;
    std::array<bool, kFunctions> called;
};
bool does_the_same(const Run& run, std::size_t variant) {
    for (std::size_t f = 0; f < kFunctions; ++f)
        if (run.called[f] && kChoice[variant][f] != kChoice[run.variant][f]) return false;
    return true;
}
using Answer = std::vector<harness::Column>;
bool same_bits(const Answer& a, const Answer& b) {
    for (std::size_t c = 0; c < a.size() && a.size() == b.size(); ++c) {
        const std::vector<double>& x = a[c].values, & y = b[c].values;
        if (x.size() != y.size() || std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) != 0) return false;
    }
    return a.size() == b.size();
}
struct TableRuns {
    harness::Table& table;
    std::vector<Run> runs;
    std::vector<Answer> answers;
    std::size_t answer_of(std::size_t variant) {
        for (const Run& run : runs)
            if (does_the_same(run, variant)) return run.answer;
        table.outputs.clear();
        dispatch::current = variant;
        dispatch::called = {};
        for (std::size_t i = 0; i < table.rows; ++i) dispatch::run_row(harness::Row{table, i});
        std::size_t answer = 0;
        while (answer < answers.size() && !same_bits(table.outputs, answers[answer])) ++answer;
        if (answer == answers.size()) answers.push_back(std::move(table.outputs));
        runs.push_back({variant, answer, dispatch::called});
        return answer;
    }
};
int run_with_numbers(int argc, char** argv) {
    std::ofstream bytes(argv[2] + std::string("/answers.bin"), std::ios::binary);
    for (harness::Table& table : harness::read_tables(argv[1])) {
        for (int k = 4; k + 1 < argc; k += 2) {
            table.outputs.clear();
            dispatch::current = std::stoul(argv[k]);
            free_number = std::stof(argv[k + 1]);
            for (std::size_t i = 0; i < table.rows; ++i) dispatch::run_row(harness::Row{table, i});
            harness::write_table(bytes, table);
        }
    }
    return bytes.flush() ? 0 : 1;
}
int main(int argc, char** argv) {
    if (argc > 4) return run_with_numbers(argc, argv);
    const std::string folder = argv[2];
    const std::size_t count = std::stoul(argv[3]);
    std::ofstream bytes(folder + "/answers.bin", std::ios::binary), index(folder + "/index.txt");
    for (harness::Table& inputs : harness::read_tables(argv[1])) {
        TableRuns table{inputs, {}, {}};
        std::string numbers;
        for (std::size_t k = 0; k < count; ++k) numbers += ' ' + std::to_string(table.answer_of(k));
        index << table.answers.size() << numbers << '\n';
        for (Answer& answer : table.answers) {
            inputs.outputs = std::move(answer);
            harness::write_table(bytes, inputs);
        }
    }
    return bytes.flush() && index.flush() ? 0 : 1;
}
)";

/// Does a line begin the definition of this function?
bool begins(const std::string& line, const Prototype& p) {
    const std::size_t open = line.find('(');
    const bool is_code = !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0;
    return is_code && open != std::string::npos && line.find('{') != std::string::npos &&
           last_word(line.substr(0, open)) == p.name;
}

}  // namespace

std::vector<Prototype> prototypes_of(const std::string& header) {
    std::vector<Prototype> found;
    std::istringstream lines(unbroken(header));
    std::string line;
    while (std::getline(lines, line)) {
        if (!is_prototype(line)) continue;
        const std::size_t open = line.find('('), close = line.rfind(')');
        Prototype p{line.substr(0, close + 1), last_word(line.substr(0, open)), ""};
        std::istringstream parameters(line.substr(open + 1, close - open - 1));
        std::string parameter;
        while (std::getline(parameters, parameter, ',')) {
            p.arguments += (p.arguments.empty() ? "" : ", ") + last_word(parameter);
        }
        found.push_back(p);
    }
    return found;
}

SolutionParts split_solution(const std::string& solution, const std::vector<Prototype>& prototypes) {
    SolutionParts parts{"", std::vector<std::string>(prototypes.size())};
    std::istringstream lines(solution);
    std::string line;
    std::string* function = nullptr;
    while (std::getline(lines, line)) {
        for (std::size_t f = 0; function == nullptr && f < prototypes.size(); ++f) {
            if (!begins(line, prototypes[f])) continue;
            function = &parts.functions[f];
            if (!function->empty()) return {solution, {}};
        }
        (function != nullptr ? *function : parts.helpers) += line + "\n";
        if (!line.empty() && line[0] != ' ' && line.back() == '}') function = nullptr;
    }
    for (const std::string& text : parts.functions) {
        if (text.empty()) return {solution, {}};
    }
    return parts;
}

std::string variant_source(const std::string& assignment_header, const std::string& stages,
                           const std::vector<std::string>& solutions) {
    const std::vector<Prototype> prototypes = prototypes_of(assignment_header);
    std::set<std::string> heads = {"#include <array>", "#include <cstring>"};
    const std::string types = body_of(assignment_header, heads, false);
    const std::string stage_body = body_of(stages, heads, true);
    Versions versions(prototypes);
    for (const std::string& solution : solutions) {
        versions.add_variant(split_solution(body_of(solution, heads, true), prototypes));
    }
    std::string declarations, dispatchers, includes;
    for (std::size_t f = 0; f < prototypes.size(); ++f) {
        declarations += prototypes[f].declaration + ";\n";
        dispatchers += dispatcher(prototypes[f], f, versions.functions[f].size());
    }
    for (const std::string& head : heads) includes += head + "\n";
    return includes + "#include \"harness.hpp\"\n" + types + "float " + kFreeNumber +
           " = 0.0f;\nnamespace dispatch {\n" + declarations + "}\n" + versions.text +
           choice_table(versions.choices, prototypes.size()) +
           "namespace dispatch {\nstd::size_t current = 0;\nstd::array<bool, kFunctions> called{};\n" + dispatchers +
           stage_body + "}\n" + kMain;
}

}  // namespace kreda::tools
