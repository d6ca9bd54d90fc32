// Runs the built program as a user would, in a folder of its own, and catches what it says.
#pragma once

#include <string>
#include <vector>

namespace kreda::tests {

struct Outcome {
    int exit_code = -1;  ///< 128 + signal when a signal ended it
    std::string out;
    std::string err;
};

/// Start `kreda args...` with `folder` as its current folder and wait for its end.
[[nodiscard]] Outcome run_kreda(const std::vector<std::string>& args, const std::string& folder);

/// The same with another program, or a copy of kreda elsewhere.
[[nodiscard]] Outcome run_program(const std::string& program, const std::vector<std::string>& args,
                                  const std::string& folder);

/// Number of lines; a last one without '\n' counts.
[[nodiscard]] int line_count(const std::string& text);

/// Names of everything in a folder, hidden files too, sorted.
[[nodiscard]] std::vector<std::string> names_in(const std::string& folder);

}  // namespace kreda::tests
