// Which term spent the error where.
#include "scene/error.hpp"
#include "tools/tune/tune.hpp"

namespace kreda::tools {

Attribution attribution(const SceneSource& source, const Tuned& tuned, const TuneOptions& options) {
    const std::vector<Term>& terms = tuned.found.terms;
    const Setting size = probe_size(read_with(source, {}).image, kAttributedPixels);
    DrawnSets drawn;
    const auto picture_with = [&](const std::vector<int>& chosen) {
        std::vector<Setting> settings = settings_of(terms, chosen);
        settings.push_back(size);
        return draw_with_baked(drawn, read_with(source, settings), options.threads).encoded;
    };
    const raster::Image chosen = picture_with(tuned.choice.chosen);
    Attribution attributed{chosen.width, chosen.height, {}};
    for (std::size_t t = 0; t < terms.size(); ++t) {
        attributed.codes.emplace_back();
        if (options.progress) options.progress(static_cast<double>(t) / static_cast<double>(terms.size()));
        if (tuned.choice.chosen[t] == terms[t].oracle) continue;
        std::vector<int> raised = tuned.choice.chosen;
        raised[t] = terms[t].oracle;
        try {
            attributed.codes.back() = code_differences(picture_with(raised), chosen);
        } catch (const scene::UserError&) {}  // a frequency that does not go with the chosen shadows, alone
    }
    return attributed;
}

}  // namespace kreda::tools
