// Image files that lie: what crashes OpenImageIO, asks for gigabytes or is cut off costs one line, not the program.
#include <csignal>
#include <filesystem>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "scene/files/child_process.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/mesh_file.hpp"
#include "scene/files/read_scene.hpp"
#include "tests/scene/errors_and_views.hpp"
#include "tests/scene/raw_images.hpp"
#include "tests/scene/raw_jpeg.hpp"
#include "tests/scene/raw_png.hpp"
#include "tests/scene/temp_folder.hpp"

using kreda::scene::ImageReadOptions;
using kreda::scene::read_image;
using kreda::tests::has;
using kreda::tests::little_endian;
using kreda::tests::png_chunk;
using kreda::tests::TempFolder;

namespace {

std::string complaint_of(const std::string& file, const ImageReadOptions& options = {}) {
    try {
        (void)read_image(file, options);
    } catch (const kreda::scene::UserError& error) { return error.what(); }
    return "no error";
}

/// One line that begins with the file's name.
bool is_line_about(const std::string& text, const std::string& file) {
    return text.starts_with(file + ": ") && !has(text, "\n");
}

std::string packed(const std::string& text) {
    uLongf size = compressBound(text.size());
    std::string bytes(size, '\0');
    compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()), text.size(),
              9);
    return bytes.substr(0, size);
}

/// A colour-mapped TGA of 20 x 20 pixels of 16 bits, whose map has no entry: OpenImageIO 2.4 reads before its begin.
std::string tga_without_colors() {
    return std::string("\0\1\1\0\0\2\0\x18\0\0\0\0", 12) + little_endian(20, 2) + little_endian(20, 2) +
           std::string("\x10\0", 2) + std::string(8, '\xff');
}

/// A PNG of one pixel with this many notes, each of which unpacks to five megabytes.
[[maybe_unused]] std::string png_with_long_notes(int count) {
    const std::string note = png_chunk("zTXt", std::string("Comment\0\0", 9) + packed(std::string(5'000'000, 'a')));
    std::string notes;
    for (int i = 0; i < count; ++i) notes += note;
    return kreda::tests::raw_png(1, 1, 8, 2, "abc", notes);
}

/// Processor time of the children that have ended, and the most memory that one of them held, in KiB.
rusage used_by_children() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return usage;
}

}  // namespace

TEST_CASE("damaged images: what crashes the decoder is one line with the file's name and what to do") {
    const TempFolder folder;
    const std::string file = folder.write("broken.tga", tga_without_colors());
    const std::string text = complaint_of(file);
    CHECK(is_line_about(text, file));
    CHECK(has(text, "save it again"));
}

TEST_CASE("damaged images: a JPEG of a few bytes that promises 65500 x 65500 pixels gets no memory") {
    const TempFolder folder;
    const std::string file = folder.write("large.jpg", kreda::tests::raw_jpeg({65500, 65500, true}));
    CHECK(is_line_about(complaint_of(file), file));
    CHECK(used_by_children().ru_maxrss < 1'500'000);
}

#if !defined(KREDA_SANITIZED)  // a sanitizer asks for memory of its own and ends in its own way
TEST_CASE("damaged images: notes that unpack to more than the limit cost the limit") {
    const TempFolder folder;
    ImageReadOptions options;
    options.spare_memory = 192 << 20;  // OpenImageIO's threads reserve some, too
    const std::string few = folder.write("few.png", png_with_long_notes(2));
    CHECK(complaint_of(few, options) == "no error");
    const std::string many = folder.write("many.png", png_with_long_notes(80));  // 400 MB
    const std::string text = complaint_of(many, options);
    CHECK(is_line_about(text, many));
    CHECK(has(text, "192 MiB"));
}
#endif

TEST_CASE("damaged images: a decoder that never ends is ended") {
    const kreda::scene::ChildLimits limits{1 << 28, 1};
    const auto spin = [](int) {
        volatile int zero = 0;
        while (zero == 0) {}
    };
    const auto wait = [](int pipe) {
        char byte = 0;
        return kreda::scene::read_all(pipe, &byte, 1);
    };
    const kreda::scene::ChildEnd end = run_in_child(limits, spin, wait);
    CHECK(!end.is_whole);
    CHECK(end.signal == SIGXCPU);
}

