// Which values a key takes in a sweep, one after another.
#pragma once

#include <string>
#include <vector>

namespace kreda::tools {

/// A key of the scene as --set names it, and its values as they would stand in the file.
struct SweepAxis {
    std::string key;
    std::vector<std::string> values;

    /// "KEY=VALUE": what --set takes.
    [[nodiscard]] std::string override_at(std::size_t i) const {
        return key + "=" + values[i];
    }
};

/// "material.gold.roughness=0.1,0.4,0.8" has three values, "camera.position=[0,1,4],[4,1,0]" two: a comma inside
/// brackets or quotes divides nothing. Throws UserError.
[[nodiscard]] SweepAxis listed_axis(const std::string& set);

/// `count` values with even steps from the first to the last: "fog.density=0..0.5" or
/// "light.0.position=[-2,3,1]..[2,3,1]". With `around` the last is left out, since it shows what the first does. A
/// single value stays what it is. Throws UserError.
[[nodiscard]] SweepAxis stepped_axis(const std::string& set, int count, bool around);

}  // namespace kreda::tools
