// What the terms of a scene are made from: inside of tools/tune, for terms.cpp and the files beside it.
#pragma once

#include "scene/plan/plan.hpp"
#include "tools/measure/choices.hpp"
#include "tools/tune/terms.hpp"

namespace kreda::tools {

/// What all terms are made from.
struct TermSubject {
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

/// A term that is left alone, and why.
void prune(TermSubject& subject, const std::string& name, const std::string& why);

/// Adds the option unless it is there or refused.
void add_option(const TermSubject& subject, Term& term, const TermOption& option);

/// A term of all options and these two; left out where there is nothing to choose.
void add_term(TermSubject& subject, Term term, const TermOption& own, const TermOption& oracle);

/// That option holds while other terms are measured, if the term has it.
void set_base(Term& term, const TermOption& option);

/// Kept because the user says so; then it is pruned.
[[nodiscard]] bool is_kept(TermSubject& subject, const std::string& table, const std::string& key,
                           const std::string& name);

/// The term of a row of the registry, value by value.
void add_choice(TermSubject& subject, const std::string& table, int which, const std::string& key,
                const std::string& of = "", TermKind kind = TermKind::added);

// terms_of_light.cpp
void add_shadow_term(TermSubject& subject);
void add_environment_term(TermSubject& subject);
void add_fog_terms(TermSubject& subject);
// terms_of_materials.cpp
void add_material_terms(TermSubject& subject);

}  // namespace kreda::tools
