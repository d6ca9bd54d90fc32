// What a user did wrong, where, and what to do about it: one line on stderr, exit code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace kreda::scene {

/// A place in a file. line and column count from 1; 0 means unknown and is not printed.
struct Place {
    std::string file;
    int line = 0;
    int column = 0;
};

/// Thrown for anything a user can cause. what() is the whole line: "FILE:LINE:COL: message".
class UserError : public std::runtime_error {
public:
    UserError(const Place& place, const std::string& message);
    explicit UserError(const std::string& message) : std::runtime_error(message) {}
};

/// The candidate nearest to `word` by edit distance, or "" when none is near (for "did you mean ...?").
[[nodiscard]] std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace kreda::scene
