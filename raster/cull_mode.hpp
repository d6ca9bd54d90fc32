// Which side of a triangle is left out.
#pragma once

namespace kreda::raster {

/// Which side of a triangle is not drawn; the front is the one from which its corners go round counter-clockwise.
enum class CullMode { back, front, none };

/// For a mesh whose transform mirrors: it turns counter-clockwise into clockwise, and what was the back is the front.
[[nodiscard]] inline CullMode cull_mode_for(CullMode cull, bool mirrored) {
    if (!mirrored || cull == CullMode::none) return cull;
    return cull == CullMode::back ? CullMode::front : CullMode::back;
}

}  // namespace kreda::raster