TEST_CASE("damaged images: a JPEG or TIFF that is cut off is an error: a header may promise, the file must hold") {
    const TempFolder folder;
    for (const bool is_progressive : {false, true}) {
        CAPTURE(is_progressive);
        const std::string jpeg = kreda::tests::raw_jpeg({64, 64, is_progressive});
        CHECK(complaint_of(folder.write("whole.jpg", jpeg)) == "no error");
        // 64 blocks of three components take one bit or two each: 24 or 48 bytes before the mark of the end.
        const std::size_t data = is_progressive ? 24 : 48;
        for (std::size_t lost = 1; lost <= data + 2; lost += 3) {
            const std::string file = folder.write("cut.jpg", jpeg.substr(0, jpeg.size() - lost));
            CAPTURE(lost);
            const std::string text = complaint_of(file);
            CHECK(is_line_about(text, file));
            CHECK(has(text, "is damaged"));
        }
    }
    const std::string rows(64 * 64 * 3, '\7');
    const std::string tiff = kreda::tests::raw_tiff({.width = 64, .height = 64}, rows);
    const std::string cut = folder.write("cut.tif", tiff.substr(0, tiff.size() - 4000));
    CHECK(has(complaint_of(cut), "is damaged"));
}

TEST_CASE("damaged images: a colour profile, a palette or notes that make no sense end no program") {
    const TempFolder folder;
    const std::string profile = std::string("ICC_PROFILE\0\1\1", 14) + std::string(200, '\xff');
    const std::string nested = std::string("XML:com.adobe.xmp\0\0\0\0\0", 22) + "<rdf:RDF>" + [] {
        std::string open;
        for (int i = 0; i < 30000; ++i) open += "<rdf:Description>";
        return open;
    }();
    const std::string palette = "BM" + little_endian(62 + 256, 4) + little_endian(0, 4) + little_endian(62, 4) +
                                little_endian(40, 4) + little_endian(16, 4) + little_endian(16, 4) +
                                little_endian(1, 2) + little_endian(8, 2) + little_endian(0, 16) + little_endian(2, 8) +
                                std::string(8, '\0') + std::string(256, '\xff');
    for (const std::string& file :
         {folder.write("profile.jpg", kreda::tests::raw_jpeg({16, 16, false, profile})),
          folder.write("nested.png", kreda::tests::raw_png(1, 1, 8, 2, "abc", png_chunk("iTXt", nested))),
          folder.write("palette.bmp", palette)}) {
        CAPTURE(file);
        const std::string text = complaint_of(file);
        const bool is_said = text == "no error" || is_line_about(text, file);
        CHECK(is_said);
    }
}

TEST_CASE("damaged images: pipes, devices and folders in place of files are refused at once") {
    const TempFolder folder;
    const std::string fifo = folder.file("a.png");
    REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
    for (const std::string& file : {fifo, std::string("/dev/zero"), folder.path.string()}) {
        CAPTURE(file);
        CHECK(has(complaint_of(file), "is not a file"));
    }
}

TEST_CASE("damaged images: pipes and devices are no scene files, no meshes, and nothing to write to") {
    const TempFolder folder;
    const auto complaint = [](const auto& action) -> std::string {
        try {
            action();
        } catch (const kreda::scene::UserError& error) { return error.what(); }
        return "no error";
    };
    const std::string fifo = folder.file("a.png");
    REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
    CHECK(has(complaint([&] { (void)kreda::scene::read_scene(fifo); }), "is a pipe or a device"));
    CHECK(has(complaint([&] { (void)kreda::scene::read_scene("/dev/zero"); }), "is a pipe or a device"));
    for (const std::string name : {"a.obj", "a.mtl", "a.gltf"}) REQUIRE(mkfifo(folder.file(name).c_str(), 0600) == 0);
    folder.write("b.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const std::string& file :
         {folder.file("a.obj"), folder.file("b.obj"), folder.file("a.gltf"), std::string("/dev/zero")}) {
        CAPTURE(file);
        CHECK(has(complaint([&] { (void)kreda::scene::load_mesh_file(file); }), "is not a regular file"));
    }
    const std::string text = "[environment]\nfile = \"a.png\"\n";
    const auto read_text = [&] { (void)kreda::scene::read_scene_text(text, "test", folder.path.string()); };
    CHECK(has(complaint(read_text), "is a pipe or a device, not an image file"));
    const kreda::raster::Image picture = kreda::raster::make_image(2, 2, 3);
    CHECK(has(complaint([&] { kreda::scene::write_png(fifo, picture); }), "would be replaced"));
    CHECK(std::filesystem::is_fifo(fifo));
}

TEST_CASE("damaged images: after a crash images are read as before") {
    const TempFolder folder;
    const std::string broken = folder.write("broken.tga", tga_without_colors());
    const std::string good = folder.write("good.png", kreda::tests::one_pixel_png(8, 2, "\x33\x66\x99"));
    const auto values = read_image(good).values;
    REQUIRE(values.size() == 3);
    CHECK(values[0] == doctest::Approx(51.0 / 255));
    CHECK(is_line_about(complaint_of(broken), broken));
    CHECK(read_image(good).values == values);
}
