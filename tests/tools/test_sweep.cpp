// kreda sweep: its pictures are those of kreda render, its steps are even, its animations are whole files.
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <zlib.h>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/sweep/sheet.hpp"
#include "tools/sweep/sweep.hpp"
#include "tools/sweep/sweep_axis.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

using Strings = std::vector<std::string>;

void write_ball(const TempFolder& folder) {
    folder.write("ball.toml",
                 "[image]\nsize = [48, 32]\n[camera]\nposition = [0, 0, 3]\n[[light]]\nintensity = 2\n"
                 "[[material]]\nname = \"m\"\nmodel = \"cook_torrance\"\nalbedo = [0.9, 0.6, 0.3]\n"
                 "[[object]]\nmesh = \"sphere\"\ndetail = 16\nmaterial = \"m\"\n");
}

raster::Image rendered(const TempFolder& folder, const Strings& sets, const std::string& size) {
    Strings args{"render", "ball.toml", "-o", "one.png", "--size", size};
    for (const std::string& set : sets) args.insert(args.end(), {"--set", set});
    REQUIRE(run_kreda(args, folder.path.string()).exit_code == 0);
    return scene::read_image(folder.file("one.png"));
}

/// Is the picture somewhere in the sheet, pixel for pixel?
bool holds(const raster::Image& sheet, const raster::Image& picture) {
    const auto is_at = [&](int left, int top) {
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                if (sheet.rgb(left + x, top + y) != picture.rgb(x, y)) return false;
            }
        }
        return true;
    };
    for (int top = 0; top + picture.height <= sheet.height; ++top) {
        for (int left = 0; left + picture.width <= sheet.width; ++left) {
            if (is_at(left, top)) return true;
        }
    }
    return false;
}

struct PngChunk {
    std::string type, data;
    bool sum_is_right = false;
};

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

std::vector<PngChunk> chunks_in(const std::string& file) {
    std::vector<PngChunk> chunks;
    for (std::size_t at = 8; at + 12 <= file.size(); at += number_at(file, at) + 12) {
        const std::size_t size = number_at(file, at);
        const auto* begin = reinterpret_cast<const unsigned char*>(file.data()) + at + 4;
        const auto sum = static_cast<std::uint32_t>(crc32(0, begin, static_cast<uInt>(size + 4)));
        chunks.push_back({file.substr(at + 4, 4), file.substr(at + 8, size), sum == number_at(file, at + 8 + size)});
    }
    return chunks;
}

/// The bytes of all pixels of one frame, as they are packed.
std::string packed_frame(const std::vector<PngChunk>& chunks, int frame) {
    std::string packed;
    int current = -1;
    for (const PngChunk& chunk : chunks) {
        if (chunk.type == "fcTL") ++current;
        if (current != frame) continue;
        if (chunk.type == "IDAT") packed += chunk.data;
        if (chunk.type == "fdAT") packed += chunk.data.substr(4);
    }
    return packed;
}

std::string packed_pixels(const std::string& png) {
    std::string packed;
    for (const PngChunk& chunk : chunks_in(png)) {
        if (chunk.type == "IDAT") packed += chunk.data;
    }
    return packed;
}

}  // namespace

