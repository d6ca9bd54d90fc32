// What a set of options will miss, predicted from pictures that were drawn: to the nearest of them what each option
// changed alone is added, pixel by pixel and with its sign. So errors that lie on different pixels, or that cancel,
// count as they do.
#pragma once

#include <vector>

#include "raster/image.hpp"
#include "tools/measure/picture.hpp"

namespace kreda::tools {

/// A picture minus another one, in codes: every number of one component, then those of the next. Not rounded.
using Differences = std::vector<float>;
[[nodiscard]] Differences signed_differences(const raster::Image& encoded, const raster::Image& other);

/// As code_error() of two pictures: the most of a pixel's three components counts.
[[nodiscard]] CodeError error_of(const Differences& differences);

/// A set that was drawn, and what it missed.
struct DrawnProbe {
    std::vector<int> chosen;  ///< an option of each term
    Differences missed;       ///< minus the picture by all oracles
};

struct SetErrors {
    std::vector<std::vector<Differences>> changed;  ///< of each term and option: alone, minus the base picture
    /// Of each term: how far two of its options are apart, in codes of the mean; row by row.
    std::vector<std::vector<std::vector<double>>> apart;
    std::vector<DrawnProbe> drawn;
};

/// Fills `apart` from `changed`.
void measure_distances(SetErrors& errors);

/// How much of a set was never drawn together with the rest of a drawn one, in codes: what the prediction adds.
[[nodiscard]] double distance_from(const SetErrors& errors, const DrawnProbe& drawn, const std::vector<int>& chosen);

/// What the set misses, from that drawn set.
[[nodiscard]] CodeError predicted_error(const SetErrors& errors, const DrawnProbe& from,
                                        const std::vector<int>& chosen);

}  // namespace kreda::tools
