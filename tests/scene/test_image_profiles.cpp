// Colour profiles in images, and files of several images: a word where a picture is not what it seems.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <zlib.h>

#include "scene/files/icc_profile.hpp"
#include "scene/files/load_maps.hpp"
#include "tests/scene/raw_images.hpp"
#include "tests/scene/raw_png.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using namespace kreda::scene;
using namespace kreda::tests;

namespace {

std::string fixed(double value) {
    return big_endian(static_cast<std::uint32_t>(std::lround(value * 65536.0)));
}

/// What a profile says of itself; primaries are XYZ under D50, one row a primary.
struct Icc {
    std::string name = "test";
    double primaries[3][3] = {{0.43607, 0.22249, 0.01392}, {0.38515, 0.71687, 0.09708}, {0.14307, 0.06061, 0.7141}};
    std::string curve = std::string("para\0\0\0\0\0\3\0\0", 12) + fixed(2.4) + fixed(1 / 1.055) + fixed(0.055 / 1.055) +
                        fixed(1 / 12.92) + fixed(0.04045);
    bool is_utf16 = false;
};

constexpr double kDisplayP3[3][3] = {{0.5151, 0.2412, -0.0011}, {0.292, 0.6922, 0.0419}, {0.1571, 0.0666, 0.7841}};

std::string gamma_curve(double gamma) {
    const auto number = static_cast<std::uint32_t>(std::lround(gamma * 256.0));
    return std::string("curv\0\0\0\0\0\0\0\1", 12) + static_cast<char>(number >> 8) + static_cast<char>(number & 255) +
           std::string(2, '\0');
}

/// A profile after ICC.1:2022, section 7: header, table of tags, their data.
std::string icc_profile(const Icc& icc) {
    std::string name =
        std::string("desc\0\0\0\0", 8) + big_endian(std::uint32_t(icc.name.size() + 1)) + icc.name + '\0';
    if (icc.is_utf16) {
        name = std::string("mluc\0\0\0\0\0\0\0\1\0\0\0\14enUS", 20) + big_endian(std::uint32_t(2 * icc.name.size())) +
               big_endian(28);
        for (const char letter : icc.name) name += std::string(1, '\0') + letter;
    }
    std::vector<std::pair<std::string, std::string>> tags = {{"desc", name}, {"rTRC", icc.curve}};
    const char* const names[] = {"rXYZ", "gXYZ", "bXYZ"};
    for (int p = 0; p < 3; ++p) {
        std::string xyz("XYZ \0\0\0\0", 8);
        for (const double value : icc.primaries[p]) xyz += fixed(value);
        tags.emplace_back(names[p], xyz);
    }
    std::string table = big_endian(std::uint32_t(tags.size())), data;
    for (auto& [tag, bytes] : tags) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        table += tag + big_endian(std::uint32_t(132 + 12 * tags.size() + data.size())) +
                 big_endian(std::uint32_t(bytes.size()));
        data += bytes;
    }
    const std::uint32_t size = std::uint32_t(128 + table.size() + data.size());
    std::string header = big_endian(size) + std::string(4, '\0') + std::string("\4\60\0\0mntrRGB XYZ ", 16);
    header.resize(36);
    header += "acsp";
    header.resize(128);
    return header + table + data;
}

/// A PNG's iCCP chunk: a name, 0, 0, the profile compressed.
std::string icc_chunk(const std::string& profile) {
    uLongf size = compressBound(static_cast<uLong>(profile.size()));
    std::string compressed(size, '\0');
    REQUIRE(compress(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(profile.data()),
                     static_cast<uLong>(profile.size())) == Z_OK);
    compressed.resize(size);
    return png_chunk("iCCP", std::string("icc\0\0", 5) + compressed);
}

std::string exr_attribute(const std::string& name, const std::string& type, const std::string& value) {
    return name + '\0' + type + '\0' + little_endian(value.size(), 4) + value;
}

