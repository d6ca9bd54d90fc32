// Terms of the scene's materials.
#include "tools/tune/term_subject.hpp"

namespace kreda::tools {

namespace {

void add_fresnel_term(TermSubject& subject, int m, const std::string& of) {
    if (is_kept(subject, "material", "fresnel", "Fresnel" + of)) return;
    const Choice& methods = *find_choice("material", "fresnel");
    const auto option = [&](const std::string& method) {
        return TermOption{method, {{"material", m, "fresnel", method}}};
    };
    Term term{"Fresnel" + of, TermKind::added, {}, 0, 0};
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

}  // namespace

void add_material_terms(TermSubject& subject) {
    const bool lit = subject.plan.has_lights || subject.plan.lit_by_environment;
    bool any_microfacet = false;
    for (std::size_t i = 0; i < subject.scene.materials.size(); ++i) {
        const lighting::Material& material = subject.scene.materials[i];
        const int m = static_cast<int>(i);
        const std::string of = " of " + material.name;
        if (!subject.visible[i]) continue;
        const auto& setup = subject.plan.materials[i];
        if (setup.map_needs.uv) add_choice(subject, "material", m, "texture_filter", of);
        if (material.model != lighting::ReflectionModel::cook_torrance || !lit) continue;
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

}  // namespace kreda::tools
