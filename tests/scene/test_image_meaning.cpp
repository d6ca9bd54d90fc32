// What the numbers of image files are: which way up, how encoded, whether multiplied by alpha, which channels. Every
// file is made here byte by byte, every value by hand.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/load_maps.hpp"
#include "scene/files/read_environment.hpp"
#include "scene/files/read_scene.hpp"
#include "tests/scene/errors_and_views.hpp"
#include "tests/scene/raw_images.hpp"
#include "tests/scene/raw_png.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using namespace kreda::scene;
using namespace kreda::tests;
using kreda::lighting::MapKind;

namespace {

bool has(const std::vector<std::string>& texts, const std::string& part) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

std::string bytes(std::initializer_list<int> values) {
    std::string text;
    for (const int value : values) text += static_cast<char>(value);
    return text;
}

/// The picture of three columns and two rows that all tests of orientation store: column x of row y holds this.
int number_at(int x, int y) {
    return 10 * (3 * y + x + 1);
}

/// The numbers that come back from a file, times `scale`.
void check_is_upright(const std::string& file, float scale) {
    CAPTURE(file);
    const raster::Image image = read_image(file);
    REQUIRE(image.width == 3);
    REQUIRE(image.height == 2);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            CHECK(image.at(0, x, y) * scale == doctest::Approx(number_at(x, y)));
        }
    }
}

/// The pixels in the order of a file: line after line along `slow`, within a line along `fast`; y counts downwards.
std::string in_order(bool x_is_slow, bool x_falls, bool y_falls, const std::function<std::string(int)>& pixel) {
    std::string pixels;
    for (int slow = 0; slow < (x_is_slow ? 3 : 2); ++slow) {
        for (int fast = 0; fast < (x_is_slow ? 2 : 3); ++fast) {
            const int x = x_is_slow ? slow : fast, y = x_is_slow ? fast : slow;
            pixels += pixel(number_at(x_falls ? 2 - x : x, y_falls ? 1 - y : y));
        }
    }
    return pixels;
}

/// A picture of even colour that is large enough for an environment.
std::string repeated(const std::string& pixel, int count = 8) {
    std::string pixels;
    for (int i = 0; i < count; ++i) pixels += pixel;
    return pixels;
}

EnvironmentImage environment_of(const std::string& file) {
    return read_environment_image(file, Place{file}, "");
}

/// The first texel of a file as a map.
glm::vec3 texel_of(const std::string& file, MapKind kind, std::vector<std::string>& warnings) {
    return raster::level_image(*load_texture(file, kind, false, warnings), 0).rgb(0, 0);
}

glm::vec3 texture_color(const std::string& file, std::vector<std::string>& warnings) {
    return texel_of(file, MapKind::color, warnings);
}

// sRGB by hand (IEC 61966-2-1): ((c / 255 + 0.055) / 1.055)^2.4
constexpr float kLinear200 = 0.57758f, kLinear188 = 0.50289f, kLinear100 = 0.12744f, kLinear50 = 0.03190f;

/// A byte of an 8-bit file that had to be divided by alpha is known to a byte only.
void check_color(const glm::vec3& color, float tolerance) {
    CHECK(std::abs(color.x - kLinear200) < tolerance);
    CHECK(std::abs(color.y - kLinear100) < tolerance);
    CHECK(std::abs(color.z - kLinear50) < tolerance);
}

}  // namespace

TEST_CASE("image orientation: Radiance's eight orders of pixels give the same picture") {
    const TempFolder folder;
    for (const bool x_is_slow : {false, true}) {
        for (const bool x_falls : {false, true}) {
            for (const bool y_falls : {false, true}) {  // downwards in the file, as y counts here: Radiance's -Y
                const std::string x = x_falls ? "-X 3" : "+X 3", y = y_falls ? "+Y 2" : "-Y 2";
                const std::string sizes = x_is_slow ? x + " " + y : y + " " + x;
                const std::string file = folder.write(
                    sizes + ".hdr", raw_radiance("", sizes, in_order(x_is_slow, x_falls, y_falls, radiance_pixel)));
                check_is_upright(file, 1.0f);
                CHECK(has(read_stored_image(file).remarks, "set upright") == (sizes != "-Y 2 +X 3"));
            }
        }
    }
}

