#include "scene/files/image_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>
#include <random>

#include <sys/resource.h>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "tests/scene/errors_and_views.hpp"
#include "tests/scene/raw_png.hpp"
#include "tests/scene/temp_folder.hpp"

using kreda::raster::Image;
using kreda::raster::make_image;
using kreda::scene::read_image;
using kreda::scene::UserError;
using kreda::scene::write_exr;
using kreda::scene::write_png;
using kreda::tests::big_endian;
using kreda::tests::bytes_of;
using kreda::tests::message_of;
using kreda::tests::one_pixel_png;
using kreda::tests::png_chunk;
using kreda::tests::TempFolder;

namespace {

/// Every byte value in every channel, at different places.
Image all_bytes() {
    Image image = make_image(16, 16, 3);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const int i = 16 * y + x;
            image.set_rgb(x, y, glm::vec3(i, 255 - i, (i * 7) % 256) / 255.0f);
        }
    }
    return image;
}

/// An image that no compression makes small.
Image noise(int side) {
    std::mt19937 random(1);
    Image image = make_image(side, side, 3);
    for (float& value : image.values) value = std::uniform_real_distribution<float>(0.0f, 1.0f)(random);
    return image;
}

/// While it lives, this process cannot write a file of more bytes than this.
struct FileSizeLimit {
    rlimit old{};
    explicit FileSizeLimit(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);  // the write fails instead
        getrlimit(RLIMIT_FSIZE, &old);
        const rlimit limit{bytes, old.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &old);
        std::signal(SIGXFSZ, SIG_DFL);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
};

std::size_t files_in(const TempFolder& folder) {
    const std::filesystem::directory_iterator first(folder.path), end;
    return static_cast<std::size_t>(std::distance(first, end));
}

/// A PNG that promises an RGB picture of this size and has almost no data (the empty zlib stream).
std::string png_that_promises(std::uint32_t width, std::uint32_t height) {
    const std::string header = big_endian(width) + big_endian(height) + std::string("\x08\x02\x00\x00\x00", 5);
    const std::string empty_stream("\x78\x9c\x03\x00\x00\x00\x00\x01", 8);
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png_chunk("IDAT", empty_stream) + png_chunk("IEND", "");
}

}  // namespace

TEST_CASE("image: planes follow each other and rows go down") {
    Image image = make_image(2, 3, 3);
    image.at(1, 0, 2) = 7.0f;
    CHECK(image.values[(1 * 3 + 2) * 2 + 0] == 7.0f);
    CHECK(image.plane(1)[2 * 2] == 7.0f);
    CHECK(image.rgb(0, 2) == glm::vec3(0, 7, 0));
}

TEST_CASE("image file: PNG keeps every byte value in every channel") {
    const TempFolder folder;
    const Image image = all_bytes();
    write_png(folder.file("a.png"), image);
    const Image back = read_image(folder.file("a.png"));
    REQUIRE(back.channels == 3);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        CHECK(std::lround(255.0f * back.values[i]) == std::lround(255.0f * image.values[i]));
    }
}

TEST_CASE("image file: a byte is the nearest one, and half goes up, as lround has it") {
    for (std::uint32_t bits = 0; bits < 0x3f800001u; bits += 997) {
        const float encoded = std::bit_cast<float>(bits);
        if (kreda::scene::byte_from_encoded(encoded) != std::lround(255.0f * encoded)) FAIL(encoded);
    }
    CHECK(kreda::scene::byte_from_encoded(0.5f / 255.0f) == std::lround(255.0f * (0.5f / 255.0f)));
    CHECK(kreda::scene::byte_from_encoded(std::numeric_limits<float>::quiet_NaN()) == 0);
    CHECK(kreda::scene::byte_from_encoded(std::numeric_limits<float>::infinity()) == 255);
}

TEST_CASE("image file: PNG rounds to the nearest byte and clamps") {
    const TempFolder folder;
    Image image = make_image(6, 1, 1);
    image.values = {-1.0f, 0.4f / 255, 0.6f / 255, 1.0f, 1000.0f, std::numeric_limits<float>::quiet_NaN()};
    write_png(folder.file("a.png"), image);
    const Image back = read_image(folder.file("a.png"));
    REQUIRE(back.channels == 1);
    CHECK(back.values == kreda::raster::AlignedVector<float>{0.0f, 0.0f, 1.0f / 255, 1.0f, 1.0f, 0.0f});
}

TEST_CASE("image file: EXR keeps every float to the last bit") {
    const TempFolder folder;
    Image image = make_image(3, 2, 3);
    image.values[0] = 1.0f / 3.0f;
    image.values[1] = -3361.0f;
    image.values[2] = std::numeric_limits<float>::max();
    image.values[3] = std::numeric_limits<float>::denorm_min();
    image.values[4] = std::numeric_limits<float>::infinity();
    image.values[17] = 64890.123f;
    write_exr(folder.file("a.exr"), image);
    const Image back = read_image(folder.file("a.exr"));
    CHECK(back.width == 3);
    CHECK(back.height == 2);
    CHECK(back.values == image.values);
    CHECK(kreda::raster::count_non_finite(back) == 1);
}

TEST_CASE("image file: EXR channels may have names of their own") {
    const TempFolder folder;
    Image image = make_image(2, 2, 1);
    image.values = {1, 2, 3, 4};
    write_exr(folder.file("depth.exr"), image, {"Z"});
    CHECK(read_image(folder.file("depth.exr")).values == image.values);
    CHECK(bytes_of(folder.file("depth.exr")).find(std::string("Z\0", 2)) != std::string::npos);
}

