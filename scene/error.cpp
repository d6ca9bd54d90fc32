#include "scene/error.hpp"

#include <algorithm>

namespace kreda::scene {

namespace {

std::string with_place(const Place& place, const std::string& message) {
    std::string line = place.file;
    if (place.line > 0) line += ":" + std::to_string(place.line);
    if (place.line > 0 && place.column > 0) line += ":" + std::to_string(place.column);
    return line.empty() ? message : line + ": " + message;
}

/// Levenshtein's edit distance, one row at a time.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

UserError::UserError(const Place& place, const std::string& message) : std::runtime_error(with_place(place, message)) {}

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates) {
    std::string nearest;
    std::size_t least = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

}  // namespace kreda::scene