TEST_CASE("image orientation: EXIF's eight in TIFF and PNG give the same picture") {
    // Where the first row and the first column of the file are (EXIF 2.3, tag 274).
    struct Order {
        bool x_is_slow, x_falls, y_falls;
    };
    const Order orders[] = {{false, false, false}, {false, true, false}, {false, true, true}, {false, false, true},
                            {true, false, false},  {true, true, false},  {true, true, true},  {true, false, true}};
    const TempFolder folder;
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Order& order = orders[orientation - 1];
        const std::string pixels = in_order(order.x_is_slow, order.x_falls, order.y_falls, [](int value) {
            return bytes({value, 0, 0});
        });
        const int width = order.x_is_slow ? 2 : 3, height = order.x_is_slow ? 3 : 2;
        const std::string name = std::to_string(orientation);
        RawTiff tiff{.width = width, .height = height, .orientation = orientation};
        check_is_upright(folder.write(name + ".tif", raw_tiff(tiff, pixels)), 255.0f);
        const std::string exif = png_chunk("eXIf", raw_exif(orientation));
        check_is_upright(folder.write(name + ".png", raw_png(width, height, 8, 2, pixels, exif)), 255.0f);
    }
}

TEST_CASE("image orientation: WebP's EXIF is obeyed and a TIFF that is turned halfway is refused") {
    const TempFolder folder;
    const std::string webp = folder.write("a.webp", raw_webp(8, 2, bytes({200, 100, 50, 128}), 6));
    CHECK(read_image(webp).width == 2);
    CHECK(read_image(webp).height == 8);
    CHECK(has(read_stored_image(webp).remarks, "Orientation 6"));
    const int kYCbCr = 6;
    const RawTiff ycbcr{.width = 2, .height = 2, .photometric = kYCbCr, .orientation = 3};
    const std::string tiff = folder.write("a.tif", raw_tiff(ycbcr, repeated(bytes({100, 128, 128}), 4)));
    CHECK(message_of([&] { (void)read_image(tiff); }).find("Orientation 3") != std::string::npos);
}

TEST_CASE("radiance header: all factors are divided out, indented lines are not ours") {
    const TempFolder folder;
    const auto first_pixel = [&](const std::string& variables, std::vector<std::string>& remarks) {
        const std::string file =
            folder.write("a.hdr", raw_radiance(variables, "-Y 2 +X 4", repeated(radiance_pixel(60))));
        remarks = environment_of(file).remarks;
        return environment_of(file).image->rgb(0, 0);
    };
    std::vector<std::string> remarks;
    CHECK(first_pixel("", remarks) == glm::vec3(60));
    CHECK(remarks.empty());
    CHECK(first_pixel("EXPOSURE=2\nEXPOSURE= 3\n\tEXPOSURE=7\n", remarks) == glm::vec3(10));
    CHECK(has(remarks, "multiplied by 6 "));
    CHECK(first_pixel("COLORCORR=1 2 0.5\nEXPOSURE=2\n", remarks) == glm::vec3(30, 15, 60));
    CHECK(has(remarks, "multiplied by (2, 4, 1)"));
    CHECK(first_pixel("EXPOSURE=0\n", remarks) == glm::vec3(60));
    CHECK(has(remarks, "'EXPOSURE=0', which is no factor"));
    CHECK(first_pixel("EXPOSURE=1e30\nEXPOSURE=1e30\n", remarks) == glm::vec3(60));
    CHECK(has(remarks, "no factor"));
    for (const char* usual :
         {"PRIMARIES=0 0 0 0 0 0 0 0\n", "PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.333 0.333\n",
          "PRIMARIES=0.64 0.33 0.30 0.60 0.15 0.06 0.3127 0.329\n", "EXPOSURE=1.0\nGAMMA=1\n"}) {
        CHECK(first_pixel(usual, remarks) == glm::vec3(60));
        CHECK(remarks.empty());
    }
    CHECK(first_pixel("PRIMARIES=0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.329\n", remarks) == glm::vec3(60));
    CHECK(has(remarks, "PRIMARIES"));
    CHECK(first_pixel("GAMMA=2.2\n", remarks) == glm::vec3(60));
    CHECK(has(remarks, "GAMMA"));
}

