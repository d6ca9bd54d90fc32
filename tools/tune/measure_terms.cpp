// Step 2 of tune.hpp: every option alone.
#include <algorithm>
#include <cmath>

#include "scene/error.hpp"
#include "tools/tune/tune.hpp"

namespace kreda::tools {

namespace {

constexpr double kLong = 400.0;  // ms: what takes longer is timed once

constexpr double kNoise = 0.08;  // of a frame: what differs by less takes the same time

/// One set on its way to be measured.
struct Probe {
    scene::Scene scene;
    raster::Image picture;
    std::vector<FrameParts> frames;
    FrameParts frame;
    double bake = 0.0;
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

void add_frame(Bench& bench, Probe& probe, const Picture& drawn) {
    const scene::RenderPlan plan = make_plan(probe.scene);
    probe.frames.push_back(parts_of(plan, drawn.times));
    add_rates(plan, drawn.times, bench.times);
}

double median_of(const std::vector<FrameParts>& frames, double FrameParts::*part) {
    std::vector<double> values;
    for (const FrameParts& frame : frames) values.push_back(frame.*part);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Its picture, what was baked for it, and its time.
Probe draw_first(Bench& bench, const std::vector<int>& chosen) {
    std::vector<Setting> settings = settings_of(bench.terms, chosen);
    settings.push_back(bench.measured.size);
    Probe probe;
    probe.scene = read_with(bench.source, settings);
    const Picture drawn = draw_with_baked(bench.drawn, probe.scene, bench.options.threads);
    probe.picture = drawn.encoded;
    probe.bake = drawn.bake_ms;
    ++bench.measured.renders;
    if (bench.takes_time()) add_frame(bench, probe, drawn);
    return probe;
}

/// The options in turn, round after round; the median counts.
void time_frames(Bench& bench, const std::vector<Probe*>& probes) {
    if (!bench.takes_time()) return;
    for (int round = 1; round < bench.options.rounds; ++round) {
        for (Probe* probe : probes) {
            if (probe->frames.front().sum() > kLong) continue;
            add_frame(bench, *probe, draw_with_baked(bench.drawn, probe->scene, bench.options.threads));
        }
    }
    for (Probe* probe : probes) {
        probe->frame = {median_of(probe->frames, &FrameParts::at_points), median_of(probe->frames, &FrameParts::rest)};
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
        bench.measured.errors.drawn.push_back(
            {chosen, signed_differences(probes.back().picture, bench.measured.exact)});
    }
    std::vector<Probe*> timed;
    for (Probe& probe : probes) timed.push_back(&probe);
    time_frames(bench, timed);
    Probe& own_base = probes[static_cast<std::size_t>(term.base)];
    const raster::Image& exact = probes[static_cast<std::size_t>(term.oracle)].picture;
    bench.measured.options.emplace_back();
    bench.measured.errors.changed.emplace_back();
    for (const Probe& probe : probes) {
        const auto more = [&](double FrameParts::*part) {
            const double ms = probe.frame.*part - own_base.frame.*part;
            return std::abs(ms) < kNoise * base.frame.sum() ? 0.0 : ms;
        };
        bench.measured.options.back().push_back({{more(&FrameParts::at_points), more(&FrameParts::rest)},
                                                 probe.bake - own_base.bake,
                                                 code_error(probe.picture, exact)});
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

/// The option of the environment that samples its integral, where the base is the split sum and the oracle is not; else
/// -1.
int integral_of(const Term& term) {
    const auto reference = [&](std::size_t o) {
        const Setting& first = term.options[o].settings.front();
        return first.table == "environment" && first.key == "reference" ? std::stoi(first.value) : -1;
    };
    if (reference(static_cast<std::size_t>(term.base)) != 0) return -1;
    for (std::size_t o = 0; o < term.options.size(); ++o) {
        if (reference(o) > 0) return static_cast<int>(o);
    }
    return -1;
}

Differences minus(Differences a, const Differences& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

/// One term's options beside `base`, another set than the usual: what they change there counts, and the greater error.
void measure_beside(Bench& bench, const std::vector<int>& base, const Differences& base_missed, std::size_t t) {
    std::vector<Differences> missed;
    for (std::size_t o = 0; o < bench.terms[t].options.size(); ++o) {
        std::vector<int> chosen = base;
        chosen[t] = static_cast<int>(o);
        if (chosen == base) {
            missed.push_back(base_missed);
        } else if (draw_probe(bench.source, bench.terms, chosen, bench.options, bench.drawn, bench.measured)) {
            missed.push_back(bench.measured.errors.drawn.back().missed);
        } else {
            return;
        }
    }
    for (std::size_t o = 0; o < missed.size(); ++o) {
        bench.measured.errors.changed[t][o] = minus(missed[o], base_missed);
        CodeError& known = bench.measured.options[t][o].error;
        const CodeError here = error_of(minus(missed[o], missed[static_cast<std::size_t>(bench.terms[t].oracle)]));
        if (budget_of(here) > budget_of(known)) known = here;
    }
}

/// The split sum takes no notice of the Fresnel method, the integral does: materials are drawn under both.
void measure_under_integral(Bench& bench) {
    for (std::size_t t = 0; t < bench.terms.size(); ++t) {
        const int integral = integral_of(bench.terms[t]);
        if (integral < 0) continue;
        std::vector<int> base = bases(bench.terms);
        base[t] = integral;
        const auto found = std::find_if(bench.measured.errors.drawn.begin(), bench.measured.errors.drawn.end(),
                                        [&](const DrawnProbe& probe) { return probe.chosen == base; });
        KREDA_EXPECT(found != bench.measured.errors.drawn.end());
        const Differences base_missed = found->missed;
        for (std::size_t m = 0; m < bench.terms.size(); ++m) {
            const bool of_material = bench.terms[m].options.front().settings.front().table == "material";
            if (of_material) measure_beside(bench, base, base_missed, m);
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
            const MeasuredOption& measured = bench.measured.options[t][o];
            FrameParts beyond = {measured.frame.at_points - (planned.parts.at_points - of_base.parts.at_points),
                                 measured.frame.rest - (planned.parts.rest - of_base.parts.rest)};
            if (bench.terms[t].kind == TermKind::structural) beyond = {};
            costs.beyond.back().push_back(beyond);
            costs.bake_more.back().push_back(measured.bake);
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
    measure_under_integral(bench);
    measure_distances(measured.errors);
    set_costs(bench);
    return measured;
}

}  // namespace kreda::tools
