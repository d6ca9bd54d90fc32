// What sets of settings are predicted to miss and to cost.
#include <doctest/doctest.h>

#include "scene/plan/plan_cost.hpp"
#include "tests/measure/tuned_scenes.hpp"
#include "tools/tune/front.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::tools;

namespace {

/// Two terms with two options each on a picture of two pixels; the base is the exact picture.
SetErrors two_terms(const Differences& first, const Differences& second) {
    const Differences none(6, 0.0f);
    SetErrors errors;
    errors.changed = {{none, first}, {none, second}};
    errors.drawn = {{{0, 0}, none}, {{1, 0}, first}, {{0, 1}, second}};
    measure_distances(errors);
    return errors;
}

}  // namespace

TEST_CASE("predictions: errors that cancel are none and errors on other pixels are a mean of both") {
    const SetErrors opposite = two_terms({3, 0, 3, 0, 3, 0}, {-3, 0, -3, 0, -3, 0});
    CHECK(predicted_error(opposite, opposite.drawn[0], {1, 1}).mean == 0.0);
    CHECK(predicted_error(opposite, opposite.drawn[1], {1, 1}).mean == 0.0);
    CHECK(predicted_error(opposite, opposite.drawn[1], {1, 0}).mean == 1.5);  // 3 codes on one of two pixels
    const SetErrors apart = two_terms({4, 0, 1, 0, 0, 0}, {0, 2, 0, 0, 0, 0});
    CHECK(predicted_error(apart, apart.drawn[2], {1, 1}).mean == 3.0);  // the most of a pixel's components
    CHECK(predicted_error(apart, apart.drawn[2], {1, 1}).worst == 4.0);
}

TEST_CASE("predictions: a drawn set is no distance from itself and the nearest is the one that differs least") {
    const SetErrors errors = two_terms({4, 4, 4, 4, 4, 4}, {1, 1, 1, 1, 1, 1});
    CHECK(distance_from(errors, errors.drawn[1], {1, 0}) == 0.0);
    CHECK(distance_from(errors, errors.drawn[1], {1, 1}) < distance_from(errors, errors.drawn[2], {1, 1}));
    CHECK(distance_from(errors, errors.drawn[2], {1, 1}) < distance_from(errors, errors.drawn[0], {1, 1}));
}

TEST_CASE("predictions: the plan's cost of a set is that of its scene for any number of samples") {
    const SceneSource source{kTunedScenes[0].text, "fog", "", {}};
    const std::vector<Term> terms = terms_of(source).terms;
    TuneOptions options;
    options.cost_by = CostBy::plan;
    DrawnSets drawn;
    MeasuredTerms measured;
    measured.size = probe_size(read_with(source, {}).image, 1'000'000);  // the picture itself
    measured.costs.by = CostBy::plan;
    const FrontSubject subject{source, terms, options, drawn, measured};
    for (const std::vector<int>& chosen : {bases(terms), owns(terms), oracles(terms)}) {
        const scene::Scene scene = read_with(source, settings_of(terms, chosen));
        CHECK(predicted_cost(subject, chosen) == doctest::Approx(1e-6 * total_operations(make_plan(scene))));
    }
}