TEST_CASE("radiance header: XYZ is refused with what converts it") {
    const TempFolder folder;
    const std::string file =
        folder.write("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 2 +X 4\n" + repeated(radiance_pixel(60)));
    CHECK(message_of([&] { (void)read_image(file); }).find("ra_xyze -r") != std::string::npos);
}

TEST_CASE("environment file: 8 and 16 bits are decoded as sRGB and floats are linear") {
    const TempFolder folder;
    const auto light = [&](const std::string& name, const std::string& content) {
        return environment_of(folder.write(name, content)).image->rgb(3, 1).x;
    };
    const auto same = [](float expected) { return doctest::Approx(expected).epsilon(1e-4); };
    const std::string rgb16 = repeated("\xbc\xbc");  // 188 * 257
    CHECK(light("rgb.png", raw_png(4, 2, 8, 2, repeated(bytes({188, 188, 188})))) == same(kLinear188));
    CHECK(light("grey.png", raw_png(4, 2, 8, 0, repeated(bytes({188})))) == same(kLinear188));
    CHECK(light("grey16.png", raw_png(4, 2, 16, 0, rgb16)) == same(kLinear188));
    CHECK(light("grey_alpha.png", raw_png(4, 2, 8, 4, repeated(bytes({188, 7})))) == same(kLinear188));
    CHECK(light("rgb.tif", raw_tiff({.width = 4, .height = 2}, repeated(bytes({188, 188, 188})))) == same(kLinear188));
    CHECK(light("rgb.tga", raw_tga(4, 2, repeated(bytes({188, 188, 188, 255})))) == same(kLinear188));
    const std::string half_in_float = bytes({0, 0, 0, 0x3f});
    const RawTiff floats{.width = 4, .height = 2, .samples = 1, .bits = 32, .photometric = 1, .is_float = true};
    CHECK(light("float.tif", raw_tiff(floats, repeated(half_in_float))) == 0.5f);
    CHECK(light("linear.hdr", raw_radiance("", "-Y 2 +X 4", repeated(radiance_pixel(188)))) == 188.0f);
}

TEST_CASE("image encoding: what a PNG says of its gamma counts for colours alone") {
    const TempFolder folder;
    const auto png = [&](std::uint32_t gamma, const std::string& more = "") {
        const std::string chunk = png_chunk("gAMA", big_endian(gamma)) + more;
        return folder.write("g.png", raw_png(4, 2, 8, 2, repeated(bytes({200, 200, 200})), chunk));
    };
    const auto close = [](float expected) { return doctest::Approx(expected).epsilon(1e-4); };
    std::vector<std::string> warnings;
    CHECK(texture_color(png(45455), warnings).x == close(kLinear200));  // 1 / 2.2: PNG's way to say sRGB
    CHECK(texture_color(png(100000, png_chunk("sRGB", "\1")), warnings).x == close(kLinear200));
    CHECK(warnings.empty());
    CHECK(texture_color(png(100000), warnings).x == close(200.0f / 255.0f));
    CHECK(has(warnings, "linear"));
    CHECK(texture_color(png(55556), warnings).x == close(0.64577f));  // (200 / 255)^1.8
    CHECK(has(warnings, "gamma is 1.8"));
    CHECK(environment_of(png(100000)).image->rgb(0, 0).x == close(200.0f / 255.0f));
    warnings.clear();
    CHECK(texel_of(png(55556), MapKind::value, warnings).x == close(200.0f / 255.0f));
    CHECK(warnings.empty());
}

