// The terms of one scene that can be computed in more than one way, from the registry of choices; and those that cannot
// matter here, with the proof.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "tools/tune/scene_source.hpp"

namespace kreda::tools {

/// One way.
struct TermOption {
    std::string name;  ///< "map of 1024 texels, slope"
    std::vector<Setting> settings;
};

/// Does a term add its cost to the others', or does it say where, and how often, the others are computed?
enum class TermKind { added, structural };

struct Term {
    std::string name;  ///< "Fresnel of gold"
    TermKind kind = TermKind::added;
    std::vector<TermOption> options;
    int oracle = 0;  ///< what the others are measured against
    int own = 0;     ///< what the scene says
    int base = 0;    ///< what holds while other terms are measured: the scene's own, or what is fast and near it
};

/// A term that is left alone, and why no picture can differ by it, or why nothing would be saved.
struct PrunedTerm {
    std::string name;
    std::string why;
};

struct SceneTerms {
    std::vector<Term> terms;
    std::vector<PrunedTerm> pruned;
};

/// The terms of the scene of a source. Options that the scene reader refuses are left out. `kept`: keys
/// ("image.samples") that stay as the scene has them.
[[nodiscard]] SceneTerms terms_of(const SceneSource& source, const std::set<std::string>& kept = {});

/// Is it the number of samples a pixel? That one multiplies what is done once a sample.
[[nodiscard]] bool is_samples(const Term& term);

/// The oracle's option of each term, the scene's own, and those that hold while others are measured.
[[nodiscard]] std::vector<int> oracles(const std::vector<Term>& terms);
[[nodiscard]] std::vector<int> owns(const std::vector<Term>& terms);
[[nodiscard]] std::vector<int> bases(const std::vector<Term>& terms);

/// The settings of one option of each term; the scene's own where `chosen` says so.
[[nodiscard]] std::vector<Setting> settings_of(const std::vector<Term>& terms, const std::vector<int>& chosen);

}  // namespace kreda::tools
