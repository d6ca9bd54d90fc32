// Questions about one submission, each with one answer that was computed: for a talk with whoever handed it in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/grade/assignment/build_program.hpp"
#include "tools/grade/assignment/score.hpp"

namespace kreda::tools {

struct VivaQuestion {
    std::string question;
    std::string answer;
    std::string how;  ///< where the answer comes from, for the teacher
};

/// `count` questions about the submission's own numbers, pictures and code; the same submission gives the same ones.
/// Fewer where it does not answer enough. Three kinds take turns: what one of its functions gives at a pixel; which of
/// the lights gives more there; and what becomes of the results if one sign of its own code is changed, for which the
/// changed code is compiled and run in the box.
[[nodiscard]] std::vector<VivaQuestion> make_viva(const Rubric& rubric, const CaseSet& cases,
                                                  const std::filesystem::path& submission, const Answers& answers,
                                                  int count, const GradeOptions& options);

/// The sheet without the answers, and the key, as Markdown.
[[nodiscard]] std::string viva_sheet(const std::string& title, const std::vector<VivaQuestion>& questions);
[[nodiscard]] std::string viva_key(const std::string& title, const std::vector<VivaQuestion>& questions);

/// One operator of a line of code, changed.
struct ChangedLine {
    int line = 0;      ///< from 1
    std::string text;  ///< as it was, trimmed
    std::string from, to;
    std::string source;  ///< the whole file with the change
};
/// All single changes of + - * / < > that stand between blanks, outside of comments and directives.
[[nodiscard]] std::vector<ChangedLine> changed_lines(const std::string& source);

}  // namespace kreda::tools
