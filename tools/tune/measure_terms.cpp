// Step 2 of tune.hpp: every option alone.
#include <algorithm>
#include <cmath>

#include "scene/error.hpp"
#include "tools/tune/tune.hpp"

namespace kreda::tools {

namespace {

constexpr double kLong = 400.0;  // ms: what takes longer is timed once

constexpr double kNoise = 0.04;  // of a frame: what differs by less takes the same time

/// One set on its way to be measured.
struct Probe {
    scene::Scene scene;
    raster::Image picture;
    std::vector<double> frames;
    double frame = 0.0, bake = 0.0;
};

/// Everything that measuring needs.
struct Bench {
    const SceneSource& source;
    const std::vector<Term>& terms;
    const TuneOptions& options;
    DrawnSets& drawn;
    MeasuredTerms& measured;
    PassTimes times = {};

    [[nodiscard]] bool takes_time() const {
        return options.cost_by == CostBy::time;
    }
};

/// Its picture, what was baked for it, and its time.
Probe draw_first(Bench& bench, const std::vector<int>& chosen) {
    std::vector<Setting> settings = settings_of(bench.terms, chosen);
    settings.push_back(bench.measured.size);
    Probe probe{read_with(bench.source, settings), {}, {}};
    const Picture drawn = draw_with_baked(bench.drawn, probe.scene, bench.options.threads);
    probe.picture = drawn.encoded;
    probe.bake = drawn.bake_ms;
    probe.frames = {drawn.frame_ms};
    ++bench.measured.renders;
    if (bench.takes_time()) add_rates(make_plan(probe.scene), drawn.times, bench.times);
    return probe;
}

/// The options in turn, round after round; the median counts.
void time_frames(Bench& bench, std::vector<Probe*> probes) {
    if (!bench.takes_time()) return;
    for (int round = 1; round < bench.options.rounds; ++round) {
        for (Probe* probe : probes) {
            if (probe->frames.front() > kLong) continue;
            const Picture again = draw_with_baked(bench.drawn, probe->scene, bench.options.threads);
            probe->frames.push_back(again.frame_ms);
            add_rates(make_plan(probe->scene), again.times, bench.times);
        }
    }
    for (Probe* probe : probes) {
        const auto middle = probe->frames.begin() + static_cast<std::ptrdiff_t>(probe->frames.size() / 2);
        std::nth_element(probe->frames.begin(), middle, probe->frames.end());
        probe->frame = *middle;
    }
}

/// All options of one term, the base among them; sets are drawn with the others at their base.
void measure_term(Bench& bench, const Probe& base, std::size_t t) {
    const Term& term = bench.terms[t];
    std::vector<Probe> probes;
    for (std::size_t o = 0; o < term.options.size(); ++o) {
        std::vector<int> chosen = bases(bench.terms);
        chosen[t] = static_cast<int>(o);
        probes.push_back(static_cast<int>(o) == term.base ? base : draw_first(bench, chosen));
        if (static_cast<int>(o) == term.base) continue;
        bench.measured.errors.drawn.push_back({chosen, signed_differences(probes.back().picture, bench.measured.exact)});
    }
    std::vector<Probe*> timed;
    for (Probe& probe : probes) timed.push_back(&probe);
    time_frames(bench, timed);
    Probe& own_base = probes[static_cast<std::size_t>(term.base)];
    const raster::Image& exact = probes[static_cast<std::size_t>(term.oracle)].picture;
    bench.measured.options.emplace_back();
    bench.measured.errors.changed.emplace_back();
    for (const Probe& probe : probes) {
        const bool is_noise = std::abs(probe.frame - own_base.frame) < kNoise * base.frame;
        bench.measured.options.back().push_back({is_noise ? 0.0 : probe.frame - own_base.frame,
                                                 probe.bake - own_base.bake, code_error(probe.picture, exact)});
        bench.measured.errors.changed.back().push_back(signed_differences(probe.picture, base.picture));
    }
}

/// Structural terms two by two, one of them the tessellation: coarse triangles err more where they are shaded flat.
void draw_pairs(Bench& bench) {
    const auto is_structural = [&](std::size_t t) {
        return bench.terms[t].kind == TermKind::structural && !is_samples(bench.terms[t]);
    };
    for (std::size_t t = 0; t < bench.terms.size(); ++t) {
        for (std::size_t u = 0; u < t; ++u) {
            if (!is_structural(t) || !is_structural(u)) continue;
            for (std::size_t o = 0; o < bench.terms[t].options.size() * bench.terms[u].options.size(); ++o) {
                std::vector<int> chosen = bases(bench.terms);
                chosen[t] = static_cast<int>(o % bench.terms[t].options.size());
                chosen[u] = static_cast<int>(o / bench.terms[t].options.size());
                if (chosen[t] == bench.terms[t].base || chosen[u] == bench.terms[u].base) continue;
                draw_probe(bench.source, bench.terms, chosen, bench.options, bench.drawn, bench.measured);
            }
        }
    }
}

/// What options take beyond what their plans say, by the rates of all passes.
void set_costs(Bench& bench) {
    SetCosts& costs = bench.measured.costs;
    costs.by = bench.options.cost_by;
    set_rates(bench.times, costs);
    const CostSubject subject{bench.source, bench.terms, bench.measured.size};
    const std::vector<int> base = bases(bench.terms);
    const SetCost of_base = planned_cost(subject, costs, base);
    costs.base_lit = of_base.lit;
    for (std::size_t t = 0; t < bench.terms.size(); ++t) {
        costs.beyond.emplace_back();
        costs.bake_more.emplace_back();
        for (std::size_t o = 0; o < bench.terms[t].options.size(); ++o) {
            std::vector<int> chosen = base;
            chosen[t] = static_cast<int>(o);
            const SetCost& planned = planned_cost(subject, costs, chosen);
            const double more = planned.of_samples + planned.of_picture - of_base.of_samples - of_base.of_picture;
            const bool is_added = bench.terms[t].kind == TermKind::added;
            costs.beyond.back().push_back(is_added ? bench.measured.options[t][o].frame - more : 0.0);
            costs.bake_more.back().push_back(bench.measured.options[t][o].bake);
        }
    }
}

}  // namespace

Setting probe_size(const scene::ImageSettings& image, int pixels) {
    const double all = static_cast<double>(image.width) * image.height;
    const double scale = std::min(1.0, std::sqrt(pixels / all));
    const auto side = [&](int n) { return std::to_string(std::max(1, static_cast<int>(std::lround(scale * n)))); };
    return {"image", -1, "size", "[" + side(image.width) + "," + side(image.height) + "]"};
}

double budget_of(const CodeError& error) {
    return std::max(error.mean, error.p99 / 4.0);
}

bool draw_probe(const SceneSource& source, const std::vector<Term>& terms, const std::vector<int>& chosen,
                const TuneOptions& options, DrawnSets& drawn, MeasuredTerms& measured) {
    std::vector<Setting> settings = settings_of(terms, chosen);
    settings.push_back(measured.size);
    try {
        const Picture picture = draw_with_baked(drawn, read_with(source, settings), options.threads);
        measured.errors.drawn.push_back({chosen, signed_differences(picture.encoded, measured.exact)});
        ++measured.renders;
        return true;
    } catch (const scene::UserError&) { return false; }  // options that do not go together
}

MeasuredTerms measure_terms(const SceneSource& source, const std::vector<Term>& terms, const TuneOptions& options,
                            DrawnSets& drawn) {
    MeasuredTerms measured;
    measured.size = probe_size(read_with(source, {}).image, options.probe_pixels);
    Bench bench{source, terms, options, drawn, measured};
    measured.exact = draw_first(bench, oracles(terms)).picture;
    measured.errors.drawn.push_back({oracles(terms), signed_differences(measured.exact, measured.exact)});
    Probe base = draw_first(bench, bases(terms));
    time_frames(bench, {&base});
    measured.errors.drawn.push_back({bases(terms), signed_differences(base.picture, measured.exact)});
    for (std::size_t t = 0; t < terms.size(); ++t) {
        measure_term(bench, base, t);
        if (options.progress) options.progress(static_cast<double>(t + 1) / static_cast<double>(terms.size()));
    }
    draw_pairs(bench);
    measure_distances(measured.errors);
    set_costs(bench);
    return measured;
}

}  // namespace kreda::tools
