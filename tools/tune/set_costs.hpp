// What a set of options will cost, predicted from its plan: the plan knows what its terms do to each other, as that fog
// at vertices pays where light is computed there, too. A time takes each pass's operations at the rate that was
// measured of passes of its name, and adds what an option alone took beyond that.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/render/render.hpp"
#include "tools/tune/terms.hpp"

namespace kreda::tools {

/// What an option costs: milliseconds as measured, or the plan's estimate in millions of operations, which is the same
/// on every machine.
enum class CostBy { time, plan };

/// What a frame takes at points that are lit or sampled, and the rest: vertices, texels of shadow maps.
struct FrameParts {
    double at_points = 0.0, rest = 0.0;

    [[nodiscard]] double sum() const {
        return at_points + rest;
    }
};
[[nodiscard]] FrameParts parts_of(const scene::RenderPlan& plan, const scene::StageTimes& times);

/// The cost of a set at one sample a pixel, by what it grows with.
struct SetCost {
    double of_samples = 0.0;  ///< with the number of samples
    double of_picture = 0.0;  ///< with nothing
    FrameParts parts;         ///< the same sum, divided as measured times are
    double film = 0.0;        ///< of one operation at each pixel
    double bake = 0.0;        ///< before the first frame
    double lit = 1.0;         ///< points at which light is computed
    int samples = 1;          ///< a side of a pixel
    bool lit_at_samples = true;
    bool is_possible = true;  ///< the reader refuses nothing of it
};

struct SetCosts {
    CostBy by = CostBy::time;
    std::map<std::string, double> rates;          ///< of passes, an operation
    double usual_rate = 1e-6;                     ///< of passes that were not measured
    std::vector<std::vector<FrameParts>> beyond;  ///< of each term and option, at the points that the base lights
    std::vector<std::vector<double>> bake_more;   ///< the same, of what is baked
    double base_lit = 1.0;
    std::map<std::vector<int>, SetCost> known;
};

/// Adds a frame's times to those that rates are made from.
using PassTimes = std::map<std::string, std::vector<double>>;
void add_rates(const scene::RenderPlan& plan, const scene::StageTimes& times, PassTimes& rates);
/// Their medians.
void set_rates(const PassTimes& measured, SetCosts& costs);

/// Multiplies all that was measured: the machine was busier, or freer, than it is.
void scale_times(SetCosts& costs, double factor);

/// A set whose cost is asked for: of a probe's size, at the fewest samples.
struct CostSubject {
    const SceneSource& source;
    const std::vector<Term>& terms;
    Setting size;  ///< of the probe
};

/// By the plan of the set, with the terms at their base that are no matter of the plan (samples; in time, what is
/// computed at lit points); without what options took beyond it.
[[nodiscard]] const SetCost& planned_cost(const CostSubject& subject, SetCosts& costs, std::vector<int> chosen);

/// A whole picture of so many times the probe's pixels.
struct PictureCost {
    double frame = 0.0, bake = 0.0;
};
[[nodiscard]] PictureCost picture_cost(const CostSubject& subject, SetCosts& costs, const std::vector<int>& chosen,
                                       double pixels_of_probe);

/// Samples a side of a pixel that the set has; 0: it is not a term.
[[nodiscard]] int samples_of(const std::vector<Term>& terms, const std::vector<int>& chosen);

}  // namespace kreda::tools