TEST_CASE("sweep: commas divide values, but not inside brackets and quotes") {
    CHECK(tools::listed_axis("fog.density=0.1,0.2,0.4").values == Strings{"0.1", "0.2", "0.4"});
    CHECK(tools::listed_axis("camera.position=[0,1,4],[4,1,0]").values == Strings{"[0,1,4]", "[4,1,0]"});
    CHECK(tools::listed_axis("shadow.filter=\"none\",\"p,f\"").values == Strings{"\"none\"", "\"p,f\""});
    CHECK(tools::listed_axis("fog.density=0.1").override_at(0) == "fog.density=0.1");
    for (const char* wrong : {"fog.density", "=1", "fog.density=", "fog.density=1,,2", "fog.density=1,"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(static_cast<void>(tools::listed_axis(wrong)), scene::UserError);
    }
}

TEST_CASE("sweep: steps are even, end where they are told to, and close a turn without showing it twice") {
    CHECK(tools::stepped_axis("fog.density=0..0.4", 5, false).values == Strings{"0", "0.1", "0.2", "0.3", "0.4"});
    CHECK(tools::stepped_axis("camera.orbit=0..360", 4, true).values == Strings{"0", "90", "180", "270"});
    CHECK(tools::stepped_axis("camera.position=[0, 1, 4]..[2, 1, -4]", 3, false).values ==
          Strings{"[0,1,4]", "[1,1,0]", "[2,1,-4]"});
    CHECK(tools::stepped_axis("fog.mode=\"exp\"", 3, false).values == Strings{"\"exp\""});
    for (const char* wrong : {"fog.density=a..b", "fog.density=0..", "camera.position=[0,1]..[1,2,3]"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(static_cast<void>(tools::stepped_axis(wrong, 3, false)), scene::UserError);
    }
}

TEST_CASE("sweep: the errors of two pictures by hand") {
    raster::Image a = raster::make_image(2, 1, 3), b = a;
    b.set_rgb(1, 0, {10.0f / 255.0f, 2.0f / 255.0f, 0.0f});
    const tools::PictureError error = tools::picture_error(b, a);
    CHECK(error.mean == 2.0);  // 12 codes over 6 values
    CHECK(error.worst == 10);
    CHECK(tools::picture_difference(b, a).rgb(1, 0) == glm::vec3(168.0f / 255.0f, 136.0f / 255.0f, 128.0f / 255.0f));
}

TEST_CASE("sweep: the pictures of a sheet are those of kreda render") {
    const TempFolder folder;
    write_ball(folder);
    const Outcome outcome = run_kreda({"sweep", "ball.toml", "--size", "30x20", "--set", "material.m.roughness=0.2,0.8",
                                       "--set", "material.m.metallic=0,1", "-o", "sheet.png"},
                                      folder.path.string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const raster::Image sheet = scene::read_image(folder.file("sheet.png"));
    for (const char* roughness : {"0.2", "0.8"}) {
        for (const char* metallic : {"0", "1"}) {
            const Strings sets{std::string("material.m.roughness=") + roughness,
                               std::string("material.m.metallic=") + metallic};
            CHECK(holds(sheet, rendered(folder, sets, "30x20")));
        }
    }
    CHECK_FALSE(holds(sheet, rendered(folder, {"material.m.roughness=0.5"}, "30x20")));
}

TEST_CASE("sweep: a sheet is as large as it is told, and what equals the chosen picture differs by nothing") {
    const TempFolder folder;
    write_ball(folder);
    const Outcome outcome = run_kreda({"sweep", "ball.toml", "--sheet", "640x360", "--set",
                                       "material.m.roughness=0.4,0.4,0.9", "--against", "1,1", "-o", "sheet.png"},
                                      folder.path.string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const raster::Image sheet = scene::read_image(folder.file("sheet.png"));
    CHECK(sheet.width <= 640);
    CHECK(sheet.width > 600);
    CHECK(sheet.height <= 360);
    const raster::Image grey = [] {
        raster::Image image = raster::make_image(100, 60, 3);
        for (float& value : image.values) value = 128.0f / 255.0f;
        return image;
    }();
    CHECK(holds(sheet, grey));
}

TEST_CASE("sweep: frames are the pictures of their steps, in a folder and in one animated PNG") {
    const TempFolder folder;
    write_ball(folder);
    const Strings common{"sweep", "ball.toml", "--size", "30x20", "--frames", "3", "--set", "camera.orbit=0..60"};
    for (const char* output : {"turn", "turn.png"}) {
        Strings args = common;
        args.insert(args.end(), {"-o", output});
        REQUIRE(run_kreda(args, folder.path.string()).exit_code == 0);
    }
    CHECK(names_in(folder.file("turn")) == Strings{"0001.png", "0002.png", "0003.png"});
    const std::string animation = bytes_of(folder.file("turn.png"));
    const std::vector<PngChunk> chunks = chunks_in(animation);
    for (const PngChunk& chunk : chunks) CHECK(chunk.sum_is_right);
    CHECK(chunks.back().type == "IEND");
    std::uint32_t sequence = 0;  // of fcTL and fdAT together, without a gap
    for (const PngChunk& chunk : chunks) {
        if (chunk.type == "acTL") CHECK(number_at(chunk.data, 0) == 3);
        if (chunk.type == "fcTL" || chunk.type == "fdAT") CHECK(number_at(chunk.data, 0) == sequence++);
    }
    const char* angles[] = {"0", "30", "60"};
    for (int i = 0; i < 3; ++i) {
        const std::string file = bytes_of(folder.file("turn/000" + std::to_string(i + 1) + ".png"));
        CHECK(packed_frame(chunks, i) == packed_pixels(file));
        static_cast<void>(rendered(folder, {std::string("camera.orbit=") + angles[i]}, "30x20"));
        CHECK(file == bytes_of(folder.file("one.png")));
    }
}

TEST_CASE("sweep: an orbit of 90 degrees about y takes the camera from +z to +x, and 360 leads back") {
    const auto position = [](const std::string& orbit) {
        return scene::read_scene_text("[camera]\nposition = [1, 2, 7]\ntarget = [1, 1, 3]\norbit = " + orbit + "\n",
                                      "orbit", "")
            .camera.position;
    };
    CHECK(position("0") == glm::vec3(1.0f, 2.0f, 7.0f));
    CHECK(glm::distance(position("90"), glm::vec3(5.0f, 2.0f, 3.0f)) < 1e-6f);  // roundings of 7
    CHECK(glm::distance(position("360"), glm::vec3(1.0f, 2.0f, 7.0f)) < 1e-6f);
}

TEST_CASE("sweep: what cannot be meant is one line with the remedy, and leaves no file") {
    const TempFolder folder;
    write_ball(folder);
    const Strings sheet{"sweep", "ball.toml", "-o", "s.png"};
    const auto says = [&](const Strings& more, const std::string& words) {
        Strings args = sheet;
        args.insert(args.end(), more.begin(), more.end());
        const Outcome outcome = run_kreda(args, folder.path.string());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(line_count(outcome.err) == 1);
        CHECK(outcome.err.find(words) != std::string::npos);
    };
    says({}, "no key has several values");
    says({"--set", "fog.density=1,2", "--set", "fog.start=1,2", "--set", "fog.end=3,4"}, "'fog.end' is the third");
    says({"--set", "material.m.roughness=0.1,2"}, "roughness");
    says({"--set", "material.m.roughness=0.1,0.2", "--against", "3,1"}, "from 1,1 to 2,1");
    says({"--set", "material.m.roughness=0.1,0.2", "--sheet", "9"}, "WIDTHxHEIGHT");
    says({"--set", "material.m.roughness=0.1,0.2", "--view", "nonsense"}, "no such view");
    says({"--frames", "3", "--set", "fog.density=0..x"}, "two numbers");
    CHECK(names_in(folder.path.string()) == Strings{"ball.toml"});
}
