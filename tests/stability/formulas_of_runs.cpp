// raster/run_weights.hpp beside the same in long double: the weights of a triangle's corners along a run.
#include "raster/run_weights.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

constexpr int kSide = 16383;  // samples, nearly as many as an image may have, and no power of two
constexpr int kSub = raster::kSubpixels;

/// The run's first sample, how far it is to the sample asked for, and how much nearer than the other two corners the
/// second one is.
const Axis kColumn{0.0f, 8128.0f, Spread::even, {1.0f}};
const Axis kRow{0.0f, 8191.0f, Spread::even, {4096.0f}};
const Axis kAlong{0.0f, 63.0f, Spread::even, {1.0f}};
const Axis kNearer{1e-9f, 1e9f, Spread::logarithmic, {1.0f}};
const std::vector<Axis> kAxes = {kColumn, kRow, kAlong, kNearer};

int whole(float x) {
    return static_cast<int>(x);
}

/// A right-angled triangle of that size.
raster::RunWeights weights_at(const Inputs& x) {
    const raster::ScreenVertex a{0, 0, 0.0f, 1.0f}, b{kSide * kSub, 0, 0.0f, x[3]}, c{0, kSide * kSub, 0.0f, 1.0f};
    return raster::run_weights(a, b, c, raster::centre_of(whole(x[0])), raster::centre_of(whole(x[1])));
}

/// lambda_i / w_i at the sample.
Wide exact_q(const Inputs& x) {
    const Real right = (whole(x[0]) + whole(x[2]) + 0.5L) / kSide, down = (whole(x[1]) + 0.5L) / kSide;
    return {1 - right - down, right * x[3], down};
}

Wide exact_weights(const Inputs& x) {
    const Wide q = exact_q(x);
    return q / (q.x + q.y + q.z);
}

VectorFormula row(const std::string& name, const std::string& range, double longest, double most_error,
                  glm::vec3 (*value)(const Inputs&), Wide (*exact)(const Inputs&)) {
    return {name,  "a triangle 16383 wide and high, 1/w of a corner 1e-9 to 1e9 of the others",
            range, longest,
            true,  most_error,
            kAxes, value,
            exact};
}

}  // namespace

std::vector<Formula> formulas_of_runs() {
    const VectorFormula weights = row(
        "corner_weights", "[0.57, 1]", 1.0000002, 3e-7,
        [](const Inputs& x) { return raster::corner_weights(weights_at(x), whole(x[2])); }, exact_weights);
    const VectorFormula q = row(
        "corner_q", "[3e-5, 1e9]", 1e9, 2e-7,
        [](const Inputs& x) { return raster::corner_q(weights_at(x), whole(x[2])); }, exact_q);
    const VectorFormula right = row(
        "q_step_right", "[6e-5, 6.2e4]", 6.2e4, 2e-7,
        [](const Inputs& x) { return raster::q_step_right(weights_at(x)); },
        [](const Inputs& x) { return Wide(-1, x[3], 0) / Real{kSide}; });
    const VectorFormula down = row(
        "q_step_down", "[8.6e-5, 8.7e-5]", 8.7e-5, 2e-7,
        [](const Inputs& x) { return raster::q_step_down(weights_at(x)); },
        [](const Inputs&) { return Wide(-1, 0, 1) / Real{kSide}; });
    return {formula_of(weights), formula_of(q), formula_of(right), formula_of(down)};
}

}  // namespace kreda::tests
