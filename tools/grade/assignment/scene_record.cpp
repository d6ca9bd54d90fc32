#include "tools/grade/assignment/scene_record.hpp"

#include "scene/render/render.hpp"

namespace kreda::tools {

namespace {

SeenPoint seen_point(const scene::Frame& frame, glm::ivec2 pixel, const Cover& cover) {
    const raster::VertexStreams& streams = frame.buffers.streams;
    SeenPoint point{pixel, cover, find_source(frame.buffers.instances, cover.triangle.source)};
    point.weights = corner_weights_at(streams, cover.triangle, pixel.x, pixel.y, frame.plan.interpolation);
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t vertex = cover.triangle.vertex[static_cast<std::size_t>(i)];
        point.position += point.weights[i] * streams.position_world[vertex];
        point.normal += point.weights[i] * streams.normal_world[vertex];
    }
    if (frame.plan.two_sided && cover.triangle.behind) point.normal = -point.normal;
    return point;
}

void look_at_pixels(SceneRecord& record) {
    const scene::Frame& frame = record.frame;
    const raster::Viewport& viewport = frame.plan.viewport;
    record.covers = triangles_over_all(frame.buffers.streams, frame.buffers.triangles, viewport.width, viewport.height);
    for (int y = 0, i = 0; y < viewport.height; ++y) {
        for (int x = 0; x < viewport.width; ++x, ++i) {
            const std::vector<Cover>& covers = record.covers[static_cast<std::size_t>(i)];
            const int nearest = nearest_of(covers);
            if (nearest < 0) continue;
            const Cover& cover = covers[static_cast<std::size_t>(nearest)];
            record.points.push_back(seen_point(frame, {x, y}, cover));
        }
    }
}

}  // namespace

raster::Image record_scene(const scene::Scene& scene, const std::string& name,
                           const std::function<void(const SceneRecord&)>& look) {
    scene::RenderPlan plan = make_plan(scene);
    plan.vertex.position_world = true;
    plan.vertex.normal_world = true;
    scene::RenderBuffers buffers;
    render(scene, plan, buffers, 1, [&](const scene::Frame& frame) {
        SceneRecord record{name, frame, {}, {}};
        look_at_pixels(record);
        look(record);
    });
    return buffers.film;
}

std::vector<SeenPoint> some_points(const SceneRecord& record, std::size_t most) {
    const std::size_t step = record.points.size() / most + 1;
    std::vector<SeenPoint> some;
    for (std::size_t i = step / 2; i < record.points.size(); i += step) some.push_back(record.points[i]);
    return some;
}

}  // namespace kreda::tools
