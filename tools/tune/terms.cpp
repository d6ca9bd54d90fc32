#include "tools/tune/terms.hpp"

#include <algorithm>

#include "raster/platform.hpp"
#include "raster/shapes.hpp"
#include "scene/map_meshes.hpp"
#include "tools/tune/term_subject.hpp"

namespace kreda::tools {

namespace {

int index_of(const Term& term, const TermOption& option) {
    for (std::size_t i = 0; i < term.options.size(); ++i) {
        if (term.options[i].settings == option.settings) return static_cast<int>(i);
    }
    return -1;
}

}  // namespace

void prune(TermSubject& subject, const std::string& name, const std::string& why) {
    subject.found.pruned.push_back({name, why});
}

void add_option(const TermSubject& subject, Term& term, const TermOption& option) {
    if (index_of(term, option) < 0 && subject.is_accepted(option)) term.options.push_back(option);
}

void add_term(TermSubject& subject, Term term, const TermOption& own, const TermOption& oracle) {
    add_option(subject, term, own);
    add_option(subject, term, oracle);
    term.own = index_of(term, own);
    term.oracle = index_of(term, oracle);
    term.base = term.own;
    if (term.own < 0 || term.oracle < 0) return prune(subject, term.name, "its oracle is refused with this scene");
    if (term.options.size() < 2) return prune(subject, term.name, "there is one way alone");
    subject.found.terms.push_back(std::move(term));
}

void set_base(Term& term, const TermOption& option) {
    const int base = index_of(term, option);
    if (base >= 0) term.base = base;
}

bool is_kept(TermSubject& subject, const std::string& table, const std::string& key, const std::string& name) {
    const bool kept = subject.kept.contains(table + "." + key);
    if (kept) prune(subject, name, "kept as the scene has it");
    return kept;
}

void add_choice(TermSubject& subject, const std::string& table, int which, const std::string& key,
                const std::string& of, TermKind kind) {
    const Choice* choice = find_choice(table, key);
    KREDA_EXPECT(choice != nullptr);
    const std::string name = std::string(choice->name) + of;
    if (is_kept(subject, table, key, name)) return;
    if (choice->oracle.empty()) return prune(subject, name, "no oracle: " + std::string(choice->why_oracle));
    const auto option = [&](const std::string& value) { return TermOption{value, {{table, which, key, value}}}; };
    Term term{name, kind, {}, 0, 0};
    for (const std::string& value : choice->values) add_option(subject, term, option(value));
    add_term(subject, std::move(term), option(subject.own(table, which, key)), option(choice->oracle));
}

namespace {

bool is_round(const std::string& shape) {
    return shape != "cube" && shape != "plane" && raster::default_detail(shape).has_value();
}

/// All built-in round shapes together, by factors of the detail that they have.
void add_tessellation(TermSubject& subject) {
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
    Term term{"tessellation", TermKind::structural, {}, 0, 0};
    add_option(subject, term, option(0.25, "a quarter"));
    add_option(subject, term, option(0.5, "half"));
    add_term(subject, std::move(term), option(1.0, "as it is"), option(2.0, "double"));
}

/// More samples than this are not taken even for the truth: they would not fit into the memory of a small machine.
constexpr std::int64_t kMostSamples = std::int64_t(1) << 25;

void add_supersampling(TermSubject& subject) {
    const Choice& choice = *find_choice("image", "samples");
    const std::string name(choice.name);
    if (is_kept(subject, "image", "samples", name)) return;
    const auto option = [](int n) {
        return TermOption{std::to_string(n), {{"image", -1, "samples", std::to_string(n)}}};
    };
    const scene::ImageSettings& image = subject.scene.image;
    Term term{name, TermKind::structural, {}, 0, 0};
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

void add_picture_terms(TermSubject& subject) {
    add_supersampling(subject);
    const bool lit = subject.plan.has_lights || subject.plan.lit_by_environment;
    if (lit) add_choice(subject, "shading", -1, "frequency", "", TermKind::structural);
    if (lit) add_choice(subject, "shading", -1, "rate");
    if (!lit) prune(subject, "shading frequency", "nothing is lit");
    if (subject.scene.camera.projection == raster::Projection::orthographic) {
        prune(subject, "interpolation", "parallel rays: with and without perspective are the same");
    } else {
        add_choice(subject, "shading", -1, "interpolation");
    }
    prune(subject, "transfer function", "takes the same time whatever it is");
    add_tessellation(subject);
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
    TermSubject subject{source, kept, std::move(scene), std::move(plan), std::move(visible)};
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

bool is_samples(const Term& term) {
    const Setting& first = term.options.front().settings.front();
    return first.table == "image" && first.key == "samples";
}

namespace {

std::vector<int> of_each(const std::vector<Term>& terms, int Term::*option) {
    std::vector<int> chosen;
    for (const Term& term : terms) chosen.push_back(term.*option);
    return chosen;
}

}  // namespace

std::vector<int> oracles(const std::vector<Term>& terms) {
    return of_each(terms, &Term::oracle);
}

std::vector<int> owns(const std::vector<Term>& terms) {
    return of_each(terms, &Term::own);
}

std::vector<int> bases(const std::vector<Term>& terms) {
    return of_each(terms, &Term::base);
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
