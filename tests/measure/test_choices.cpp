// The registry of choices is the table of the scene file's keys, seen from another side.
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "lighting/microfacet_choices.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/files/scene_keys.hpp"
#include "tools/measure/choices.hpp"

using namespace kreda;
using tools::Choice;

namespace {

/// A scene in which every choice can be made.
constexpr const char* kEverything = R"(
[shadow]
method = "map"
[environment]
sky = "gradient"
[fog]
mode = "exp"
[[light]]
shadow = true
[[material]]
name = "metal"
model = "cook_torrance"
metallic = 1
measured = "gold"
spectrum = "three"
[[object]]
mesh = "sphere"
material = "metal"
)";

scene::Scene read_with(const Choice& choice, const std::string& value) {
    const bool repeated = scene::is_repeated(choice.table);
    const std::string set =
        std::string(choice.table) + (repeated ? ".0." : ".") + std::string(choice.key) + "=" + value;
    return scene::read_scene_text(kEverything, "everything", "", {.overrides = {set}});
}

/// Keys whose words say what a scene is, not how it is computed.
const std::set<std::string> kNoChoices = {"image.background",      "image.tone_map",    "camera.projection",
                                          "shading.cull",          "light.type",        "light.attenuation",
                                          "shadow.cull",           "fog.mode",          "environment.sky",
                                          "material.model",        "material.measured", "material.normal_map_y",
                                          "material.texture_wrap", "object.normals"};

}  // namespace

TEST_CASE("choices: the scene reader accepts every value of every choice") {
    for (const Choice& choice : tools::choices()) {
        for (const std::string& value : choice.values) {
            CAPTURE(key_of(choice));
            CAPTURE(value);
            CHECK_NOTHROW((void)read_with(choice, value));
        }
    }
}

TEST_CASE("choices: every key of words is a choice or known to be none") {
    for (const scene::KeyInfo& key : scene::scene_keys()) {
        if (key.words.empty()) continue;
        const std::string name = std::string(key.table) + "." + std::string(key.key);
        CAPTURE(name);
        CHECK((tools::find_choice(key.table, key.key) != nullptr) != kNoChoices.contains(name));
    }
}

TEST_CASE("choices: a choice of words has every word and an oracle is one of the values") {
    for (const Choice& choice : tools::choices()) {
        CAPTURE(key_of(choice));
        const scene::KeyInfo* key = scene::find_key(choice.table, choice.key);
        REQUIRE(key != nullptr);
        if (!key->words.empty()) {
            CHECK(choice.values == std::vector<std::string>(key->words.begin(), key->words.end()));
        }
        const bool is_value =
            std::find(choice.values.begin(), choice.values.end(), choice.oracle) != choice.values.end();
        CHECK((choice.oracle.empty() || is_value));
    }
}

TEST_CASE("choices: the enumerators of D and V and F are all reached by a word") {
    const auto reached = [](const char* key, auto member) {
        std::set<int> values;
        for (const std::string& word : tools::find_choice("material", key)->values) {
            values.insert(static_cast<int>(
                read_with(*tools::find_choice("material", key), word).materials[0].cook_torrance.*member));
        }
        return values.size();
    };
    CHECK(reached("fresnel", &lighting::CookTorranceMaterial::fresnel) == lighting::kFresnelMethods.size());
    CHECK(reached("geometry", &lighting::CookTorranceMaterial::geometry) == lighting::kGeometries.size());
    CHECK(reached("distribution", &lighting::CookTorranceMaterial::distribution) == lighting::kDistributions.size());
}
