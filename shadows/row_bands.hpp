// Rows of samples in bands: a thread works through one band, then takes the next.
#pragma once

#include <algorithm>

namespace kreda::shadows {

/// Rows of samples that a thread works through before it takes the next band.
inline constexpr int kRowsPerBand = 16;

/// Rows first .. last, both included.
struct RowBand {
    int first = 0, last = 0;  ///< of samples
};

/// The bands of a grid of so many rows.
[[nodiscard]] inline int count_bands(int rows) {
    return (rows + kRowsPerBand - 1) / kRowsPerBand;
}

/// Band 0 .. count_bands(rows) - 1 of a grid of so many rows; the last one may be lower than the others.
[[nodiscard]] inline RowBand row_band(int band, int rows) {
    return {band * kRowsPerBand, std::min((band + 1) * kRowsPerBand, rows) - 1};
}

}  // namespace kreda::shadows
