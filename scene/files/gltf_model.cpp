// The only file that compiles tinygltf. It decodes no image, and asks us for every file that it wants to read.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_USE_CPP14
#include "scene/files/gltf_model.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "scene/files/quoted_text.hpp"

namespace kreda::scene {

namespace {

constexpr std::uintmax_t kMaxBufferBytes = std::uintmax_t(1) << 30;

/// The library reads images of data URIs only; the others are for later, when it is known which are wanted.
bool keep_bytes(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
                int size, void*) {
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}

/// A buffer's file, found as all files that a mesh names.
std::string buffer_path(const std::string& name, void* file) {
    const GltfFile& gltf = *static_cast<const GltfFile*>(file);
    return name.empty() ? "" : resolve_named_path(gltf.text.json, 0, name, gltf.limits).path;
}

bool buffer_exists(const std::string& name, void* file) {
    return !buffer_path(name, file).empty();
}

std::string same_path(const std::string& name, void*) {
    return name;
}

bool read_buffer(std::vector<unsigned char>* out, std::string*, const std::string& name, void* file) {
    const GltfFile& gltf = *static_cast<const GltfFile*>(file);
    const std::string path = buffer_path(name, file);
    if (gltf.limits.used) gltf.limits.used->push_back(use_file(path));
    const auto refuse = [&](const std::string& why) {
        throw UserError(Place{gltf.text.json.file}, "the buffer " + path_in_quotes(name) + " " + why);
    };
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed)) refuse("is not a file");
    const std::uintmax_t size = std::filesystem::file_size(path, failed);
    if (failed || size > kMaxBufferBytes) refuse("is larger than 1 GB");
    out->resize(static_cast<std::size_t>(size));
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(out->data()), static_cast<std::streamsize>(size));
    if (!stream) refuse("cannot be read");
    return true;
}

/// "... at line 3, column 5: ..." of the JSON library as a place.
Place place_in(const GltfText& text, const std::string& complaint) {
    Place place{text.json.file};
    const std::size_t found = complaint.find("at line ");
    if (text.is_binary || found == std::string::npos) return place;
    (void)std::sscanf(complaint.c_str() + found, "at line %d, column %d", &place.line, &place.column);
    return place;
}

/// What the library says, without its own marks, as one line.
std::string plain_complaint(const std::string& complaint) {
    std::string text = complaint;
    if (text.starts_with("[json.exception")) text.erase(0, std::min(text.size(), text.find("] ") + 2));
    while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' ')) text.pop_back();
    for (char& c : text) c = c == '\n' ? ';' : c;
    return text.empty() ? "its JSON is not as glTF 2 wants it" : on_one_line(text);
}

bool parse(GltfFile& gltf, std::string& error) {
    tinygltf::TinyGLTF reader;
    reader.SetImageLoader(keep_bytes, nullptr);
    reader.SetFsCallbacks({buffer_exists, same_path, read_buffer, nullptr, &gltf});
    std::string warning;
    const std::string& bytes = gltf.text.bytes;
    const auto size = static_cast<unsigned int>(bytes.size());
    return gltf.text.is_binary ? reader.LoadBinaryFromMemory(&gltf.model, &error, &warning,
                                                             reinterpret_cast<const unsigned char*>(bytes.data()), size)
                               : reader.LoadASCIIFromString(&gltf.model, &error, &warning, bytes.data(), size, "");
}

}  // namespace

std::string path_of_uri(const std::string& uri) {
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned int code = 0;
        const bool is_escape = uri[i] == '%' && i + 2 < uri.size() &&
                               std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
                               std::sscanf(uri.c_str() + i + 1, "%2x", &code) == 1;
        path += is_escape && code != 0 ? static_cast<char>(code) : uri[i];
        if (is_escape && code != 0) i += 2;
    }
    return path;
}

GltfFile read_gltf_file(const std::string& path, const NamedFileLimits& limits) {
    GltfFile gltf{read_gltf_text(path), limits, {}};
    std::string error;
    try {
        if (parse(gltf, error)) return gltf;
    } catch (const UserError&) { throw; } catch (const std::exception& damage) {
        error += damage.what();
    }
    throw UserError(place_in(gltf.text, error), "cannot be read: " + plain_complaint(error));
}

}  // namespace kreda::scene
