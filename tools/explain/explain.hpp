// The life of a pixel as a derivation, from the plan to the byte in the PNG.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/render/frame.hpp"
#include "scene/render/tile_pass.hpp"
#include "tools/explain/derivation.hpp"
#include "tools/explain/probe.hpp"

namespace kreda::tools {

/// Which pixel, and with several samples a pixel which of them is told in full.
struct PixelRequest {
    int x = 0, y = 0;  ///< pixel, (0, 0) is the upper left one
    int sample_x = -1,
        sample_y = -1;  ///< 0 .. samples - 1 within the pixel; -1: the first covered one, from the middle
};

struct Explanation {
    Derivation derivation;
    bool covered = false;                ///< a triangle is seen at the sample that was told in full
    glm::vec3 radiance{0.0f};            ///< of the pixel, linear RGB: what the film holds
    std::array<std::uint8_t, 3> byte{};  ///< what the PNG holds
};

/// Throws UserError for a pixel or sample outside the picture.
void check_request(const scene::ImageSettings& image, const PixelRequest& request);

/// Draw the scene and follow one of its pixels. threads: 0 for one a core. Throws UserError for a pixel outside the
/// picture.
[[nodiscard]] Explanation explain_pixel(const scene::Scene& scene, const PixelRequest& request, int threads = 0);

/// A triangle's corners in formulas.
inline constexpr const char* kCornerNames[3] = {"a", "b", "c"};

/// One sample of the frame, worked on again alone: a batch of one.
struct SampleFacts {
    const scene::Frame& frame;
    int x = 0, y = 0;                            ///< on the sample grid
    std::vector<Cover> covers;                   ///< in drawing order
    int nearest = -1;                            ///< of covers
    std::unique_ptr<scene::TileScratch> passes;  ///< what the passes left; only where a triangle is seen
    glm::vec3 radiance{0.0f};                    ///< fog included, or the background

    [[nodiscard]] const Cover& seen() const {
        return covers[static_cast<std::size_t>(nearest)];
    }
};
[[nodiscard]] SampleFacts look_at_sample(const scene::Frame& frame, int x, int y);

/// Where a sample that nothing covers has its colour from.
void explain_background_color(const SampleFacts& sample, Section& section);

/// "object 2 (teapot), part 0 \"lid\", triangle 17"
[[nodiscard]] std::string triangle_text(const scene::Frame& frame, const SourceTriangle& source);

// The chapters. Each appends its sections.
void explain_triangle(const SampleFacts& sample, Derivation& derivation);
void explain_coverage(const SampleFacts& sample, Derivation& derivation);
void explain_depth(const SampleFacts& sample, Derivation& derivation);
void explain_interpolation(const SampleFacts& sample, Derivation& derivation);
void explain_shading(const SampleFacts& sample, Derivation& derivation);
void explain_fog(const SampleFacts& sample, Derivation& derivation);
void explain_channels(const SampleFacts& sample, Derivation& derivation);
void explain_absence(const SampleFacts& sample, Derivation& derivation);

/// From the samples' radiance to the byte.
void explain_film(const scene::ImageSettings& image, const std::vector<glm::vec3>& samples, Explanation& explanation);

}  // namespace kreda::tools
