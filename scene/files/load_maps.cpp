#include "scene/files/load_maps.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <exception>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "lighting/normal_map.hpp"
#include "raster/film.hpp"
#include "scene/files/image_color.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/loaded_files.hpp"
#include "scene/files/toml_tree.hpp"
#include "scene/map_meshes.hpp"

namespace kreda::scene {

namespace {

using lighting::MapKind;

/// What a stored value means, and how often it was not what a map may hold.
struct Decoder {
    MapKind kind;
    const StoredImage& stored;
    std::size_t outside = 0;  ///< clamped to 0..1
    std::size_t non_finite = 0;

    float decode(float value) {
        if (!raster::is_finite(value)) {
            ++non_finite;
            return 0.0f;
        }
        if (kind == MapKind::normal) return lighting::normal_component(value, stored.bits);
        const bool is_light = kind == MapKind::radiance;
        const float linear = is_light || kind == MapKind::color ? linear_from_stored(value, stored) : value;
        constexpr float kMostLight = 1e9f;  // as of [environment]: with the other factors it stays finite
        const float most = is_light ? kMostLight : 1.0f;
        outside += linear < 0.0f || linear > most;
        return is_light ? std::clamp(linear, 0.0f, most) : raster::saturate(linear);
    }
};

/// The third component of unit normals whose first two a file holds.
void add_normal_z(raster::Image& normals) {
    for (std::size_t i = 0; i < normals.plane_size(); ++i) {
        const float x = normals.plane(0)[i], y = normals.plane(1)[i];
        normals.plane(2)[i] = std::sqrt(std::max(0.0f, 1.0f - x * x - y * y));
    }
}

raster::Image decode(const ColorChannels& from, Decoder& decoder) {
    const raster::Image& image = decoder.stored.image;
    const int channels = decoder.kind == MapKind::value ? 1 : 3;
    raster::Image decoded = raster::make_image(image.width, image.height, channels);
    const auto decode_value = [&](float value) { return decoder.decode(value); };
    for (int c = 0; c < channels; ++c) {
        const int channel = from.index[static_cast<std::size_t>(c)];
        if (channel < 0) continue;
        decode_plane(image.plane(channel), image.plane_size(), decoder.stored.levels(), decode_value, decoded.plane(c));
    }
    if (decoder.kind == MapKind::normal && from.index[2] < 0) add_normal_z(decoded);
    return decoded;
}

/// What was made of channels that are neither RGB nor a plain grey.
std::string channels_remark(const ColorChannels& channels, const StoredImage& stored, MapKind kind) {
    if (kind == MapKind::normal && channels.count == 1) {
        return "has no red, green and blue channels, which a normal map needs; all three numbers are " +
               on_one_line(stored.channels[static_cast<std::size_t>(channels.index[0])]);
    }
    if (channels.found.empty()) return "";
    const bool has_blue = channels.index[2] >= 0;
    if (kind == MapKind::normal && !has_blue) return channels.found + "; the third number is what makes normals unit";
    if (kind == MapKind::value && channels.count == 3) {
        return channels.found + "; " + on_one_line(stored.channels[static_cast<std::size_t>(channels.index[0])]) +
               " is taken as the value";
    }
    return channels.found + "; " + channels.made;
}

void warn(const std::string& path, const ColorChannels& channels, const Decoder& decoder,
          std::vector<std::string>& warnings) {
    const auto remark = [&](const std::string& text) {
        if (!text.empty()) warnings.push_back(UserError(Place{path}, text).what());
    };
    for (const std::string& text : decoder.stored.remarks) remark(text);
    remark(channels_remark(channels, decoder.stored, decoder.kind));
    const bool is_light = decoder.kind == MapKind::radiance;
    if (is_light || decoder.kind == MapKind::color) remark(encoding_remark(decoder.stored));
    const auto say = [&](std::size_t count, const char* what) {
        if (count > 0) warnings.push_back(UserError(Place{path}, std::to_string(count) + what).what());
    };
    say(decoder.non_finite, " values are NaN or infinite; 0 is used instead");
    say(is_light ? decoder.outside : 0,
        " values are below 0 or above 1e9 and were clamped: a map of emission holds light");
    say(is_light ? 0 : decoder.outside,
        " values are outside of 0..1 and were clamped: a map holds shares and reflectances");
}

/// Heights as a normal map: white stands `scale` widths of the picture above black. With h in texels,
/// m = (-(h[x+1] - h[x-1]) / 2, -(h[y-1] - h[y+1]) / 2, 1) made unit: rows count downwards, v grows upwards.  Blinn
/// 1978
raster::Image normals_of_heights(const raster::Image& heights, float scale, raster::TextureWrap wrap) {
    raster::Image normals = raster::make_image(heights.width, heights.height, 3);
    const auto neighbour = [&](int at, int side) {
        const int around = (at + side) % side, inside = std::clamp(at, 0, side - 1);
        return wrap == raster::TextureWrap::repeat ? around : inside;
    };
    const float half = 0.5f * scale * static_cast<float>(heights.width);
    const float* const h = heights.plane(0);
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>(neighbour(y, heights.height)) * static_cast<std::size_t>(heights.width) +
               static_cast<std::size_t>(neighbour(x, heights.width));
    };
    for (int y = 0; y < heights.height; ++y) {
        for (int x = 0; x < heights.width; ++x) {
            const glm::vec3 m = glm::normalize(glm::vec3(-half * (h[at(x + 1, y)] - h[at(x - 1, y)]),
                                                         -half * (h[at(x, y - 1)] - h[at(x, y + 1)]), 1.0f));
            for (int c = 0; c < 3; ++c) normals.plane(c)[at(x, y)] = m[c];
        }
    }
    return normals;
}

/// Modelling programs write normal maps as map_Bump: blue throughout, where heights are grey.
bool looks_like_normals(const raster::Image& image) {
    if (image.channels < 3) return false;
    std::size_t blue = 0;
    for (std::size_t i = 0; i < image.plane_size(); ++i) {
        blue += image.plane(2)[i] > 0.5f && image.plane(2)[i] > image.plane(0)[i] + 0.02f;
    }
    return 10 * blue > 9 * image.plane_size();
}

/// The file or the bytes, what they mean, how heights become normals (bump scale, wrap; 0 where they are none), and
/// what is made of the values (channel, factor, offset).
using ReadWay = std::tuple<std::string, const std::string*, MapKind, float, int, int, std::array<float, 4>>;

/// A file that is to be read in one way, and what came of it.
struct Wanted {
    lighting::Map map;  ///< as the first material names it
    lighting::MaterialMaps maps;
    bool is_height = false;
    bool with_pyramid = false;  ///< some material needs it
    std::shared_ptr<const LoadedTexture> loaded;
    std::vector<UsedFile> from;
    std::exception_ptr failure;
    bool is_told = false;  ///< its warnings
};
using WantedFiles = std::map<ReadWay, Wanted>;

ReadWay way_of(const lighting::MaterialMaps& maps, const lighting::MapUse& use) {
    const bool is_height = use.kind == MapKind::normal && maps.normal_from_height;
    const lighting::Map& map = maps.*use.map;
    return {map.bytes ? map.file : canonical_path(map.file),
            map.bytes.get(),
            use.kind,
            is_height ? maps.bump_scale : 0.0f,
            is_height ? 1 + static_cast<int>(maps.wrap) : 0,
            map.channel,
            {map.factor.x, map.factor.y, map.factor.z, map.offset}};
}

StoredImage stored_image_of(const lighting::Map& map) {
    return map.bytes ? read_stored_bytes(map.file, *map.bytes) : read_stored_image(map.file);
}

/// What the map makes of the picture's values.
void apply_factor(const lighting::Map& map, raster::Image& image) {
    if (map.factor == glm::vec3(1.0f) && map.offset == 0.0f) return;
    for (int c = 0; c < image.channels; ++c) {
        float* const values = image.plane(c);
        for (std::size_t i = 0; i < image.plane_size(); ++i) values[i] = map.offset + map.factor[c] * values[i];
    }
}

/// What a file says as a map of that kind, and warnings about it.
raster::Image decoded_map(const std::string& path, const StoredImage& stored, MapKind kind,
                          std::vector<std::string>& warnings, int channel = 0) {
    ColorChannels channels = color_channels(stored.channels, stored.alpha);
    if (channel > 0 && channels.count == 3) channels.index[0] = channels.index[static_cast<std::size_t>(channel)];
    Decoder decoder{kind, stored};
    raster::Image decoded = decode(channels, decoder);
    warn(path, channels, decoder, warnings);
    return decoded;
}

/// A height map as normals.
raster::Image normals_of_bump(const std::string& path, const lighting::MaterialMaps& maps,
                              std::vector<std::string>& warnings) {
    const StoredImage stored = read_stored_image(path);
    if (looks_like_normals(stored.image)) {
        warnings.push_back(path + ": is given as a height map (bump), but is a normal map by its colours; read as one");
        return decoded_map(path, stored, MapKind::normal, warnings);
    }
    return normals_of_heights(decoded_map(path, stored, MapKind::value, warnings), maps.bump_scale, maps.wrap);
}

std::shared_ptr<const raster::Texture> texture_of(const lighting::Map& map, MapKind kind, bool with_pyramid,
                                                  std::vector<std::string>& warnings) {
    const int channel = kind == MapKind::value ? map.channel : 0;
    raster::Image decoded = decoded_map(map.file, stored_image_of(map), kind, warnings, channel);
    apply_factor(map, decoded);
    return std::make_shared<raster::Texture>(raster::make_texture(decoded, with_pyramid));
}

/// Calls visit(material, use, map) for every map that must come from a file.
template <class Visit>
void for_each_wanted(Scene& scene, const std::vector<bool>& materials, Visit visit) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        lighting::Material& material = scene.materials[m];
        for (const lighting::MapUse& use : lighting::map_uses()) {
            lighting::Map& map = material.maps.*use.map;
            const bool is_wanted = materials[m] && reads_map(material.model, use) && !map.file.empty() && !map.texture;
            if (is_wanted) visit(material, use, map);
        }
    }
}

