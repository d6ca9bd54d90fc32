#include "tests/grading/lab.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

namespace kreda::tests {

namespace {

namespace fs = std::filesystem;
const fs::path kFolder = fs::path(KREDA_SOURCE_DIR) / "examples" / "assignments";

}  // namespace

std::vector<std::string> assignment_folders() {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
        if (fs::exists(entry.path() / "rubric.toml")) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

const Lab& lab(const std::string& folder) {
    static std::map<std::string, Lab> labs;
    const auto found = labs.find(folder);
    if (found != labs.end()) return found->second;
    Lab made{tools::read_rubric(kFolder / folder / "rubric.toml"), {}, {}};
    made.cases = tools::make_cases(made.rubric, {});
    made.catalogue = tools::make_catalogue(made.rubric, made.cases);
    return labs.emplace(folder, std::move(made)).first->second;
}

tools::Answers all_answered(const std::vector<tools::StageTable>& tables) {
    return {tables, std::vector<std::string>(tables.size())};
}

double points(const Lab& lab, const std::vector<tools::StageTable>& tables) {
    return tools::points_of(tools::score(lab.rubric, lab.cases, all_answered(tables), false));
}

tools::Diagnosis diagnosis(const Lab& lab, const std::vector<tools::StageTable>& tables) {
    return tools::diagnose(lab.rubric, lab.cases, all_answered(tables), lab.catalogue);
}

std::string names(const Lab& lab, const std::vector<std::size_t>& mistakes) {
    std::string text;
    for (const std::size_t m : mistakes) text += (text.empty() ? "" : ", ") + lab.catalogue.mistakes[m].name;
    return text;
}

}  // namespace kreda::tests
