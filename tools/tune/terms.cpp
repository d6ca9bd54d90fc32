#include "tools/tune/terms.hpp"

#include <algorithm>

#include "raster/platform.hpp"
#include "raster/shapes.hpp"
#include "scene/map_meshes.hpp"
#include "scene/plan/plan.hpp"
#include "tools/measure/choices.hpp"

namespace kreda::tools {

namespace {

using lighting::ReflectionModel;

/// What all terms are made from.
struct Subject {
    const SceneSource& source;
    const std::set<std::string>& kept;
    scene::Scene scene;
    scene::RenderPlan plan;
    std::vector<bool> visible;  ///< materials
    SceneTerms found{};

    [[nodiscard]] std::string own(const std::string& table, int which, const std::string& key) const {
        return value_in(source, table, which, key);
    }
    [[nodiscard]] bool is_accepted(const TermOption& option) const {
        try {
            (void)read_with(source, option.settings);
            return true;
        } catch (const scene::UserError&) { return false; }
    }
};

void prune(Subject& subject, const std::string& name, const std::string& why) {
    subject.found.pruned.push_back({name, why});
}

int index_of(const Term& term, const TermOption& option) {
    for (std::size_t i = 0; i < term.options.size(); ++i) {
        if (term.options[i].settings == option.settings) return static_cast<int>(i);
    }
    return -1;
}

/// Adds the option unless it is there or refused.
void add_option(const Subject& subject, Term& term, const TermOption& option) {
    if (index_of(term, option) < 0 && subject.is_accepted(option)) term.options.push_back(option);
}

/// A term of all options and these two; left out where there is nothing to choose.
void add_term(Subject& subject, Term term, const TermOption& own, const TermOption& oracle) {
    add_option(subject, term, own);
    add_option(subject, term, oracle);
    term.own = index_of(term, own);
    term.oracle = index_of(term, oracle);
    term.base = term.own;
    if (term.own < 0 || term.oracle < 0) return prune(subject, term.name, "its oracle is refused with this scene");
    if (term.options.size() < 2) return prune(subject, term.name, "there is one way alone");
    subject.found.terms.push_back(std::move(term));
}

bool is_kept(Subject& subject, const std::string& table, const std::string& key, const std::string& name) {
    const bool kept = subject.kept.contains(table + "." + key);
    if (kept) prune(subject, name, "kept as the scene has it");
    return kept;
}

/// The term of a row of the registry, value by value.
void add_choice(Subject& subject, const std::string& table, int which, const std::string& key,
                const std::string& of = "", CostKind cost = CostKind::added) {
    const Choice* choice = find_choice(table, key);
    KREDA_EXPECT(choice != nullptr);
    const std::string name = std::string(choice->name) + of;
    if (is_kept(subject, table, key, name)) return;
    if (choice->oracle.empty()) return prune(subject, name, "no oracle: " + std::string(choice->why_oracle));
    const auto option = [&](const std::string& value) { return TermOption{value, {{table, which, key, value}}}; };
    Term term{name, cost, {}, 0, 0};
    for (const std::string& value : choice->values) add_option(subject, term, option(value));
    add_term(subject, std::move(term), option(subject.own(table, which, key)), option(choice->oracle));
}

// ------------------------------------------------------------------------------------------------ the picture

bool is_round(const std::string& shape) {
    return shape != "cube" && shape != "plane" && raster::default_detail(shape).has_value();
}

/// All built-in round shapes together, by factors of the detail that they have.
void add_tessellation(Subject& subject) {
    if (is_kept(subject, "object", "detail", "tessellation")) return;
    std::vector<std::pair<int, int>> details;  // object, its own detail
    for (std::size_t i = 0; i < subject.scene.objects.size(); ++i) {
        const std::string shape = subject.scene.objects[i].mesh_name;
        if (!is_round(shape)) continue;
        const std::string own = subject.own("object", static_cast<int>(i), "detail");
        details.emplace_back(static_cast<int>(i), own.empty() ? *raster::default_detail(shape) : std::stoi(own));
    }
    if (details.empty()) return prune(subject, "tessellation", "no built-in shape is round");
    const auto option = [&](double factor, const std::string& name) {
        TermOption made{name, {}};
        for (const auto& [object, detail] : details) {
            const int scaled = std::max(8, static_cast<int>(factor * detail));
            made.settings.push_back({"object", object, "detail", std::to_string(scaled)});
        }
        return made;
    };
    Term term{"tessellation", CostKind::added, {}, 0, 0};
    add_option(subject, term, option(0.25, "a quarter"));
    add_option(subject, term, option(0.5, "half"));
    add_term(subject, std::move(term), option(1.0, "as it is"), option(2.0, "double"));
}

/// More samples than this are not taken even for the truth: they would not fit into the memory of a small machine.
constexpr std::int64_t kMostSamples = std::int64_t(1) << 25;

void add_supersampling(Subject& subject) {
    const Choice& choice = *find_choice("image", "samples");
    const std::string name(choice.name);
    if (is_kept(subject, "image", "samples", name)) return;
    const auto option = [](int n) {
        return TermOption{std::to_string(n), {{"image", -1, "samples", std::to_string(n)}}};
    };
    const scene::ImageSettings& image = subject.scene.image;
    Term term{name, CostKind::multiplied, {}, 0, 0};
    int most = image.samples;
    for (const std::string& value : choice.values) {
        const int n = std::stoi(value);
        if (std::int64_t{image.width} * image.height * n * n > kMostSamples) continue;
        add_option(subject, term, option(n));
        most = std::max(most, n);
    }
    const std::size_t terms = subject.found.terms.size();
    add_term(subject, std::move(term), option(image.samples), option(most));
    if (subject.found.terms.size() > terms) subject.found.terms.back().base = 0;  // the first: the fewest samples
}

void add_picture_terms(Subject& subject) {
    add_supersampling(subject);
    const bool lit = subject.plan.has_lights || subject.plan.lit_by_environment;
    if (lit) add_choice(subject, "shading", -1, "frequency", "", CostKind::multiplied);
    if (!lit) prune(subject, "shading frequency", "nothing is lit");
    if (subject.scene.camera.projection == raster::Projection::orthographic) {
        prune(subject, "interpolation", "parallel rays: with and without perspective are the same");
    } else {
        add_choice(subject, "shading", -1, "interpolation");
    }
    prune(subject, "transfer function", "takes the same time whatever it is");
    add_tessellation(subject);
}

// ------------------------------------------------------------------------------------------------ shadows

TermOption map_option(const std::string& size, const std::string& bias, const std::string& filter) {
    return {"map of " + size + " texels, " + bias + ", " + filter,
            {{"shadow", -1, "method", "map"},
             {"shadow", -1, "size", size},
             {"shadow", -1, "bias", bias},
             {"shadow", -1, "filter", filter}}};
}

/// Hard shadows are measured against rays, soft ones against the finest map.
void add_shadow_term(Subject& subject) {
    if (is_kept(subject, "shadow", "method", "shadows")) return;
    if (subject.plan.shadows.empty()) return prune(subject, "shadows", "no light casts shadows onto anything seen");
    const auto own = [&](const std::string& key) { return subject.own("shadow", -1, key); };
    const Choice& sizes = *find_choice("shadow", "size");
    const bool is_soft = own("method") == "map" && own("filter") == "pcss";
    const std::string filter = is_soft ? "pcss" : own("filter");
    const TermOption rays{"rays", {{"shadow", -1, "method", "exact"}}};
    const TermOption finest = map_option(sizes.oracle, "slope", "pcss");
    Term term{"shadows", CostKind::added, {}, 0, 0};
    for (const std::string& size : sizes.values) {
        for (const char* bias : {"slope", "normal_offset"}) add_option(subject, term, map_option(size, bias, filter));
        if (filter != "none") add_option(subject, term, map_option(size, "slope", "none"));
    }
    if (!is_soft) {
        for (const std::string& method : find_choice("shadow", "method")->values) {
            if (method != "map") add_option(subject, term, {method, {{"shadow", -1, "method", method}}});
        }
        term.options.erase(std::remove_if(term.options.begin(), term.options.end(),
                                          [](const TermOption& option) { return option.name == "exact"; }),
                           term.options.end());
    }
    const bool is_map = own("method") == "map";
    const TermOption mine = is_map ? map_option(own("size"), own("bias"), own("filter"))
                                   : TermOption{own("method"), {{"shadow", -1, "method", own("method")}}};
    add_term(subject, std::move(term), own("method") == "exact" ? rays : mine, is_soft ? finest : rays);
}

// ------------------------------------------------------------------------------------------------ environment, fog

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

void add_environment_term(Subject& subject) {
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
    Term term{"environment", CostKind::added, {}, 0, 0};
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
    add_term(subject, std::move(term), mine, integral(reference.oracle));
}

void add_fog_terms(Subject& subject) {
    if (!subject.plan.fog_at_pixels && !subject.plan.fog_at_vertices) {
        return prune(subject, "fog", "there is none before anything seen");
    }
    add_choice(subject, "fog", -1, "frequency");
    add_choice(subject, "fog", -1, "distance");
}

// ------------------------------------------------------------------------------------------------ materials

void add_fresnel_term(Subject& subject, int m, const std::string& of) {
    if (is_kept(subject, "material", "fresnel", "Fresnel" + of)) return;
    const Choice& methods = *find_choice("material", "fresnel");
    const auto option = [&](const std::string& method) {
        return TermOption{method, {{"material", m, "fresnel", method}}};
    };
    Term term{"Fresnel" + of, CostKind::added, {}, 0, 0};
    for (const std::string& method : methods.values) {
        if (method == "table") continue;
        add_option(subject, term, option(method));
    }
    for (const std::string& size : find_choice("material", "table_size")->values) {
        TermOption table{"table of " + size,
                         {{"material", m, "fresnel", "table"}, {"material", m, "table_size", size}}};
        add_option(subject, term, table);
    }
    const std::string own = subject.own("material", m, "fresnel");
    const std::string size = subject.own("material", m, "table_size");
    const TermOption table{"table of " + size,
                           {{"material", m, "fresnel", "table"}, {"material", m, "table_size", size}}};
    add_term(subject, std::move(term), own == "table" ? table : option(own), option(methods.oracle));
}

void add_material_terms(Subject& subject) {
    const bool lit = subject.plan.has_lights || subject.plan.lit_by_environment;
    bool any_microfacet = false;
    for (std::size_t i = 0; i < subject.scene.materials.size(); ++i) {
        const lighting::Material& material = subject.scene.materials[i];
        const int m = static_cast<int>(i);
        const std::string of = " of " + material.name;
        if (!subject.visible[i]) continue;
        const auto& setup = subject.plan.materials[i];
        if (setup.map_needs.uv) add_choice(subject, "material", m, "texture_filter", of);
        if (material.model != ReflectionModel::cook_torrance || !lit) continue;
        any_microfacet = true;
        if (!material.cook_torrance.measured.empty()) add_choice(subject, "material", m, "spectrum", of);
        add_fresnel_term(subject, m, of);
        if (material.cook_torrance.distribution == lighting::Distribution::ggx) {
            add_choice(subject, "material", m, "geometry", of);
        }
        add_choice(subject, "material", m, "energy_compensation", of);
    }
    if (!any_microfacet) {
        prune(subject, "Fresnel, masking, multiple scattering", "nothing seen and lit is cook_torrance");
    }
}

/// Materials that stand in the file itself can be named by number; those of an OBJ cannot.
bool all_in_file(const SceneSource& source, const scene::Scene& scene) {
    const scene::Value root = scene::parse_toml(source.text, source.name);
    const scene::Value* materials = find(root, "material");
    return materials && materials->items.size() == scene.materials.size();
}

}  // namespace

SceneTerms terms_of(const SceneSource& source, const std::set<std::string>& kept) {
    scene::Scene scene = read_with(source, {});
    scene::RenderPlan plan = make_plan(scene);
    std::vector<bool> visible = visible_materials(scene);
    Subject subject{source, kept, std::move(scene), std::move(plan), std::move(visible)};
    add_picture_terms(subject);
    add_shadow_term(subject);
    add_environment_term(subject);
    add_fog_terms(subject);
    if (all_in_file(source, subject.scene)) {
        add_material_terms(subject);
    } else {
        prune(subject, "materials", "some are not in the scene file itself");
    }
    return std::move(subject.found);
}

std::vector<Setting> settings_of(const std::vector<Term>& terms, const std::vector<int>& chosen) {
    KREDA_EXPECT(terms.size() == chosen.size());
    std::vector<Setting> settings;
    for (std::size_t t = 0; t < terms.size(); ++t) {
        const std::vector<Setting>& more = terms[t].options[static_cast<std::size_t>(chosen[t])].settings;
        settings.insert(settings.end(), more.begin(), more.end());
    }
    return settings;
}

}  // namespace kreda::tools
