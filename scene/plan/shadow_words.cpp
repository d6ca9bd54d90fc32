#include "scene/plan/shadow_words.hpp"

#include "scene/plan/plan_cost.hpp"
#include "scene/plan/shadow_cost.hpp"
#include "shadows/bvh.hpp"
#include "shadows/irregular.hpp"
#include "shadows/volume.hpp"

namespace kreda::scene {

namespace {

using shadows::ShadowMethod;

std::string count_of(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::uint64_t vertices_of(const Scene& scene, const std::vector<int>& objects) {
    std::uint64_t count = 0;
    for (const int object : objects) count += scene.objects[static_cast<std::size_t>(object)].mesh->positions.size();
    return count;
}

std::uint64_t triangles_of(const Scene& scene, const std::vector<int>& objects) {
    std::uint64_t count = 0;
    for (const int object : objects) count += scene.objects[static_cast<std::size_t>(object)].mesh->triangle_count();
    return count;
}

/// The words and the memory of one method.
struct Account {
    std::string name, how;
    std::vector<PlannedBuffer> buffers;
};

Account account_of_map(const PlannedShadow& shadow) {
    const std::uint64_t side = static_cast<std::uint64_t>(shadow.map.settings.size) + 2;
    const std::uint64_t faces = shadow.map.views.size();
    const std::string texels = std::to_string(side - 2) + " x " + std::to_string(side - 2) + " texels";
    return {"shadow map",
            (faces == 1 ? "one picture" : "six pictures") + std::string(" of ") + texels,
            {{"distances", faces * side * side * sizeof(float)}}};
}

/// Methods that look at all visible samples first keep a factor for each.
Account account_of_frame(std::string name, std::string how, std::uint64_t samples) {
    return {std::move(name), std::move(how), {{"factors", samples * sizeof(float)}}};
}

Account account_of(const Scene& scene, const PlannedShadow& shadow, std::uint64_t samples) {
    const std::uint64_t triangles = triangles_of(scene, shadow.casters);
    switch (shadow.map.settings.method) {
        case ShadowMethod::map: return account_of_map(shadow);
        case ShadowMethod::exact:
            return {"shadow rays",
                    "one from every point, against a tree of " + count_of(triangles, "triangle"),
                    {{"tree, at most", triangles * (2 * sizeof(shadows::BvhNode) + sizeof(shadows::Triangle))},
                     {"boxes of its triangles, while it runs", shadows::bytes_to_build_bvh(triangles)}}};
        case ShadowMethod::planar:
            return account_of_frame("planar shadow", "onto " + count_of(shadow.receivers.size(), "flat object"),
                                    samples);
        case ShadowMethod::volume: {
            Account account = account_of_frame("shadow volumes", "behind " + count_of(triangles, "triangle"), samples);
            account.buffers.push_back(
                {"counters and faces, at most, while it runs",
                 shadows::bytes_to_count_volumes(samples, vertices_of(scene, shadow.casters), triangles)});
            return account;
        }
        case ShadowMethod::irregular: {
            Account account = account_of_frame("irregular z-buffer", "of all visible samples", samples);
            account.buffers.push_back(
                {"points, cells and triangles, while it runs", shadows::bytes_to_draw_irregular(samples, triangles)});
            return account;
        }
    }
    return {};
}

}  // namespace

std::uint64_t bytes_to_draw(const Scene& scene, const PlannedShadow& shadow) {
    if (shadow.map.settings.method != ShadowMethod::map) return 0;
    return vertices_of(scene, shadow.casters) * sizeof(raster::ScreenVertex) +
           triangles_of(scene, shadow.casters) * kTriangleBytes;
}

PlannedPass pass_of(const Scene& scene, const PlannedShadow& shadow, const raster::Viewport& viewport) {
    const std::uint64_t samples =
        static_cast<std::uint64_t>(viewport.width) * static_cast<std::uint64_t>(viewport.height);
    Account account = account_of(scene, shadow, samples);
    return {account.name + " of light " + std::to_string(shadow.light),
            "shadow = true: " + std::to_string(shadow.casters.size()) + " of " + std::to_string(scene.objects.size()) +
                " objects can cast onto what is seen; " + account.how,
            std::move(account.buffers), shadow_pass_cost(scene, shadow, samples), PassScope::frame};
}

}  // namespace kreda::scene