TEST_CASE("image alpha: colours come without it from every format") {
    const TempFolder folder;
    const std::string rgba = bytes({200, 100, 50, 128});
    const std::string multiplied = bytes({100, 50, 25, 128});  // of 200, 100, 50
    const RawTiff tiff{.width = 4, .height = 2, .samples = 4, .extra = 2};
    const RawTiff premultiplied{.width = 4, .height = 2, .samples = 4, .extra = 1};
    const struct {
        std::string name, content;
        float tolerance;
    } files[] = {
        {"a.png", raw_png(4, 2, 8, 6, repeated(rgba)), 1e-4f},
        {"a16.png", raw_png(4, 2, 16, 6, repeated("\xc8\xc8\x64\x64\x32\x32\x80\x80")), 1e-4f},
        {"a.tif", raw_tiff(tiff, repeated(rgba)), 1e-4f},
        {"premultiplied.tif", raw_tiff(premultiplied, repeated(multiplied)), 0.006f},  // 199.2 instead of 200
        {"a.tga", raw_tga(4, 2, repeated(bytes({50, 100, 200, 128}))), 1e-4f},
        {"a.webp", raw_webp(4, 2, rgba), 1e-4f},
        {"extended.webp", raw_webp(4, 2, rgba, 1), 1e-4f},
        {"misnamed.png", raw_webp(4, 2, rgba), 1e-4f},
        {"transparent.webp", raw_webp(4, 2, bytes({200, 100, 50, 0})), 1e-4f},
        {"transparent.png", raw_png(4, 2, 8, 6, repeated(bytes({200, 100, 50, 0}))), 1e-4f},
    };
    for (const auto& file : files) {
        CAPTURE(file.name);
        const std::string path = folder.write(file.name, file.content);
        std::vector<std::string> warnings;
        check_color(texture_color(path, warnings), file.tolerance);
        check_color(environment_of(path).image->rgb(1, 1), file.tolerance);
        CHECK(warnings.empty());
    }
}

TEST_CASE("image alpha: EXR's colours are divided by it and stay where it is none") {
    const TempFolder folder;
    raster::Image image = raster::make_image(4, 2, 4);
    for (const int x : {0, 1, 2, 3}) image.set_rgb(x, 0, {0.4f, 0.2f, 0.1f});
    const float alphas[] = {0.5f, 0.0f, 1.0f, 1.5f};
    for (const int x : {0, 1, 2, 3}) image.at(3, x, 0) = alphas[x];
    write_exr(folder.file("a.exr"), image, {"R", "G", "B", "A"});
    const EnvironmentImage environment = environment_of(folder.file("a.exr"));
    CHECK(environment.image->channels == 3);
    CHECK(environment.image->rgb(0, 0) == glm::vec3(0.8f, 0.4f, 0.2f));
    for (const int x : {1, 2, 3}) CHECK(environment.image->rgb(x, 0) == glm::vec3(0.4f, 0.2f, 0.1f));
}

