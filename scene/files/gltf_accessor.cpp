#include "scene/files/gltf_accessor.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace kreda::scene {

namespace {

static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

/// An accessor of zeros needs no bytes in the file: without this it could ask for any memory.
constexpr std::size_t kMostWithoutBytes = std::size_t(1) << 24;

/// Elements that stand in a buffer at even distances.
struct Strided {
    const unsigned char* first = nullptr;
    std::size_t stride = 0;
    std::size_t count = 0;
};

const tinygltf::Accessor& accessor_at(const GltfFile& gltf, int index, const std::string& what) {
    if (has_element(gltf.model.accessors, index)) return gltf.model.accessors[static_cast<std::size_t>(index)];
    throw UserError(Place{gltf.text.json.file}, what + " names accessor " + std::to_string(index) + " of " +
                                                    std::to_string(gltf.model.accessors.size()));
}

UserError accessor_error(const GltfFile& gltf, int accessor, const std::string& what, const std::string& message) {
    return gltf_error(gltf.text, "accessors", static_cast<std::size_t>(accessor), message + " (" + what + ")");
}

std::size_t size_of_component(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT: return 4;
        default: return 0;
    }
}

template <class Number>
Number gltf_number_at(const unsigned char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

/// Integers as shares:   unsigned c / most;   signed max(c / most, -1).      glTF 2.0 specification, section 3.6.2.2
float component_at(const unsigned char* bytes, int type, bool normalized) {
    const auto share = [&](float c, float most) { return normalized ? std::max(c / most, -1.0f) : c; };
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: return share(gltf_number_at<std::int8_t>(bytes), 127.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return share(gltf_number_at<std::uint8_t>(bytes), 255.0f);
        case TINYGLTF_COMPONENT_TYPE_SHORT: return share(gltf_number_at<std::int16_t>(bytes), 32767.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return share(gltf_number_at<std::uint16_t>(bytes), 65535.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return static_cast<float>(gltf_number_at<std::uint32_t>(bytes));
        default: return gltf_number_at<float>(bytes);
    }
}

std::uint32_t index_at(const unsigned char* bytes, int type) {
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return gltf_number_at<std::uint8_t>(bytes);
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return gltf_number_at<std::uint16_t>(bytes);
    return gltf_number_at<std::uint32_t>(bytes);
}

bool is_index_type(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// `count` elements of a view from `offset`; no sum here can overflow.
Strided elements_of(const GltfFile& gltf, int accessor, int view, std::size_t offset, std::size_t count,
                    std::size_t element_bytes, const std::string& what) {
    const std::span<const unsigned char> bytes = bytes_of_view(gltf, view, what);
    const std::size_t given = gltf.model.bufferViews[static_cast<std::size_t>(view)].byteStride;
    const std::size_t stride = given == 0 ? element_bytes : given;
    const bool is_inside = offset <= bytes.size() && element_bytes <= bytes.size() - offset && count > 0 &&
                           (count - 1) <= (bytes.size() - offset - element_bytes) / stride;
    if (is_inside) return {bytes.data() + offset, stride, count};
    throw accessor_error(gltf, accessor, what,
                         std::to_string(count) + " elements of " + std::to_string(element_bytes) + " bytes from byte " +
                             std::to_string(offset) + " on do not lie in the " + std::to_string(bytes.size()) +
                             " bytes of bufferView " + std::to_string(view));
}

/// Calls put(index, bytes) for each element that replaces another.
template <class Put>
void for_each_sparse(const GltfFile& gltf, int index, std::size_t element_bytes, const std::string& what, Put put) {
    const tinygltf::Accessor& accessor = gltf.model.accessors[static_cast<std::size_t>(index)];
    if (!accessor.sparse.isSparse) return;
    const auto& sparse = accessor.sparse;
    const bool is_possible = sparse.count > 0 && sparse.indices.byteOffset >= 0 && sparse.values.byteOffset >= 0 &&
                             is_index_type(sparse.indices.componentType);
    if (!is_possible) throw accessor_error(gltf, index, what, "its sparse part has a negative or unknown number");
    const auto count = static_cast<std::size_t>(sparse.count);
    const Strided places =
        elements_of(gltf, index, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
                    size_of_component(sparse.indices.componentType), what);
    const Strided values = elements_of(gltf, index, sparse.values.bufferView,
                                       static_cast<std::size_t>(sparse.values.byteOffset), count, element_bytes, what);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = index_at(places.first + i * places.stride, sparse.indices.componentType);
        if (place >= accessor.count) {
            throw accessor_error(
                gltf, index, what,
                "its sparse part replaces element " + std::to_string(place) + " of " + std::to_string(accessor.count));
        }
        put(place, values.first + i * values.stride);
    }
}

/// Calls put(element, bytes) for every element that the file has bytes for, sparse ones last.
template <class Put>
void for_each_element(const GltfFile& gltf, int index, std::size_t element_bytes, const std::string& what, Put put) {
    const tinygltf::Accessor& accessor = gltf.model.accessors[static_cast<std::size_t>(index)];
    if (accessor.bufferView >= 0) {
        const Strided elements =
            elements_of(gltf, index, accessor.bufferView, accessor.byteOffset, accessor.count, element_bytes, what);
        for (std::size_t i = 0; i < elements.count; ++i) put(i, elements.first + i * elements.stride);
    }
    for_each_sparse(gltf, index, element_bytes, what, put);
}

/// The accessor, when it has elements of that form.
const tinygltf::Accessor& checked(const GltfFile& gltf, int index, int components, const std::string& what) {
    const tinygltf::Accessor& accessor = accessor_at(gltf, index, what);
    if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != components) {
        throw accessor_error(gltf, index, what, "has no elements of " + std::to_string(components) + " numbers");
    }
    if (size_of_component(accessor.componentType) == 0) {
        throw accessor_error(gltf, index, what,
                             "componentType " + std::to_string(accessor.componentType) + " is none of glTF's");
    }
    if (accessor.count == 0) throw accessor_error(gltf, index, what, "has no elements");
    // Where there are bytes they bound the count; it is compared before memory is asked for.
    std::size_t most = kMostWithoutBytes;
    if (accessor.bufferView >= 0) most = bytes_of_view(gltf, accessor.bufferView, what).size();
    if (accessor.count > most) {
        throw accessor_error(gltf, index, what,
                             "has " + std::to_string(accessor.count) + " elements, more than there are bytes for them");
    }
    return accessor;
}

}  // namespace

std::span<const unsigned char> bytes_of_view(const GltfFile& gltf, int view, const std::string& what) {
    if (!has_element(gltf.model.bufferViews, view)) {
        throw UserError(Place{gltf.text.json.file}, what + " names bufferView " + std::to_string(view) + " of " +
                                                        std::to_string(gltf.model.bufferViews.size()));
    }
    const tinygltf::BufferView& found = gltf.model.bufferViews[static_cast<std::size_t>(view)];
    const auto fail = [&](const std::string& message) {
        return gltf_error(gltf.text, "bufferViews", static_cast<std::size_t>(view), message + " (" + what + ")");
    };
    if (!has_element(gltf.model.buffers, found.buffer)) {
        throw fail("names buffer " + std::to_string(found.buffer) + " of " + std::to_string(gltf.model.buffers.size()));
    }
    const std::vector<unsigned char>& bytes = gltf.model.buffers[static_cast<std::size_t>(found.buffer)].data;
    if (found.byteOffset <= bytes.size() && found.byteLength <= bytes.size() - found.byteOffset) {
        return std::span(bytes).subspan(found.byteOffset, found.byteLength);
    }
    throw fail(std::to_string(found.byteLength) + " bytes from byte " + std::to_string(found.byteOffset) +
               " on are more than the " + std::to_string(bytes.size()) + " of buffer " + std::to_string(found.buffer));
}

std::size_t element_count(const GltfFile& gltf, int accessor, const std::string& what) {
    return accessor_at(gltf, accessor, what).count;
}

std::vector<float> read_floats(const GltfFile& gltf, int index, int components, const std::string& what) {
    const tinygltf::Accessor& accessor = checked(gltf, index, components, what);
    const std::size_t n = static_cast<std::size_t>(components), size = size_of_component(accessor.componentType);
    std::vector<float> floats(accessor.count * n, 0.0f);
    for_each_element(gltf, index, n * size, what, [&](std::size_t element, const unsigned char* bytes) {
        for (std::size_t c = 0; c < n; ++c) {
            floats[element * n + c] = component_at(bytes + c * size, accessor.componentType, accessor.normalized);
        }
    });
    return floats;
}

std::vector<std::uint32_t> read_indices(const GltfFile& gltf, int index, const std::string& what) {
    const tinygltf::Accessor& accessor = checked(gltf, index, 1, what);
    if (!is_index_type(accessor.componentType)) {
        throw accessor_error(gltf, index, what, "holds no unsigned integers, which indices are");
    }
    std::vector<std::uint32_t> indices(accessor.count, 0);
    for_each_element(gltf, index, size_of_component(accessor.componentType), what,
                     [&](std::size_t element, const unsigned char* bytes) {
                         indices[element] = index_at(bytes, accessor.componentType);
                     });
    return indices;
}

}  // namespace kreda::scene
