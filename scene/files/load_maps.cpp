#include "scene/files/load_maps.hpp"

#include <cmath>
#include <filesystem>
#include <map>

#include "lighting/normal_map.hpp"
#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "scene/map_meshes.hpp"

namespace kreda::scene {

namespace {

using lighting::MapKind;

/// What a stored value means, and how often it was not what a map may hold.
struct Decoder {
    MapKind kind;
    int bits;
    std::size_t outside = 0;  ///< clamped to 0..1
    std::size_t non_finite = 0;

    float decode(float stored) {
        if (!raster::is_finite(stored)) {
            ++non_finite;
            return 0.0f;
        }
        if (kind == MapKind::normal) return lighting::normal_component(stored, bits);
        const float linear = kind == MapKind::color && bits > 0 ? raster::linear_from_srgb(stored) : stored;
        outside += linear < 0.0f || linear > 1.0f;
        return raster::saturate(linear);
    }
};

/// Integers have few values: each is decoded once.
void decode_plane(const float* stored, std::size_t count, Decoder& decoder, float* decoded) {
    if (decoder.bits == 0) {
        for (std::size_t i = 0; i < count; ++i) decoded[i] = decoder.decode(stored[i]);
        return;
    }
    const std::size_t values = std::size_t{1} << decoder.bits;
    const float greatest = static_cast<float>(values - 1);
    std::vector<float> table(values);
    for (std::size_t v = 0; v < values; ++v) table[v] = decoder.decode(static_cast<float>(v) / greatest);
    for (std::size_t i = 0; i < count; ++i) {
        decoded[i] = table[static_cast<std::size_t>(raster::saturate(stored[i]) * greatest + 0.5f)];
    }
}

raster::Image decode(const StoredImage& stored, Decoder& decoder) {
    const raster::Image& image = stored.image;
    const int channels = decoder.kind == MapKind::value ? 1 : 3;
    raster::Image decoded = raster::make_image(image.width, image.height, channels);
    for (int c = 0; c < channels; ++c) {
        const int from = image.channels >= 3 ? c : 0;
        decode_plane(image.plane(from), image.plane_size(), decoder, decoded.plane(c));
    }
    return decoded;
}

void warn(const std::string& path, const Decoder& decoder, std::vector<std::string>& warnings) {
    const auto say = [&](std::size_t count, const char* what) {
        if (count > 0) warnings.push_back(UserError(Place{path}, std::to_string(count) + what).what());
    };
    say(decoder.non_finite, " values are NaN or infinite; 0 is used instead");
    say(decoder.outside, " values are outside of 0..1 and were clamped: a map holds shares and reflectances");
}

/// A file read in one way, and whether somebody wants its pyramid.
struct Wanted {
    bool with_pyramid = false;
    std::shared_ptr<const raster::Texture> texture;
};
using WantedFiles = std::map<std::pair<std::string, MapKind>, Wanted>;

/// One name for a file, however the scene writes it.
std::string canonical(const std::string& path) {
    std::error_code failed;
    const std::filesystem::path real = std::filesystem::weakly_canonical(path, failed);
    return failed ? path : real.string();
}

/// Calls visit(material, use, map) for every map that must come from a file.
template <class Visit>
void for_each_wanted(Scene& scene, Visit visit) {
    const std::vector<bool> visible = visible_materials(scene);
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        lighting::Material& material = scene.materials[m];
        for (const lighting::MapUse& use : lighting::map_uses()) {
            lighting::Map& map = material.maps.*use.map;
            const bool is_wanted = visible[m] && reads_map(material.model, use) && !map.file.empty() && !map.texture;
            if (is_wanted) visit(material, use, map);
        }
    }
}

}  // namespace

std::shared_ptr<const raster::Texture> load_texture(const std::string& path, MapKind kind, bool with_pyramid,
                                                    std::vector<std::string>& warnings) {
    const StoredImage stored = read_stored_image(path);
    Decoder decoder{kind, stored.bits};
    const raster::Image decoded = decode(stored, decoder);
    warn(path, decoder, warnings);
    return std::make_shared<raster::Texture>(raster::make_texture(decoded, with_pyramid));
}

void load_maps(Scene& scene) {
    drop_maps_without_uv(scene);
    WantedFiles files;
    for_each_wanted(scene, [&](const lighting::Material& material, const lighting::MapUse& use, lighting::Map& map) {
        Wanted& wanted = files[{canonical(map.file), use.kind}];
        wanted.with_pyramid |= material.maps.filter == lighting::TextureFilter::trilinear;
    });
    for_each_wanted(scene, [&](const lighting::Material&, const lighting::MapUse& use, lighting::Map& map) {
        Wanted& wanted = files[{canonical(map.file), use.kind}];
        if (!wanted.texture) wanted.texture = load_texture(map.file, use.kind, wanted.with_pyramid, scene.warnings);
        map.texture = wanted.texture;
    });
    add_tangents(scene);
}

}  // namespace kreda::scene
