#include "scene/files/image_module.hpp"

#include <csignal>
#include <cstring>
#include <filesystem>
#include <functional>
#include <system_error>

#include <dlfcn.h>

#include "scene/error.hpp"
#include "scene/files/child_process.hpp"
#include "scene/files/image_message.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

constexpr const char* kModuleName = "libkreda_images.so";

/// The first of the files that is there. One without a folder is looked for by the system, along the program's run
/// path.
void* open_first(const std::vector<std::string>& places, std::string& file, const std::string& image) {
    std::error_code unreadable;
    for (const std::string& place : places) {
        const bool has_folder = place.find('/') != std::string::npos;
        if (has_folder && !fs::is_regular_file(place, unreadable)) continue;
        file = place;
        void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library || has_folder) return library;
    }
    throw UserError(Place{image}, std::string("needs ") + kModuleName +
                                      ", which is neither beside the program nor in ../lib/kreda from there; build the "
                                      "target kreda_images, or install Kreda again with cmake --install");
}

void check_is_file(const std::string& path) {
    std::error_code failed;
    if (!fs::exists(path, failed)) throw UserError(Place{path}, "no such image file");
    if (!fs::is_regular_file(path, failed)) throw UserError(Place{path}, "is not a file; an image file is needed");
    if (fs::file_size(path, failed) == 0) throw UserError(Place{path}, "is empty; an image file is needed");
}

/// Why the child process of an image gave none.
std::string reason_of_end(const ChildEnd& end, const ImageReadOptions& options) {
    const std::string save_again = "; open it in another program and save it again";
    if (end.signal == SIGXCPU || end.signal == SIGALRM || end.signal == SIGKILL) {
        return "takes more than " + std::to_string(options.spare_seconds) +
               " s beyond what its size explains, and was given up" + save_again;
    }
    const std::string signal = end.signal == 0 ? "" : " (" + std::string(strsignal(end.signal)) + ")";
    return "is damaged, or needs more than " + std::to_string(options.spare_memory >> 20) +
           " MiB beyond its own size: OpenImageIO crashed on it" + signal + save_again;
}

/// Let the module work in a child process, whose memory and time are limited: OpenImageIO 2.4 crashes on some damaged
/// files, and others, of a few bytes, make it ask for gigabytes. Here it is loaded and never run, so that a child has
/// none of its threads to miss.
ImageMessage run_module(const std::string& path, const ImageReadOptions& options,
                        const std::function<void(ImageMessage&)>& work) {
    ImageMessage message;
    const auto send = [&](int pipe) {
        ImageMessage made;
        try {
            work(made);
        } catch (const UserError& error) { made.complaint = error.what(); }
        send_message(pipe, made);
    };
    ChildEnd end;
    try {
        end = run_in_child({options.spare_memory, options.spare_seconds}, send,
                           [&](int pipe) { return receive_message(pipe, options, message); });
    } catch (const std::system_error& error) {
        throw UserError(Place{path}, std::string("cannot be decoded in a process of its own: ") + error.what());
    }
    if (!end.is_whole) throw UserError(Place{path}, reason_of_end(end, options));
    if (!message.complaint.empty()) throw UserError(message.complaint);
    return message;
}

/// The encoder copies the values a few times, and packs some ten million in a second.
ImageReadOptions options_to_encode(const InterleavedImage& image) {
    constexpr std::int64_t kCopies = 4, kValuesInSecond = 5'000'000;
    const std::int64_t values = static_cast<std::int64_t>(image.values.size());
    ImageReadOptions options;
    options.spare_memory += kCopies * values * std::int64_t(sizeof(float));
    options.spare_seconds += static_cast<int>(values / kValuesInSecond);
    return options;
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
    return {folder / kModuleName, folder.parent_path() / "lib" / "kreda" / kModuleName, kModuleName,
            KREDA_IMAGES_OF_BUILD};
}

const ImageModule& open_image_module(const std::vector<std::string>& places, const std::string& image) {
    std::string file;
    void* const library = open_first(places, file, image);
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
    check_is_file(path);
    const ImageModule& module = image_module(path);
    return run_module(path, options,
                      [&](ImageMessage& message) { message.stored = module.read_stored_image(path, options); })
        .stored;
}

StoredImage read_stored_bytes(const std::string& name, const std::string& bytes, const ImageReadOptions& options) {
    if (bytes.empty()) throw UserError(Place{name}, "is empty; an image is needed");
    const ImageModule& module = image_module(name);
    return run_module(name, options,
                      [&](ImageMessage& message) { message.stored = module.read_stored_bytes(name, bytes, options); })
        .stored;
}

raster::Image read_image(const std::string& path, const ImageReadOptions& options) {
    return read_stored_image(path, options).image;
}

std::vector<unsigned char> encode_exr(const std::string& path, const InterleavedImage& image) {
    const ImageModule& module = image_module(path);
    const ImageReadOptions options = options_to_encode(image);
    return run_module(path, options, [&](ImageMessage& message) { message.bytes = module.encode_exr(path, image); })
        .bytes;
}

}  // namespace kreda::scene
