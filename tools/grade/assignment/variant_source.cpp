#include "tools/grade/assignment/variant_source.hpp"

#include <algorithm>
#include <cctype>
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
        if (line.rfind("#", 0) == 0 || (!with_prototypes && is_prototype(line))) line.clear();
        body += line + "\n";
    }
    return body;
}

/// A function that hands the call to the variant whose turn it is.
std::string dispatcher(const Prototype& p, std::size_t variants) {
    std::string list;
    for (std::size_t k = 0; k < variants; ++k) list += "variant_" + std::to_string(k) + "::" + p.name + ",";
    return p.declaration + " {\n    static constexpr decltype(&variant_0::" + p.name + ") kOf[] = {" + list +
           "};\n    return kOf[current](" + p.arguments + ");\n}\n";
}

const char* const kMain =
    "int main(int, char** argv) {\n"
    "    const std::vector<harness::Table> tables = harness::read_tables(argv[1]);\n"
    "    for (dispatch::current = 0; dispatch::current < kVariants; ++dispatch::current)\n"
    "        harness::run_tables(tables, dispatch::run_row,\n"
    "                            std::string(argv[2]) + '/' + std::to_string(dispatch::current), \"\");\n"
    "}\n";

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

std::string variant_source(const std::string& assignment_header, const std::string& stages,
                           const std::vector<std::string>& solutions) {
    const std::vector<Prototype> prototypes = prototypes_of(assignment_header);
    std::string declarations, dispatchers, variants;
    for (const Prototype& p : prototypes) {
        declarations += p.declaration + ";\n";
        dispatchers += dispatcher(p, solutions.size());
    }
    std::set<std::string> heads;
    const std::string types = body_of(assignment_header, heads, false);
    const std::string stage_body = body_of(stages, heads, true);
    for (std::size_t k = 0; k < solutions.size(); ++k) {
        variants += "namespace variant_" + std::to_string(k) + " {\n" + declarations +
                    body_of(solutions[k], heads, true) + "}\n";
    }
    std::string text;
    for (const std::string& head : heads) text += head + "\n";
    return text + "#include \"harness.hpp\"\n" + types + variants +
           "constexpr std::size_t kVariants = " + std::to_string(solutions.size()) +
           ";\nnamespace dispatch {\nstd::size_t current = 0;\n" + declarations + dispatchers + stage_body + "}\n" +
           kMain;
}

}  // namespace kreda::tools
