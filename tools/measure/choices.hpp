// The registry of choices: every term of a picture that can be computed in more than one way, and which way is the
// truth. It holds no formula and no list of names of its own: the names are the words of the scene file's keys
// (scene/files/keys_of_*.cpp), which are those of the tables beside the formulas' switches.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kreda::tools {

/// One term. Its key is `table.key` of the scene file.
struct Choice {
    std::string_view name;  ///< in a sentence: "Fresnel"
    std::string_view table, key;
    std::vector<std::string> values;  ///< as a scene file writes them, without quotes: the key's words in their order,
                                      ///< or a ladder of numbers from cheap to dear
    std::string oracle;  ///< the one that the others are measured against; empty: the scene's own, which is a model
                         ///< that somebody chose and no approximation of another
    std::string_view why_oracle;
    std::string_view valid;  ///< where it can be chosen, in words
};

/// All terms, in the order of the tables of a scene file.
[[nodiscard]] const std::vector<Choice>& choices();

/// The term of a key, or nullptr.
[[nodiscard]] const Choice* find_choice(std::string_view table, std::string_view key);

/// "material.fresnel"
[[nodiscard]] std::string key_of(const Choice& choice);

/// The terms as text for people, a paragraph each.
[[nodiscard]] std::string describe_choices();

}  // namespace kreda::tools
