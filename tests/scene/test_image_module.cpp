// The module that brings OpenImageIO: what is said where it is missing.
#include "scene/files/image_module.hpp"

#include <dlfcn.h>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "tests/scene/errors_and_views.hpp"
#include "tests/scene/temp_folder.hpp"

using kreda::scene::open_image_module;
using kreda::tests::has;
using kreda::tests::TempFolder;

namespace {

std::string complaint_about(const std::vector<std::string>& places) {
    try {
        (void)open_image_module(places, "wood.jpg");
    } catch (const kreda::scene::UserError& error) { return error.what(); }
    return "no error";
}

/// The file of a library that every program here has, and that is not the module.
std::string other_library() {
    Dl_info info{};
    dladdr(dlsym(RTLD_DEFAULT, "__cxa_throw"), &info);
    return info.dli_fname ? info.dli_fname : "";
}

}  // namespace

TEST_CASE("image module: a program of the build finds its own") {
    const auto& module = open_image_module(kreda::scene::image_module_places(), "wood.jpg");
    const bool offers_all = module.read_stored_image && module.encode_exr;
    CHECK(offers_all);
}

TEST_CASE("image module: where there is none, the error names the image, the file and the remedy") {
    const TempFolder folder;
    const std::string text = complaint_about({folder.file("libkreda_images.so"), folder.path.string()});
    CHECK(text.rfind("wood.jpg: ", 0) == 0);
    CHECK(has(text, "libkreda_images.so"));
    CHECK(has(text, "cmake --install"));
    CHECK(text.find('\n') == std::string::npos);
}

TEST_CASE("image module: what cannot be loaded gives the loader's reason and the package") {
    const TempFolder folder;
    const std::string text = complaint_about({folder.write("libkreda_images.so", "no library")});
    CHECK(has(text, folder.file("libkreda_images.so")));
    CHECK(has(text, "install the package libopenimageio"));
}

TEST_CASE("image module: a library that is no module of this build is refused") {
    const std::string library = other_library();
    if (library.empty() || library[0] != '/') {
        MESSAGE("SKIPPED: no other library is known by its file");
        return;
    }
    CHECK(has(complaint_about({library}), "belongs to another build of Kreda"));
}
