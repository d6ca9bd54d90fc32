// rubric.toml: what an assignment tests, for how many points, within which limits.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/compare/compare.hpp"
#include "tools/grade/box.hpp"

namespace kreda::tools {

/// One function of the student's: what it computes, as the lecture writes it.
struct RubricStage {
    std::string name;                ///< the function's, as in student.cpp
    std::string formula;             ///< "r = 2 (n.l) n - l"
    std::string page;                ///< of docs/, without ".md": "22_phong_terms"
    int equation = 0;                ///< its number on that page; 0: it has none
    double absolute = 2e-5;          ///< a number may be off by this ...
    double relative = 2e-4;          ///< ... and by this share of the largest of the expected numbers
    std::vector<std::string> calls;  ///< functions that must be right, too; none: of a picture all those before it
    bool picture = false;  ///< its rows are a picture's pixels; its first result, 1 or 3 numbers, is their colour
    bool encoded = false;  ///< the colour is what the picture holds, not linear light
};

struct RubricTest {
    std::string name;     ///< unique
    std::string teaches;  ///< a line
    std::string stage;    ///< which function
    std::string scene;    ///< a picture's; empty: all scenes
    double points = 1.0;
    bool hidden = false;     ///< on the hidden scenes; left out where there are none
    std::string work;        ///< a column of counts instead: its sum is what is tested
    double most_work = 1.0;  ///< times what Kreda needs
};

struct Rubric {
    std::filesystem::path file;  ///< rubric.toml; its folder is the assignment's
    std::string assignment;      ///< "A3"
    std::string title;           ///< "Lights and Phong's model"
    std::string deadline;        ///< shown as it stands
    std::string student_file = "student.cpp";
    std::vector<std::filesystem::path> scenes;
    std::vector<RubricStage> stages;  ///< in the order of the pipeline: the first wrong one is named
    std::vector<RubricTest> tests;
    CompareLimits picture;
    BoxLimits compile, run;

    [[nodiscard]] std::filesystem::path folder() const {
        return file.parent_path();
    }
    [[nodiscard]] const RubricStage* find_stage(const std::string& name) const;
};

/// Read and check. Throws UserError with file, line and column.
[[nodiscard]] Rubric read_rubric(const std::filesystem::path& file);

}  // namespace kreda::tools
