// Views: every named quantity of the pipeline that can be looked at as a picture. A view is no shader of its own: it is
// a channel that a pass wrote anyway. Whoever adds a channel adds its view to the table in views.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lighting/batch/channels.hpp"
#include "raster/fragments.hpp"
#include "raster/image.hpp"
#include "scene/plan/wanted.hpp"

namespace kreda::scene {

struct RenderPlan;
struct Scene;

/// How the numbers of a view become what a PNG shows. An EXR holds the numbers themselves.
enum class ViewScale {
    radiance,   ///< light: exposure, tone map and transfer function of the scene
    color,      ///< a reflectance, 0..1: encoded as sRGB
    share,      ///< a number of 0..1: byte = 255 x
    direction,  ///< a unit vector: byte = 255 (x + 1) / 2, as normal maps are written
    range,      ///< any number: black is the least, white the greatest of the picture, channel by channel
};

/// What the passes left behind for one batch of points.
struct BatchChannels {
    const raster::Fragments& points;
    const lighting::LightingChannels& lighting;
};

struct View {
    std::string_view name;
    std::string_view meaning;
    std::string_view requires_what;  ///< what a scene must have for it, in words
    int components = 1;              ///< 1 or 3
    ViewScale scale = ViewScale::share;
    raster::FragmentNeeds needs;  ///< attributes that must be interpolated for it
    Wanted wanted;                ///< what must be computed for it
    /// Do the passes of this plan write it for points of this material (an index into plan.materials)?
    bool (*holds)(const RenderPlan& plan, std::uint32_t material) = nullptr;
    /// Its value at point i of the batch. nullptr: the depth buffer, which is no channel of a batch.
    float (*value)(const BatchChannels& batch, int i, int component) = nullptr;
    float background = 0.0f;  ///< its value where nothing is seen
};

/// All views, in the order of the pipeline.
[[nodiscard]] const std::vector<View>& all_views();

/// The view of that name, or nullptr.
[[nodiscard]] const View* find_view(std::string_view name);

/// Least and greatest value of a channel over the whole picture; where nothing is seen does not count.
struct ValueRange {
    float least = 0.0f;
    float greatest = 0.0f;
};

/// The picture of a view, ready to be written as a PNG, and for ViewScale::range the range of each channel.
struct ViewPicture {
    raster::Image encoded;
    std::vector<ValueRange> ranges;
};
[[nodiscard]] ViewPicture picture_of(const View& view, const raster::Image& values, const Scene& scene);

}  // namespace kreda::scene
