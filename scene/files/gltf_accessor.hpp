// The numbers of a glTF file: accessors, checked against the bytes that are really there.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/files/gltf_model.hpp"

namespace kreda::scene {

/// How many elements an accessor has. Throws UserError when there is no such accessor; `what` names who asks for it.
[[nodiscard]] std::size_t element_count(const GltfFile& gltf, int accessor, const std::string& what);

/// The elements of an accessor, `components` floats each, one after another. Normalized integers become 0..1 or -1..1,
/// others their value; sparse values are put in. NaN and infinity stay. Throws UserError at the accessor.
[[nodiscard]] std::vector<float> read_floats(const GltfFile& gltf, int accessor, int components,
                                             const std::string& what);

/// The same for an accessor of scalar unsigned integers.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const GltfFile& gltf, int accessor, const std::string& what);

/// The bytes of a buffer view. Throws UserError.
[[nodiscard]] std::span<const unsigned char> bytes_of_view(const GltfFile& gltf, int view, const std::string& what);

}  // namespace kreda::scene
