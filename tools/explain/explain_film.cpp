// Explain, the end: the mean of the samples, exposure, tone map, transfer function, the byte in the PNG.
#include <functional>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "tools/explain/explain.hpp"

namespace kreda::tools {

namespace {

using raster::FilmSettings;

glm::vec3 each(const glm::vec3& v, float (*formula)(float, const FilmSettings&), const FilmSettings& settings) {
    return {formula(v.x, settings), formula(v.y, settings), formula(v.z, settings)};
}

/// The film's mean: row by row, left to right, in the order of the real film.
glm::vec3 mean_of(const std::vector<glm::vec3>& samples) {
    if (samples.size() == 1) return samples[0];
    glm::vec3 sum{0.0f};
    for (const glm::vec3& sample : samples) sum += sample;
    return sum / static_cast<float>(samples.size());
}

/// "(a, b, c)" of three texts.
std::string texts_of(const glm::vec3& v, const std::function<std::string(const std::string&)>& text) {
    return "(" + text(number_text(v.x)) + ", " + text(number_text(v.y)) + ", " + text(number_text(v.z)) + ")";
}

void explain_tone_map(const FilmSettings& settings, const glm::vec3& exposed, Section& section) {
    const glm::vec3 x = glm::max(exposed, glm::vec3(0.0f));
    if (x != exposed) section.equation("exposed", "max(exposed, 0)", "", x);
    const std::string white = number_text(settings.white);
    switch (settings.tone_map) {
        case raster::ToneMap::none: return section.equation("mapped", "exposed", "", x, "image.tone_map = \"none\"");
        case raster::ToneMap::reinhard:
            return section.equation("mapped", "exposed / (1 + exposed)",
                                    texts_of(x, [](const std::string& e) { return e + " / (1 + " + e + ")"; }),
                                    each(
                                        x, [](float L, const FilmSettings&) { return raster::reinhard(L); }, settings),
                                    "Reinhard");
        case raster::ToneMap::reinhard_extended:
            section.equation("white", "", "", settings.white, "image.white: maps to 1");
            return section.equation(
                "mapped", "exposed (1 + exposed/white²) / (1 + exposed)",
                texts_of(x,
                         [&](const std::string& e) { return e + " (1 + " + e + "/" + white + "²) / (1 + " + e + ")"; }),
                each(
                    x, [](float L, const FilmSettings& s) { return raster::reinhard_extended(L, s.white); }, settings),
                "Reinhard, extended");
    }
}

std::string transfer_formula(const FilmSettings& settings) {
    switch (settings.transfer) {
        case raster::Transfer::srgb: return "12.92 x below 0.0031308, else 1.055 x^(1/2.4) - 0.055";
        case raster::Transfer::gamma: return "x^(1/" + number_text(settings.gamma) + ")";
        case raster::Transfer::linear: return "x";
    }
    return "";
}

}  // namespace

void explain_film(const scene::ImageSettings& image, const std::vector<glm::vec3>& samples, Explanation& explanation) {
    const FilmSettings settings = film_settings(image);
    Section section{"film", "to the film and into the PNG", {}};
    explanation.radiance = mean_of(samples);
    const std::string formula = samples.size() == 1 ? "" : "mean of " + std::to_string(samples.size()) + " samples";
    section.equation("L", formula, "", explanation.radiance, "radiance on the film, linear RGB; an EXR holds this");
    const glm::vec3 exposed = explanation.radiance * settings.exposure;
    section.equation("exposed", "exposure L",
                     number_text(settings.exposure) + " · " + vector_text(explanation.radiance), exposed);
    explain_tone_map(settings, exposed, section);
    const glm::vec3 encoded = each(explanation.radiance, raster::display_value, settings);
    section.equation("encoded", transfer_formula(settings), "", encoded, "x = mapped, cut off at 0 and 1");
    std::vector<double> bytes;
    for (int c = 0; c < 3; ++c) {
        explanation.byte[static_cast<std::size_t>(c)] = scene::byte_from_encoded(encoded[c]);
        bytes.push_back(explanation.byte[static_cast<std::size_t>(c)]);
    }
    section.equation("byte", "round(255 encoded)", "round(255 · " + vector_text(encoded) + ")", bytes, "in the PNG");
    explanation.derivation.sections.push_back(section);
}

}  // namespace kreda::tools
