// A mistake made in some of the places where it can be made: every number that is wrong is what the mistake gives.
#pragma once

#include "tools/grade/assignment/table_fits.hpp"

namespace kreda::tools {

/// How a mistake explains the numbers that a submission has wrong, one by one. What the mistake spoils besides and the
/// submission does not says nothing: there the submission is right.
struct PlaceFit {
    std::size_t mistake = 0;
    double explained = 0.0;  ///< the least share, over the functions that are wrong by themselves
    double reach = 0.0;      ///< of what its closest way spoils there, the share that the submission spoils
    double surprise = 0.0;   ///< bits: how improbable it is that so many numbers agree by chance
};

/// Of every mistake, the best explanation first. Any of its ways may stand behind any of the numbers.
[[nodiscard]] std::vector<PlaceFit> place_fits(const Fits& fits);

}  // namespace kreda::tools
