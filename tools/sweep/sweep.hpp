// Many pictures of one scene: every value of one or two keys.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/plan/views.hpp"
#include "tools/kept_frames.hpp"
#include "tools/scene_options.hpp"

namespace kreda::tools {

/// Draws one picture after another. What a value does not touch is kept from picture to picture.
class SweepRenderer {
public:
    SweepRenderer(SceneOptions scene, CacheOptions cache, const scene::View* view, int threads)
        : options_(std::move(scene)), cache_(std::move(cache)), view_(view), threads_(threads) {}

    /// The scene with these values besides those of the command line; encoded for a PNG, three channels. Throws
    /// UserError. What the scene warns of is said once.
    [[nodiscard]] raster::Image draw(const std::vector<std::string>& values);

    /// The size that the scene gives its picture.
    [[nodiscard]] glm::ivec2 picture_size();

    void set_size(glm::ivec2 size);

private:
    SceneOptions options_;
    CacheOptions cache_;
    const scene::View* view_;
    int threads_;
    std::unique_ptr<KeptFrames> kept_ = std::make_unique<KeptFrames>();
};

/// How far two encoded pictures of one size are apart, in codes of 8 bits over all three channels.
struct PictureError {
    double mean = 0.0;
    int worst = 0;
};
[[nodiscard]] PictureError picture_error(const raster::Image& actual, const raster::Image& expected);

/// 128 where both are the same, else 128 + 4 (actual - expected) codes.
[[nodiscard]] raster::Image picture_difference(const raster::Image& actual, const raster::Image& expected);

}  // namespace kreda::tools
