// A pass as data: what it is called, why it runs, what it writes, what it costs, and the function that runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kreda::scene {

struct PassWork;

/// Memory that a pass writes. Buffers of one tile or batch exist once a thread.
struct PlannedBuffer {
    std::string name;
    std::uint64_t bytes = 0;
};

/// What a pass does at most, estimated from counts: see plan_cost.hpp.
struct PassCost {
    std::string items;  ///< "vertices", "samples"; empty: not estimated
    std::uint64_t count = 0;
    double operations_each = 0.0;

    [[nodiscard]] double operations() const {
        return static_cast<double>(count) * operations_each;
    }
};

/// How often a pass runs.
enum class PassScope {
    once,    ///< baking: kept for all frames
    frame,   ///< once a frame
    tile,    ///< for every tile of the picture
    batch,   ///< for every batch of visible samples of a tile
    points,  ///< for every batch of points that the pass before it lights: samples, vertices or triangles
};

/// The renderer walks a list of these (scene/render/walk_passes.hpp); nothing else runs.
struct PlannedPass {
    std::string name;    ///< one of its kind in a plan
    std::string reason;  ///< what in the scene asks for it
    std::vector<PlannedBuffer> buffers;
    PassCost cost;
    PassScope scope = PassScope::frame;
    void (*run)(const PassWork& work) = nullptr;
    int index = -1;          ///< which light that is on, shadow, view or material it is about
    std::string bound = {};  ///< why it may run and change nothing: what is not known before; empty: it does not
    std::vector<bool> materials = {};  ///< those whose batches it works on, by number; empty: all
    std::string inputs = {};  ///< all that it reads, where what it leaves can be kept for the next frame; else empty
};

/// Does the pass work on batches of this material?
[[nodiscard]] inline bool works_on(const PlannedPass& pass, std::uint32_t material) {
    return pass.materials.empty() || pass.materials[material];
}

/// A pass that this scene does not need, and what would need it.
struct LeftOutPass {
    std::string name;
    std::string why_not;
};

}  // namespace kreda::scene