/// Read and decode one file. What is wrong with it is kept until it is its turn to be told.
void load(const MapKind kind, Wanted& wanted) {
    try {
        LoadedTexture loaded;
        if (!wanted.map.bytes) wanted.from.push_back(use_file(wanted.map.file));
        if (wanted.is_height) {
            const raster::Image normals = normals_of_bump(wanted.map.file, wanted.maps, loaded.warnings);
            loaded.texture = std::make_shared<raster::Texture>(raster::make_texture(normals, wanted.with_pyramid));
        } else {
            loaded.texture = texture_of(wanted.map, kind, wanted.with_pyramid, loaded.warnings);
        }
        wanted.loaded = std::make_shared<const LoadedTexture>(std::move(loaded));
    } catch (...) { wanted.failure = std::current_exception(); }
}

std::string key_of(const ReadWay& way, const Wanted& wanted) {
    const auto& [path, bytes, kind, scale, wrap, channel, factor] = way;
    std::string key = path + " kind " + std::to_string(static_cast<int>(kind)) + " heights " + std::to_string(wrap) +
                      " " + std::to_string(std::bit_cast<std::uint32_t>(scale)) +
                      (wanted.with_pyramid ? " pyramid" : "") + " channel " + std::to_string(channel);
    for (const float number : factor) key += " " + std::to_string(std::bit_cast<std::uint32_t>(number));
    return key;
}