TEST_CASE("image channels: those that are no plain colour are named with what was made of them") {
    const TempFolder folder;
    const auto written = [&](const std::vector<std::string>& names) {
        raster::Image image = raster::make_image(4, 2, static_cast<int>(names.size()));
        for (int c = 0; c < image.channels; ++c) {
            std::fill_n(image.plane(c), image.plane_size(), 0.25f * static_cast<float>(c + 1));
        }
        write_exr(folder.file("a.exr"), image, names);
        return folder.file("a.exr");
    };
    const auto light = [&](const std::vector<std::string>& names, const std::string& remark) {
        const EnvironmentImage environment = environment_of(written(names));
        CAPTURE(remark);
        CHECK((remark.empty() ? environment.remarks.empty() : has(environment.remarks, remark)));
        return environment.image->rgb(0, 0);
    };
    CHECK(light({"R", "G"}, "the channels R and G and no blue one") == glm::vec3(0.25f, 0.5f, 0.0f));
    CHECK(light({"Z"}, "the channel Z alone; it is taken as grey") == glm::vec3(0.25f));
    CHECK(light({"A"}, "the channel A alone; it is taken as grey") == glm::vec3(0.25f));
    CHECK(light({"Y"}, "") == glm::vec3(0.25f));
    CHECK(light({"Y", "Z"}, "the channels Y and Z; Y is taken as grey") == glm::vec3(0.25f));
    CHECK(light({"B", "G", "R"}, "") == glm::vec3(0.75f, 0.5f, 0.25f));
    CHECK(light({"B", "G", "R", "Z"}, "") == glm::vec3(0.75f, 0.5f, 0.25f));
    CHECK(light({"a.X", "a.Y", "a.Z"}, "a.X, a.Y and a.Z are taken as red, green and blue") ==
          glm::vec3(0.25f, 0.5f, 0.75f));
    std::vector<std::string> warnings;
    CHECK(texel_of(written({"R", "G"}), MapKind::value, warnings).x == 0.25f);
    CHECK(has(warnings, "no blue one; R is taken as the value"));
    const glm::vec3 normal = texel_of(written({"R", "G"}), MapKind::normal, warnings);
    CHECK(normal.x == doctest::Approx(-0.5f));  // 0.25 and 0.5 are x = -1/2 and y = 0; z = sqrt(1 - 1/4)
    CHECK(normal.y == doctest::Approx(0.0f));
    CHECK(normal.z == doctest::Approx(0.866025f));
    CHECK(has(warnings, "normals unit"));
    (void)load_texture(written({"Y"}), MapKind::normal, false, warnings);
    CHECK(has(warnings, "which a normal map needs"));
}

TEST_CASE("image channels: a channel that is neither red nor grey in TIFF is no blue") {
    const TempFolder folder;
    const RawTiff two{.width = 4, .height = 2, .samples = 2, .photometric = 1};
    const EnvironmentImage environment =
        environment_of(folder.write("a.tif", raw_tiff(two, repeated(bytes({188, 7})))));
    CHECK(environment.image->rgb(0, 0).z == doctest::Approx(kLinear188).epsilon(1e-4));
    CHECK(has(environment.remarks, "Y is taken as grey"));
}

TEST_CASE("image errors: one line with a reason and nothing beside it on stderr") {
    const TempFolder folder;
    std::string wrong_sum = raw_png(4, 2, 8, 2, repeated(bytes({1, 2, 3})));
    wrong_sum[wrong_sum.find("IDAT") + 12] ^= 0x55;
    const std::string cut = raw_png(4, 2, 8, 2, repeated(bytes({1, 2, 3}))).substr(0, 60);
    const std::string webp = raw_webp(4, 2, bytes({1, 2, 3, 4})).substr(0, 26);
    const std::string heard = folder.file("stderr.txt");
    const int old = dup(2);
    for (const std::string& file : {folder.write("sum.png", wrong_sum), folder.write("cut.png", cut),
                                    folder.write("cut.webp", webp), folder.write("cut.tif", "II*\0\x08")}) {
        const int sink = open(heard.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
        dup2(sink, 2);
        const std::string message = message_of([&] { (void)read_image(file); });
        dup2(old, 2);
        close(sink);
        CAPTURE(message);
        CHECK(message.find(file + ": ") == 0);
        CHECK(message.find('\n') == std::string::npos);
        CHECK(message.find("PNG library error") == std::string::npos);
        CHECK_FALSE(message.ends_with(": "));
        CHECK(bytes_of(heard).empty());
    }
    close(old);
}

TEST_CASE("image errors: a long path is cut at its beginning") {
    const TempFolder folder;
    const std::string deep = std::string(40, 'd') + "/" + std::string(40, 'e') + "/";
    const auto complaint = [&](const std::string& name) {
        return message_of([&] {
            (void)read_scene_text("[environment]\nfile = '" + deep + name + "'\n", "s.toml", folder.path.string());
        });
    };
    CHECK(complaint("sky.hdr").find("eee/sky.hdr' is not there") != std::string::npos);
    const std::string long_name = std::string(80, 'n') + ".hdr";
    CHECK(complaint(long_name).find("'..." + long_name + "' is not there") != std::string::npos);
}
