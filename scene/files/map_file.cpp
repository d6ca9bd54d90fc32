#include "scene/files/map_file.hpp"

#include <cstdint>
#include <cstring>
#include <fstream>

#include "scene/files/hash_of_bytes.hpp"
#include "scene/files/whole_file.hpp"

namespace kreda::scene {

namespace {

struct MapHeader {
    char magic[8] = {'K', 'R', 'E', 'D', 'A', 'M', 'A', 'P'};
    std::uint64_t key_bytes = 0;
    std::uint64_t float_bytes = 0;
    std::uint64_t hash = 0;

    bool operator==(const MapHeader&) const = default;
};

MapHeader header_of(const std::string& key, std::span<const float> floats) {
    MapHeader header;
    header.key_bytes = key.size();
    header.float_bytes = floats.size_bytes();
    header.hash = hash_of_bytes(std::as_bytes(floats), hash_of_bytes(std::as_bytes(std::span(key))));
    return header;
}

}  // namespace

bool read_map_file(const std::string& path, const std::string& key, std::span<float> floats) {
    std::ifstream file(path, std::ios::binary);
    MapHeader header;
    file.read(reinterpret_cast<char*>(&header), sizeof header);
    if (!file || header.key_bytes != key.size() || header.float_bytes != floats.size_bytes()) return false;
    std::string its_key(key.size(), '\0');
    file.read(its_key.data(), static_cast<std::streamsize>(its_key.size()));
    file.read(reinterpret_cast<char*>(floats.data()), static_cast<std::streamsize>(floats.size_bytes()));
    return file && its_key == key && header == header_of(key, floats);
}

void write_map_file(const std::string& path, const std::string& key, std::span<const float> floats) {
    const MapHeader header = header_of(key, floats);
    write_whole_file(path,
                     {std::as_bytes(std::span(&header, 1)), std::as_bytes(std::span(key)), std::as_bytes(floats)});
}

}  // namespace kreda::scene