/// All files that are not kept already, side by side. Pictures inside of mesh files are not kept: nothing says whether
/// they changed.
void load_wanted(WantedFiles& wanted_files, LoadedFiles* files) {
    std::vector<std::pair<const ReadWay*, Wanted*>> missing;
    for (auto& [way, wanted] : wanted_files) {
        if (files && !wanted.map.bytes) wanted.loaded = find_kept(*files, &LoadedFiles::textures, key_of(way, wanted));
        if (!wanted.loaded) missing.emplace_back(&way, &wanted);
    }
    const int count = static_cast<int>(missing.size());
#pragma omp parallel for schedule(dynamic) if (count > 1)
    for (int i = 0; i < count; ++i) {
        const auto [way, wanted] = missing[static_cast<std::size_t>(i)];
        load(std::get<MapKind>(*way), *wanted);
    }
    for (const auto& [way, wanted] : missing) {
        if (!files || wanted->map.bytes) continue;
        if (wanted->loaded) {
            keep(*files, &LoadedFiles::textures, key_of(*way, *wanted), wanted->loaded, wanted->from);
        } else {
            files->used.insert(files->used.end(), wanted->from.begin(), wanted->from.end());
        }
    }
}

}  // namespace

std::shared_ptr<const raster::Texture> load_texture(const std::string& path, MapKind kind, bool with_pyramid,
                                                    std::vector<std::string>& warnings) {
    lighting::Map map;
    map.file = path;
    return texture_of(map, kind, with_pyramid, warnings);
}

void load_maps(Scene& scene, const std::vector<bool>& materials, LoadedFiles* files) {
    WantedFiles wanted_files;
    for_each_wanted(scene, materials,
                    [&](const lighting::Material& material, const lighting::MapUse& use, const lighting::Map& map) {
                        Wanted& wanted = wanted_files[way_of(material.maps, use)];
                        wanted.with_pyramid |= material.maps.filter == lighting::TextureFilter::trilinear;
                        if (!wanted.map.file.empty()) return;
                        wanted.map = map;
                        wanted.maps = material.maps;
                        wanted.is_height = use.kind == MapKind::normal && material.maps.normal_from_height;
                    });
    load_wanted(wanted_files, files);
    for_each_wanted(scene, materials,
                    [&](const lighting::Material& material, const lighting::MapUse& use, lighting::Map& map) {
                        Wanted& wanted = wanted_files[way_of(material.maps, use)];
                        if (wanted.failure) std::rethrow_exception(wanted.failure);
                        const std::vector<std::string>& told = wanted.loaded->warnings;
                        if (!wanted.is_told) scene.warnings.insert(scene.warnings.end(), told.begin(), told.end());
                        wanted.is_told = true;
                        map.texture = wanted.loaded->texture;
                    });
    TangentMeshes made;
    add_tangents(scene, files ? files->tangents : made);
}

}  // namespace kreda::scene
