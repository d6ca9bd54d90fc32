// The numbers of a view as a picture.
#include <cmath>
#include <limits>

#include "raster/film.hpp"
#include "scene/plan/views.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

namespace {

/// Range of the values that are not background.
ValueRange range_of(const float* values, std::size_t count, float background) {
    ValueRange found{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
    for (std::size_t i = 0; i < count; ++i) {
        if (values[i] == background || !std::isfinite(values[i])) continue;
        found.least = std::min(found.least, values[i]);
        found.greatest = std::max(found.greatest, values[i]);
    }
    return found.least <= found.greatest ? found : ValueRange{background, background};
}

float in_range(float x, const ValueRange& range) {
    const float width = range.greatest - range.least;
    return width > 0.0f ? raster::saturate((x - range.least) / width) : 0.5f;
}

template <class Map>
raster::Image map_values(const raster::Image& values, Map map) {
    raster::Image result = values;
    for (int c = 0; c < values.channels; ++c) {
        float* plane = result.plane(c);
        for (std::size_t i = 0; i < result.plane_size(); ++i) plane[i] = map(plane[i], c);
    }
    return result;
}

}  // namespace

ViewPicture picture_of(const View& view, const raster::Image& values, const Scene& scene) {
    switch (view.scale) {
        case ViewScale::radiance: return {develop(values, film_settings(scene.image)), {}};
        case ViewScale::color: return {develop(values, {}), {}};
        case ViewScale::share: return {map_values(values, [](float x, int) { return raster::saturate(x); }), {}};
        case ViewScale::direction:
            return {map_values(values, [](float x, int) { return raster::saturate(0.5f * x + 0.5f); }), {}};
        case ViewScale::range: break;
    }
    ViewPicture picture;
    for (int c = 0; c < values.channels; ++c) {
        picture.ranges.push_back(range_of(values.plane(c), values.plane_size(), view.background));
    }
    picture.encoded = map_values(values, [&](float x, int c) {
        return x == view.background ? raster::saturate(x) : in_range(x, picture.ranges[static_cast<std::size_t>(c)]);
    });
    return picture;
}

}  // namespace kreda::scene
