// Terms of shadows, environment and fog.
#include <algorithm>

#include "tools/tune/term_subject.hpp"

namespace kreda::tools {

namespace {

TermOption map_option(const std::string& size, const std::string& bias, const std::string& filter) {
    return {"map of " + size + " texels, " + bias + ", " + filter,
            {{"shadow", -1, "method", "map"},
             {"shadow", -1, "size", size},
             {"shadow", -1, "bias", bias},
             {"shadow", -1, "filter", filter}}};
}

bool is_constant(const scene::EnvironmentSettings& environment) {
    if (!environment.image) return false;
    const raster::Image& image = *environment.image;
    for (int c = 0; c < image.channels; ++c) {
        const auto [least, most] = std::minmax_element(image.plane(c), image.plane(c) + image.plane_size());
        if (*least != *most) return false;
    }
    return true;
}

/// More samples of the split sum than these buy nothing: what it misses of the integral is far more than their noise.
constexpr int kMostOfSplitSum = 2048;

}  // namespace

namespace {

TermOption method_option(const std::string& method) {
    return {method == "exact" ? "rays" : method, {{"shadow", -1, "method", method}}};
}

}  // namespace

/// Hard shadows are measured against rays, soft ones against the finest map.
void add_shadow_term(TermSubject& subject) {
    if (is_kept(subject, "shadow", "method", "shadows")) return;
    if (subject.plan.shadows.empty()) return prune(subject, "shadows", "no light casts shadows onto anything seen");
    const auto own = [&](const std::string& key) { return subject.own("shadow", -1, key); };
    const Choice& sizes = *find_choice("shadow", "size");
    const bool is_map = own("method") == "map", is_soft = is_map && own("filter") == "pcss";
    const std::string filter = own("filter");
    Term term{"shadows", TermKind::added, {}, 0, 0};
    for (const std::string& size : sizes.values) {
        for (const char* bias : {"slope", "normal_offset"}) add_option(subject, term, map_option(size, bias, filter));
        if (filter != "none") add_option(subject, term, map_option(size, "slope", "none"));
    }
    for (const std::string& method : find_choice("shadow", "method")->values) {
        if (!is_soft && method != "map") add_option(subject, term, method_option(method));
    }
    TermOption mine = method_option(own("method"));
    if (is_map) mine = map_option(own("size"), own("bias"), filter);
    TermOption oracle = method_option("exact");
    if (is_soft) oracle = map_option(sizes.oracle, "slope", "pcss");
    const std::size_t terms = subject.found.terms.size();
    add_term(subject, std::move(term), mine, oracle);
    // While other terms are measured a hard shadow does: it lies where the soft one lies, and takes a small part of it.
    if (is_map && filter != "none" && subject.found.terms.size() > terms) {
        set_base(subject.found.terms.back(), map_option(own("size"), "slope", "none"));
    }
}

void add_environment_term(TermSubject& subject) {
    if (!subject.plan.lit_by_environment) return prune(subject, "environment", "nothing is lit by one");
    if (is_kept(subject, "environment", "reference", "environment")) return;
    if (is_constant(subject.scene.environment)) {
        return prune(subject, "environment", "it is the same in every direction: there is nothing to blur");
    }
    const auto split_sum = [](const std::string& irradiance, const std::string& samples) {
        return TermOption{"split sum, " + irradiance + ", " + samples + " samples",
                          {{"environment", -1, "reference", "0"},
                           {"environment", -1, "irradiance", irradiance},
                           {"environment", -1, "samples", samples}}};
    };
    const auto integral = [](const std::string& samples) {
        return TermOption{"integral, " + samples + " samples", {{"environment", -1, "reference", samples}}};
    };
    Term term{"environment", TermKind::added, {}, 0, 0};
    const bool mirrors = subject.plan.environment.blurred;
    const std::vector<std::string> samples =
        mirrors ? find_choice("environment", "samples")->values
                : std::vector<std::string>{subject.own("environment", -1, "samples")};  // no prefiltered level is read
    for (const std::string& irradiance : find_choice("environment", "irradiance")->values) {
        for (const std::string& count : samples) {
            if (std::stoi(count) <= kMostOfSplitSum) add_option(subject, term, split_sum(irradiance, count));
        }
    }
    const Choice& reference = *find_choice("environment", "reference");
    for (const std::string& count : reference.values) {
        if (count != "0") add_option(subject, term, integral(count));
    }
    const auto own = [&](const std::string& key) { return subject.own("environment", -1, key); };
    const TermOption mine =
        own("reference") == "0" ? split_sum(own("irradiance"), own("samples")) : integral(own("reference"));
    const std::size_t terms = subject.found.terms.size();
    add_term(subject, std::move(term), mine, integral(reference.oracle));
    // The same: the split sum while others are measured.
    if (own("reference") != "0" && subject.found.terms.size() > terms) subject.found.terms.back().base = 0;
}

void add_fog_terms(TermSubject& subject) {
    if (!subject.plan.fog_at_pixels && !subject.plan.fog_at_vertices) {
        return prune(subject, "fog", "there is none before anything seen");
    }
    add_choice(subject, "fog", -1, "frequency", "", TermKind::structural);
    add_choice(subject, "fog", -1, "distance");
}

}  // namespace kreda::tools
