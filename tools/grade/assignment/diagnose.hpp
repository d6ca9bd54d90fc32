// Which classic mistake answers as a submission does?
#pragma once

#include <string>
#include <vector>

#include "tools/grade/assignment/table_fits.hpp"

namespace kreda::tools {

[[nodiscard]] Catalogue make_catalogue(const Rubric& rubric, const CaseSet& cases, bool with_pairs = true);

struct Diagnosis {
    enum class Kind { right, exactly, nearly, unknown };
    Kind kind = Kind::unknown;
    std::vector<std::size_t> mistakes;  ///< indices into Catalogue::mistakes; empty unless exactly or nearly
    double misfit = 1.0;                ///< share of the error that the best variant leaves unexplained, 0 to 1
    double next_misfit = 1.0;           ///< the same of the best that names neither of its mistakes
};

/// exactly: one variant gives the same answers. nearly: its answers are wrong in the same way, but for the size of the
/// error (another constant), or only some functions answer (the rest was written elsewhere). Else unknown.
[[nodiscard]] Diagnosis diagnose(const Marking& marking, const Catalogue& catalogue);

/// "looks exactly like: the normal is not renormalised after interpolation (page 24)", "unknown", or "".
[[nodiscard]] std::string diagnosis_text(const Diagnosis& diagnosis, const Catalogue& catalogue);

}  // namespace kreda::tools