/// An OpenEXR file of several parts (Technical Introduction to OpenEXR, "multi-part"), each of one grey texel.
std::string raw_parts(const std::vector<std::pair<std::string, std::string>>& names_and_floats) {
    const std::string window = little_endian(0, 16), one = std::string("\0\0\x80\x3f", 4);
    std::string file = std::string("\x76\x2f\x31\x01", 4) + little_endian(2 | 0x1000, 4);
    for (const auto& [name, value] : names_and_floats) {
        file += exr_attribute("channels", "chlist",
                              std::string("Y\0", 2) + little_endian(2, 4) + little_endian(0, 4) + little_endian(1, 4) +
                                  little_endian(1, 4) + '\0');
        file += exr_attribute("chunkCount", "int", little_endian(1, 4));
        file += exr_attribute("compression", "compression", std::string(1, '\0'));
        file += exr_attribute("dataWindow", "box2i", window) + exr_attribute("displayWindow", "box2i", window);
        file += exr_attribute("lineOrder", "lineOrder", std::string(1, '\0'));
        file += exr_attribute("name", "string", name);
        file += exr_attribute("pixelAspectRatio", "float", one);
        file += exr_attribute("screenWindowCenter", "v2f", std::string(8, '\0'));
        file += exr_attribute("screenWindowWidth", "float", one) + exr_attribute("type", "string", "scanlineimage");
        file += '\0';
    }
    file += '\0';
    const std::size_t first = file.size() + 8 * names_and_floats.size(), chunk = 16;
    std::string chunks;
    for (std::size_t part = 0; part < names_and_floats.size(); ++part) {
        file += little_endian(first + part * chunk, 8);
        chunks += little_endian(part, 4) + little_endian(0, 4) + little_endian(4, 4) + names_and_floats[part].second;
    }
    return file + chunks;
}

std::vector<std::string> warnings_of(const std::string& file, lighting::MapKind kind = lighting::MapKind::color) {
    std::vector<std::string> warnings;
    (void)load_texture(file, kind, false, warnings);
    return warnings;
}

}  // namespace

TEST_CASE("profiles: sRGB's primaries and curve are sRGB under any name, others are called by theirs") {
    CHECK(profile_other_than_srgb(icc_profile({})).empty());
    Icc icc;
    icc.name = "Display P3";
    std::copy_n(&kDisplayP3[0][0], 9, &icc.primaries[0][0]);
    CHECK(profile_other_than_srgb(icc_profile(icc)) == "Display P3");
    icc.is_utf16 = true;
    CHECK(profile_other_than_srgb(icc_profile(icc)) == "Display P3");
    Icc curved;
    curved.curve = gamma_curve(2.2);
    CHECK(profile_other_than_srgb(icc_profile(curved)).empty());  // 0.5^2.2 = 0.2176, sRGB has 0.2140
    curved.curve = gamma_curve(1.8);
    CHECK(profile_other_than_srgb(icc_profile(curved)) == "test");
    curved.curve = std::string("curv\0\0\0\0\0\0\0\0", 12);  // linear
    CHECK(profile_other_than_srgb(icc_profile(curved)) == "test");
    curved.curve = std::string("curv\0\0\0\0\0\0\0\3\0\0\x36\xc8\xff\xff", 18);  // a table: 0x36c8 / 65535 = 0.2140
    CHECK(profile_other_than_srgb(icc_profile(curved)).empty());
    curved.name = "";
    curved.curve = gamma_curve(1.0);
    CHECK(profile_other_than_srgb(icc_profile(curved)) == "a colour profile without a name");
}

TEST_CASE("profiles: cut or nonsensical ones never crash") {
    const std::string whole = icc_profile({});
    for (std::size_t length = 0; length < whole.size(); ++length) {
        (void)profile_other_than_srgb(std::string_view(whole).substr(0, length));
    }
    std::string wild = whole;
    for (std::size_t i = 128; i < wild.size(); ++i) {
        wild[i] = '\xff';
        (void)profile_other_than_srgb(wild);
    }
    CHECK(profile_other_than_srgb("").empty());
    CHECK(profile_other_than_srgb("no profile").empty());
}

TEST_CASE("profiles: a picture of other colours is one warning, and none where its numbers are no colours") {
    const TempFolder folder;
    Icc icc;
    icc.name = "Display P3";
    std::copy_n(&kDisplayP3[0][0], 9, &icc.primaries[0][0]);
    const std::string p3 = folder.write("p3.png", raw_png(1, 1, 8, 2, "abc", icc_chunk(icc_profile(icc))));
    const std::string srgb = folder.write("srgb.png", raw_png(1, 1, 8, 2, "abc", icc_chunk(icc_profile({}))));
    REQUIRE(warnings_of(p3).size() == 1);
    CHECK(warnings_of(p3)[0] == p3 + ": says that its colours are 'Display P3'; they are decoded as sRGB");
    CHECK(warnings_of(srgb).empty());
    CHECK(warnings_of(p3, lighting::MapKind::value).empty());
}

TEST_CASE("profiles: of an EXR of several parts the first is read, and named") {
    const TempFolder folder;
    const std::string half("\0\0\0\x3f", 4), one("\0\0\x80\x3f", 4);
    const std::string file = folder.write("parts.exr", raw_parts({{"diffuse", half}, {"beauty", one}}));
    std::vector<std::string> warnings;
    CHECK(load_texture(file, lighting::MapKind::value, false, warnings)->texels[0] == 0.5f);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0] == file + ": holds more than one image; the first is read, 'diffuse', and not 'beauty'");
    CHECK(warnings_of(folder.write("one.exr", raw_parts({{"beauty", one}})), lighting::MapKind::value).empty());
}
