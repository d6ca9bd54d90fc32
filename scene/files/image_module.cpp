#include "scene/files/image_module.hpp"

#include <filesystem>

#include <dlfcn.h>

#include "scene/error.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

constexpr const char* kModuleName = "libkreda_images.so";

std::string first_file(const std::vector<std::string>& places, const std::string& image) {
    std::error_code unreadable;
    for (const std::string& place : places) {
        if (fs::is_regular_file(place, unreadable)) return place;
    }
    throw UserError(Place{image}, std::string("needs ") + kModuleName +
                                      ", which is neither beside the program nor in ../lib/kreda from there; build the "
                                      "target kreda_images, or install Kreda again with cmake --install");
}

/// The module for the whole program, opened by whoever needs it first.
const ImageModule& image_module(const std::string& image) {
    static const ImageModule& module = open_image_module(image_module_places(), image);
    return module;
}

}  // namespace

std::vector<std::string> image_module_places() {
    std::error_code unknown;
    const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    if (unknown) return {KREDA_IMAGES_OF_BUILD};
    return {folder / kModuleName, folder.parent_path() / "lib" / "kreda" / kModuleName, KREDA_IMAGES_OF_BUILD};
}

const ImageModule& open_image_module(const std::vector<std::string>& places, const std::string& image) {
    const std::string file = first_file(places, image);
    void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        throw UserError(Place{image}, "needs OpenImageIO, which cannot be loaded (" + std::string(dlerror()) +
                                          "); install the package " KREDA_IMAGES_PACKAGE);
    }
    using Offer = const ImageModule* (*)();
    const auto offer = reinterpret_cast<Offer>(dlsym(library, "kreda_image_module"));
    const ImageModule* module = offer ? offer() : nullptr;
    const ImageModule own;
    if (!module || module->options_size != own.options_size || module->image_size != own.image_size) {
        throw UserError(Place{image}, file + " belongs to another build of Kreda; build or install both again");
    }
    return *module;
}

StoredImage read_stored_image(const std::string& path, const ImageReadOptions& options) {
    return image_module(path).read_stored_image(path, options);
}

raster::Image read_image(const std::string& path, const ImageReadOptions& options) {
    return read_stored_image(path, options).image;
}

std::vector<unsigned char> encode_exr(const std::string& path, const InterleavedImage& image) {
    return image_module(path).encode_exr(path, image);
}

}  // namespace kreda::scene
