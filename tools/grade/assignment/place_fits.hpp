// A mistake made in some of the places where it can be made: every number that is wrong is what the mistake gives.
#pragma once

#include "tools/grade/assignment/table_fits.hpp"

namespace kreda::tools {

/// How a mistake explains the numbers that a submission has wrong, one by one. What the mistake spoils besides and the
/// submission does not says nothing: there the submission is right.
struct PlaceFit {
    std::size_t mistake = 0;
    double explained = 0.0;   ///< their share, over the functions that are wrong by themselves
    double reach = 0.0;       ///< of the numbers that the mistake spoils there, the share that the submission spoils
    bool of_picture = false;  ///< one of these functions gives a picture's colours, in which much adds up
    double surprise = 0.0;    ///< bits: how improbable it is that so many numbers agree by chance
};

/// Is the function of table i wrong although all that it calls is right?
[[nodiscard]] bool is_wrong_by_itself(const Fits& fits, std::size_t i);

/// Of every mistake, the best explanation first. Each component of each result may have been spoilt in its own way.
[[nodiscard]] std::vector<PlaceFit> place_fits(const Fits& fits);

}  // namespace kreda::tools
