// A number beside its limit, as every comparison and every report shows it.
#pragma once

#include <optional>
#include <string>

namespace kreda::tools {

/// "pixels that differ", 12, 288, "0.5 % of 57600 pixels".
struct Measurement {
    std::string name;
    double value = 0.0;
    std::optional<double> limit;  ///< empty: there is none, the value is only told
    std::string text;             ///< what the limit means, or a remark; may be empty
    bool ok = true;
};

}  // namespace kreda::tools