TEST_CASE("image file: the same image gives the same bytes whatever its name") {
    const TempFolder folder;
    for (const char* extension : {".png", ".exr"}) {
        const std::string a = folder.file(std::string("a") + extension),
                          b = folder.file(std::string("long name") + extension);
        for (const std::string& name : {a, b}) {
            if (std::string(extension) == ".png")
                write_png(name, all_bytes());
            else
                write_exr(name, all_bytes());
        }
        CHECK(bytes_of(a) == bytes_of(b));
        // Nothing that changes from day to day: left alone, the library stamps an EXR with the time of writing.
        for (const char* tag : {"Software", "tIME"}) CHECK(bytes_of(a).find(tag) == std::string::npos);
        const bool has_date = bytes_of(a).find("capDate") != std::string::npos;
        CHECK(has_date == (bytes_of(a).find("1970:01:01 00:00:00") != std::string::npos));
    }
}

TEST_CASE("image file: PNG says that it is sRGB") {
    const TempFolder folder;
    write_png(folder.file("a.png"), all_bytes());
    CHECK(bytes_of(folder.file("a.png")).find("sRGB") != std::string::npos);
}

TEST_CASE("image file: writing replaces the old file and leaves no other") {
    const TempFolder folder;
    folder.write("a.png", "old");
    write_png(folder.file("a.png"), all_bytes());
    CHECK(files_in(folder) == 1);
    CHECK(read_image(folder.file("a.png")).width == 16);
}

TEST_CASE("image file: a failure leaves nothing behind") {
    const TempFolder folder;
    std::filesystem::create_directories(folder.path / "a.png");
    CHECK_THROWS_AS(write_png(folder.file("a.png"), all_bytes()), UserError);
    CHECK_THROWS_AS(write_exr(folder.file("b.exr"), Image{}), UserError);
    CHECK_THROWS_AS(write_png(folder.file(std::string(250, 'x') + ".png"), all_bytes()), UserError);  // name too long
    CHECK(files_in(folder) == 1);
}

TEST_CASE("image file: a disk that is full leaves nothing behind") {
    const TempFolder folder;
    const FileSizeLimit limit(512);  // the same failure as a full disk, without one
    CHECK_THROWS_AS(write_png(folder.file("a.png"), noise(64)), UserError);
    CHECK_THROWS_AS(write_exr(folder.file("a.exr"), noise(64)), UserError);
    CHECK(files_in(folder) == 0);
}

TEST_CASE("image file: a missing folder and a wrong extension say what to do") {
    const TempFolder folder;
    const std::string lost = folder.file("nowhere/a.png");
    CHECK(message_of([&] { write_png(lost, all_bytes()); }) ==
          lost + ": the folder " + folder.file("nowhere") + " does not exist; create it first");
    const std::string text = message_of([&] { write_png(folder.file("a.jpg"), all_bytes()); });
    CHECK(text.find(".png") != std::string::npos);
    CHECK(text.find(".exr") != std::string::npos);
    CHECK(files_in(folder) == 0);
}

TEST_CASE("image file: colour is not multiplied by alpha") {
    // A PNG of one pixel (200,100,50) at alpha 128: filter byte 0, then RGBA, in a stored deflate block.
    const TempFolder folder;
    const std::string file = folder.write("a.png", one_pixel_png(8, 6, "\xc8\x64\x32\x80"));
    const Image image = read_image(file);
    REQUIRE(image.channels == 4);
    const std::vector<int> expected = {200, 100, 50, 128};
    for (int c = 0; c < 4; ++c) CHECK(std::lround(255.0f * image.at(c, 0, 0)) == expected[std::size_t(c)]);
}

TEST_CASE("image file: a header that promises too much is refused before it costs anything") {
    const TempFolder folder;
    const std::string wide = folder.write("wide.png", png_that_promises(100000, 1));
    CHECK(message_of([&] { (void)read_image(wide); }).find("100000 x 1 pixels") != std::string::npos);
    const std::string large = folder.write("large.png", png_that_promises(30000, 30000));
    CHECK(message_of([&] { (void)read_image(large); }).find("limits") != std::string::npos);
    kreda::scene::ImageReadOptions small;
    small.max_side = 15;
    write_png(folder.file("a.png"), all_bytes());
    CHECK_THROWS_AS((void)read_image(folder.file("a.png"), small), UserError);
}

TEST_CASE("image file: what is no image is an error with the name") {
    const TempFolder folder;
    for (const std::string& file : {folder.file("absent.png"), folder.path.string(), folder.write("empty.png", ""),
                                    folder.write("text.exr", "hello"), folder.write("cut.png", png_that_promises(4, 4)),
                                    folder.write("a.unknown", "hello")}) {
        CAPTURE(file);
        CHECK(message_of([&] { (void)read_image(file); }).find(file) == 0);
    }
}

TEST_CASE("image file: real environments and textures open with their sizes") {
    const std::string data = kreda::tests::shared_data_folder();
    if (data.empty()) {
        MESSAGE("SKIPPED: no folder of shared data (set KREDA_SHARED)");
        return;
    }
    const Image studio = read_image(data + "/studio.exr");
    CHECK(studio.width == 1024);
    CHECK(studio.height == 512);
    CHECK(kreda::raster::count_non_finite(studio) == 0);
    CHECK(*std::min_element(studio.values.begin(), studio.values.end()) < 0.0f);
    const Image city = read_image(data + "/city.exr");
    CHECK(city.width == 512);
    CHECK(city.height == 256);
    const Image dawn = read_image(data + "/dawn.hdr");
    CHECK(dawn.width == 1024);
    CHECK(dawn.channels == 3);
    CHECK(read_image(data + "/spot_texture.png").channels >= 3);
}
