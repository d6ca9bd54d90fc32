// Runs experiments into a folder: NAME.csv, NAME.svg, NAME.png and NAME.txt each, and one page with all of them.
#pragma once

#include <string>
#include <vector>

#include "tools/measure/experiment.hpp"

namespace kreda::tools {

struct MeasureOptions {
    std::string folder;
    bool quick = false;
    bool again = false;  ///< also what is there already
    int threads = 0;
};

/// One experiment, unless its files are there and whole, made by this very program in the same way: NAME.key says so,
/// the last file that is written. Returns whether it ran. Throws UserError.
bool measure_one(const Experiment& experiment, const MeasureOptions& options);

/// Each of them, a progress bar beside it; then FOLDER/report.html of all that are in the folder. Throws UserError.
void measure_all(const std::vector<const Experiment*>& chosen, const MeasureOptions& options);

/// The page, of what the folder holds: it needs no other file.
[[nodiscard]] std::string report_page(const std::string& folder);

}  // namespace kreda::tools
