// How many samples the truth takes: as many as there is time for.
#include <algorithm>
#include <cmath>

#include "tools/tune/tune.hpp"

namespace kreda::tools {

namespace {

/// Seconds of the whole picture by the oracles of all terms but that of samples, which stays at its base.
double seconds_of_oracle(const SceneSource& source, const std::vector<Term>& terms, std::size_t samples,
                         const TuneOptions& options, DrawnSets& drawn) {
    constexpr double kLongMs = 400.0;
    std::vector<int> chosen = oracles(terms);
    chosen[samples] = terms[samples].base;
    std::vector<Setting> settings = settings_of(terms, chosen);
    settings.push_back(probe_size(read_with(source, {}).image, options.probe_pixels / 4));
    const scene::Scene scene = read_with(source, settings), whole = read_with(source, {});
    double ms = draw_with_baked(drawn, scene, options.threads).frame_ms;  // the first frame asks for memory, too
    for (int again = 0; again < 2 && ms < kLongMs; ++again) {
        ms = std::min(ms, draw_with_baked(drawn, scene, options.threads).frame_ms);
    }
    const auto pixels = [](const scene::ImageSettings& image) {
        return static_cast<double>(image.width) * image.height;
    };
    return 1e-3 * ms * pixels(whole.image) / pixels(scene.image);
}

}  // namespace

void limit_oracle(const SceneSource& source, std::vector<Term>& terms, const TuneOptions& options, DrawnSets& drawn) {
    const auto found = std::find_if(terms.begin(), terms.end(), is_samples);
    if (found == terms.end()) return;
    const double seconds =
        seconds_of_oracle(source, terms, static_cast<std::size_t>(found - terms.begin()), options, drawn);
    const auto n_of = [&](int o) { return std::stoi(found->options[static_cast<std::size_t>(o)].name); };
    const int own = n_of(found->own);
    std::vector<TermOption> kept;
    int most = 0;
    for (int o = 0; o < static_cast<int>(found->options.size()); ++o) {
        const int n = n_of(o);
        if (n > own && n > 2 && seconds * n * n > options.oracle_seconds) continue;
        kept.push_back(found->options[static_cast<std::size_t>(o)]);
        most = std::max(most, n);
    }
    found->options = kept;
    for (int o = 0; o < static_cast<int>(kept.size()); ++o) {
        if (n_of(o) == own) found->own = o;
        if (n_of(o) == most) found->oracle = o;
    }
}

}  // namespace kreda::tools
