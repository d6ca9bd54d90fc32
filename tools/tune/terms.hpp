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

/// How the cost of a term adds to the others': as it is, or it multiplies what a sample costs.
enum class CostKind { added, multiplied };

struct Term {
    std::string name;  ///< "Fresnel of gold"
    CostKind cost = CostKind::added;
    std::vector<TermOption> options;
    int oracle = 0;  ///< what the others are measured against
    int own = 0;     ///< what the scene says
    int base = 0;    ///< what holds while other terms are measured: the scene's own, but one sample a pixel
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

/// The settings of one option of each term; the scene's own where `chosen` says so.
[[nodiscard]] std::vector<Setting> settings_of(const std::vector<Term>& terms, const std::vector<int>& chosen);

}  // namespace kreda::tools
