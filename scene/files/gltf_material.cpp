#include "scene/files/gltf_material.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "scene/files/gltf_accessor.hpp"

namespace kreda::scene {

namespace {

using tinygltf::ExtensionMap;

/// A textureInfo, whatever it is a texture of.
struct TextureUse {
    std::string what;  ///< "baseColorTexture"
    int texture = -1;  ///< -1: there is none
    int set = 0;
    const ExtensionMap* extensions = nullptr;
};

template <class Info>
TextureUse use_of(const char* what, const Info& info) {
    return {what, info.index, info.texCoord, &info.extensions};
}

const tinygltf::Value* find_extension(const ExtensionMap& extensions, const std::string& name) {
    const auto found = extensions.find(name);
    return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

double gltf_number_in(const tinygltf::Value& object, const std::string& key, double otherwise) {
    const tinygltf::Value& value = object.Get(key);
    return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

glm::dvec2 pair_in(const tinygltf::Value& object, const std::string& key, double otherwise) {
    const tinygltf::Value& value = object.Get(key);
    glm::dvec2 pair(otherwise);
    if (!value.IsArray() || value.ArrayLen() != 2) return pair;
    for (int i = 0; i < 2; ++i) {
        const tinygltf::Value& number = value.Get(static_cast<std::size_t>(i));
        if (number.IsNumber()) pair[i] = number.GetNumberAsDouble();
    }
    return pair;
}

GltfUv uv_of_use(const TextureUse& use) {
    GltfUv uv;
    uv.set = use.set;
    const tinygltf::Value* const transform = find_extension(*use.extensions, "KHR_texture_transform");
    if (!transform) return uv;
    uv.set = static_cast<int>(gltf_number_in(*transform, "texCoord", uv.set));
    uv.offset = pair_in(*transform, "offset", 0.0);
    uv.scale = pair_in(*transform, "scale", 1.0);
    uv.rotation = gltf_number_in(*transform, "rotation", 0.0);
    return uv;
}

struct MaterialsReader {
    const GltfFile& gltf;
    LeftOut& left_out;
    ObjWarnings warnings;
    std::map<int, std::shared_ptr<const std::string>> bytes_of_image = {};

    lighting::Material read(const tinygltf::Material& material, std::size_t index, GltfUv& uv);
    void read_textures(const tinygltf::Material& from, const TextureUse& emissive, lighting::Material& to, GltfUv& uv);
    std::optional<lighting::Map> map_of(const TextureUse& use);
    std::optional<lighting::Map> map_at(const TextureUse& use, const GltfUv& uv);
    void take_image(int index, lighting::Map& map);
    void read_sampler(const TextureUse& use, lighting::MaterialMaps& maps);
    void name_extensions(const tinygltf::Material& material);
};

/// The picture's file, or its bytes out of the file or a data URI. A picture that is not there costs only itself.
void MaterialsReader::take_image(int index, lighting::Map& map) {
    const tinygltf::Image& image = gltf.model.images[static_cast<std::size_t>(index)];
    const auto place = gltf.text.offset_of.find({"images", static_cast<std::size_t>(index)});
    const std::size_t offset = place == gltf.text.offset_of.end() ? 0 : place->second;
    if (image.bufferView < 0 && image.image.empty()) {
        map.file = find_named_file(gltf.text.json, offset, path_of_uri(image.uri), gltf.limits, "image file",
                                   "; drawn without it", warnings);
        return;
    }
    map.file = gltf.text.json.file + " images[" + std::to_string(index) + "]";
    std::shared_ptr<const std::string>& bytes = bytes_of_image[index];
    if (!bytes) {
        std::span<const unsigned char> found(image.image);
        if (image.bufferView >= 0)
            found = bytes_of_view(gltf, image.bufferView, "images[" + std::to_string(index) + "]");
        bytes = std::make_shared<const std::string>(found.begin(), found.end());
    }
    map.bytes = bytes;
}

std::optional<lighting::Map> MaterialsReader::map_of(const TextureUse& use) {
    if (use.texture < 0) return {};
    const std::string lost = "textures that are not there";
    if (!has_element(gltf.model.textures, use.texture)) {
        warnings.add(lost, 0,
                     use.what + " names texture " + std::to_string(use.texture) + " of " +
                         std::to_string(gltf.model.textures.size()) + "; drawn without it");
        return {};
    }
    const tinygltf::Texture& texture = gltf.model.textures[static_cast<std::size_t>(use.texture)];
    int source = texture.source;
    if (const auto* webp = find_extension(texture.extensions, "EXT_texture_webp"); webp && source < 0)
        source = static_cast<int>(gltf_number_in(*webp, "source", -1.0));
    if (!has_element(gltf.model.images, source)) {
        const bool is_basis = find_extension(texture.extensions, "KHR_texture_basisu") != nullptr;
        if (is_basis) {
            left_out.add("KTX 2 textures (KHR_texture_basisu)");
        } else {
            warnings.add(lost, 0, use.what + ": its texture has no image; drawn without it");
        }
        return {};
    }
    lighting::Map map;
    try {
        take_image(source, map);
    } catch (const UserError& error) {
        warnings.add_line(lost, std::string(error.what()) + "; drawn without it");
        return {};
    }
    if (map.file.empty()) return {};
    return map;
}

std::optional<lighting::Map> MaterialsReader::map_at(const TextureUse& use, const GltfUv& uv) {
    if (use.texture >= 0 && uv_of_use(use) != uv) {
        left_out.add(use.what + "s at other texture coordinates than the material's first texture");
        return {};
    }
    return map_of(use);
}

void MaterialsReader::read_sampler(const TextureUse& use, lighting::MaterialMaps& maps) {
    if (!has_element(gltf.model.textures, use.texture)) return;
    const int index = gltf.model.textures[static_cast<std::size_t>(use.texture)].sampler;
    if (!has_element(gltf.model.samplers, index)) return;
    const tinygltf::Sampler& sampler = gltf.model.samplers[static_cast<std::size_t>(index)];
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) maps.filter = lighting::TextureFilter::nearest;
    const bool clamps = sampler.wrapS == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    if (clamps) maps.wrap = lighting::TextureWrap::clamp;
    if (sampler.wrapS != sampler.wrapT) left_out.add("textures that go on differently along u and v");
    if (sampler.wrapS == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) left_out.add("mirrored repetition of textures");
}

/// Maps with their factors; a factor of 0 makes the map pointless.
void MaterialsReader::read_textures(const tinygltf::Material& from, const TextureUse& emissive, lighting::Material& to,
                                    GltfUv& uv) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    const TextureUse base = use_of("baseColorTexture", pbr.baseColorTexture);
    const TextureUse both = use_of("metallicRoughnessTexture", pbr.metallicRoughnessTexture);
    const TextureUse normal = use_of("normalTexture", from.normalTexture);
    const TextureUse occlusion = use_of("occlusionTexture", from.occlusionTexture);
    const std::array<const TextureUse*, 5> uses = {&base, &both, &normal, &emissive, &occlusion};
    const auto first = std::find_if(uses.begin(), uses.end(), [](const TextureUse* use) { return use->texture >= 0; });
    if (first == uses.end()) return;
    uv = uv_of_use(**first);
    read_sampler(**first, to.maps);
    const lighting::CookTorranceMaterial& c = to.cook_torrance;
    if (auto map = map_at(base, uv)) {
        map->factor = c.albedo;
        to.maps.albedo = to.maps.diffuse = *map;
    }
    if (auto map = map_at(both, uv); map && to.model == lighting::ReflectionModel::cook_torrance) {
        map->channel = 2;
        map->factor = glm::vec3(c.metallic);
        if (c.metallic > 0.0f) to.maps.metallic = *map;
        map->channel = 1;
        map->factor = glm::vec3(c.roughness);
        if (c.roughness > 0.0f) to.maps.roughness = *map;
    }
    if (auto map = map_at(normal, uv)) {
        const auto scale = static_cast<float>(std::clamp(from.normalTexture.scale, -1e3, 1e3));
        map->factor = glm::vec3(scale, scale, 1.0f);
        to.maps.normal = *map;
    }
    if (auto map = map_at(occlusion, uv)) {
        const auto strength = static_cast<float>(std::clamp(from.occlusionTexture.strength, 0.0, 1.0));
        map->factor = glm::vec3(strength);
        map->offset = 1.0f - strength;
        to.maps.ao = *map;
    }
    if (to.phong.emission == glm::vec3(0.0f)) return;
    if (auto map = map_at(emissive, uv)) to.maps.emission = *map;
}

void MaterialsReader::name_extensions(const tinygltf::Material& material) {
    for (const auto& [name, value] : material.extensions) {
        if (name != "KHR_materials_unlit" && name != "KHR_materials_emissive_strength") left_out.add(on_one_line(name));
    }
    if (material.alphaMode != "OPAQUE")
        left_out.add("transparency (alphaMode " + token_in_quotes(material.alphaMode) + ")");
}

lighting::Material MaterialsReader::read(const tinygltf::Material& from, std::size_t index, GltfUv& uv) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    const auto share = [](double x) { return static_cast<float>(std::clamp(x, 0.0, 1.0)); };
    lighting::Material to;
    to.name = from.name.empty() ? "material " + std::to_string(index) : from.name;
    const bool is_unlit = from.extensions.contains("KHR_materials_unlit");
    to.model = is_unlit ? lighting::ReflectionModel::unlit : lighting::ReflectionModel::cook_torrance;
    if (pbr.baseColorFactor.size() >= 3) {
        for (int c = 0; c < 3; ++c)
            to.cook_torrance.albedo[c] = share(pbr.baseColorFactor[static_cast<std::size_t>(c)]);
    }
    to.cook_torrance.metallic = share(pbr.metallicFactor);
    to.cook_torrance.roughness = share(pbr.roughnessFactor);
    to.phong.diffuse = to.cook_torrance.albedo;
    to.phong.specular = glm::vec3(0.0f);
    double strength = 1.0;
    if (const auto* more = find_extension(from.extensions, "KHR_materials_emissive_strength"))
        strength = std::clamp(gltf_number_in(*more, "emissiveStrength", 1.0), 0.0, 1e9);
    if (from.emissiveFactor.size() == 3 && !is_unlit) {
        for (int c = 0; c < 3; ++c)
            to.phong.emission[c] =
                static_cast<float>(strength) * share(from.emissiveFactor[static_cast<std::size_t>(c)]);
    }
    read_textures(from, use_of("emissiveTexture", from.emissiveTexture), to, uv);
    name_extensions(from);
    return to;
}

}  // namespace

glm::vec2 uv_of(const GltfUv& how, const glm::vec2& uv) {
    const double c = std::cos(how.rotation), s = std::sin(how.rotation);
    const glm::dvec2 scaled = how.scale * glm::dvec2(uv);
    const double u = c * scaled.x + s * scaled.y + how.offset.x;
    const double v = c * scaled.y - s * scaled.x + how.offset.y;
    return {static_cast<float>(u), static_cast<float>(1.0 - v)};
}

GltfMaterials read_gltf_materials(const GltfFile& gltf, LeftOut& left_out) {
    MaterialsReader reader{gltf, left_out, ObjWarnings(gltf.text.json)};
    GltfMaterials all;
    for (std::size_t i = 0; i < gltf.model.materials.size(); ++i) {
        GltfUv uv;
        all.materials.push_back(reader.read(gltf.model.materials[i], i, uv));
        all.uv.push_back(uv);
        all.two_sided.push_back(gltf.model.materials[i].doubleSided);
    }
    all.warnings = reader.warnings.lines();
    return all;
}

}  // namespace kreda::scene
