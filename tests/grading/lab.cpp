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

const Lab& lab(const std::string& folder, bool with_pairs) {
    static std::map<std::pair<std::string, bool>, Lab> labs;
    const auto found = labs.find({folder, with_pairs});
    if (found != labs.end()) return found->second;
    Lab made{tools::read_rubric(kFolder / folder / "rubric.toml"), {}, {}, {}};
    made.cases = tools::make_cases(made.rubric, {});
    made.catalogue = tools::make_catalogue(made.rubric, made.cases, with_pairs);
    for (std::size_t i = 0; i < made.cases.inputs.size(); ++i) {
        const tools::RubricStage& stage = *made.rubric.find_stage(made.cases.inputs[i].stage);
        std::vector<tools::StageCheck>& checks = made.checks.emplace_back();
        for (const auto& answers : made.catalogue.answers.tables[i]) {
            checks.push_back(tools::check_stage(stage, made.cases.inputs[i], made.cases.expected[i], *answers));
        }
    }
    return labs.emplace(std::pair(folder, with_pairs), std::move(made)).first->second;
}

tools::Marking marking(const Lab& lab, const std::vector<tools::StageTable>& tables) {
    tools::Marking m{lab.rubric, lab.cases, {}, std::vector<std::string>(tables.size()), {}};
    for (std::size_t i = 0; i < tables.size(); ++i) {
        m.answers.push_back(&tables[i]);
        m.checks.push_back(tools::check_stage(m.stage(i), lab.cases.inputs[i], lab.cases.expected[i], tables[i]));
    }
    return m;
}

tools::Marking marking(const Lab& lab, std::size_t variant) {
    const std::size_t count = lab.cases.inputs.size();
    tools::Marking m{lab.rubric, lab.cases, {}, std::vector<std::string>(count), {}};
    for (std::size_t i = 0; i < count; ++i) {
        m.answers.push_back(&lab.catalogue.answers.of(variant, i));
        m.checks.push_back(lab.checks[i][lab.catalogue.answers.number[variant][i]]);
    }
    return m;
}

std::string names(const Lab& lab, const std::vector<std::size_t>& mistakes) {
    std::string text;
    for (const std::size_t m : mistakes) text += (text.empty() ? "" : ", ") + lab.catalogue.mistakes[m].name;
    return text;
}

}  // namespace kreda::tests
