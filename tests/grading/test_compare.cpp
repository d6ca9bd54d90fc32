// Comparing pictures: the traps that other comparers fall into, limits worked by hand, and the command.
#include <cmath>
#include <limits>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/compare/compare.hpp"
#include "tools/compare/compare_pictures.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::tools;
using raster::Image;

namespace {

constexpr int kWidth = 320, kHeight = 180;  // 57600 pixels: 288 may differ, 16 by more than a code

/// A picture without symmetry: every channel another slope, so that a flip, a swap or a gamma changes most pixels.
Image some_picture(int width = kWidth, int height = kHeight) {
    Image image = raster::make_image(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = float(x) / float(width), v = float(y) / float(height);
            image.set_rgb(x, y, {0.1f + 0.8f * u, 0.2f + 0.5f * v, 0.5f + 0.4f * u * v});
        }
    }
    for (float& value : image.values) value = float(scene::byte_from_encoded(value)) / 255.0f;
    return image;
}

void add_codes(Image& image, int c, int x, int y, int codes) {
    image.at(c, x, y) += float(codes) / 255.0f;
}

const Measurement& check_named(const Comparison& result, const std::string& name) {
    for (const Measurement& check : result.checks) {
        if (check.name == name) return check;
    }
    FAIL("there is no check " << name);
    return result.checks.front();
}

}  // namespace

TEST_CASE("compare: a picture and its copy are identical") {
    const Comparison result = compare(some_picture(), some_picture());
    CHECK(result.passed);
    CHECK(result.identical);
    CHECK(result.differing == 0);
}

TEST_CASE("compare: 8 pixels of one code pass and are counted") {
    Image image = some_picture();
    for (int i = 0; i < 8; ++i) add_codes(image, i % 3, 20 * i + 3, 10 * i + 5, i % 2 == 0 ? 1 : -1);
    const Comparison result = compare(image, some_picture());
    CHECK(result.passed);
    CHECK_FALSE(result.identical);
    CHECK(result.differing == 8);
    CHECK(result.worst.steps == 1.0);
}

TEST_CASE("compare: the traps of other comparers fail") {
    const Image expected = some_picture();
    SUBCASE("all values are NaN") {
        Image image = expected;
        std::fill(image.values.begin(), image.values.end(), std::numeric_limits<float>::quiet_NaN());
        const Comparison result = compare(image, expected);
        CHECK_FALSE(result.passed);
        CHECK(check_named(result, "values not finite").value == double(expected.values.size()));
        CHECK_FALSE(compare(image, image).passed);
    }
    SUBCASE("one value is infinite") {
        Image image = expected;
        image.at(2, 300, 170) = std::numeric_limits<float>::infinity();
        CHECK_FALSE(compare(image, expected).passed);
    }
    SUBCASE("another size") {
        CHECK_FALSE(compare(some_picture(kWidth, kHeight - 1), expected).passed);
        CHECK_FALSE(compare(some_picture(kHeight, kWidth), expected).passed);
    }
    SUBCASE("one channel more") {
        Image image = raster::make_image(kWidth, kHeight, 4);
        std::copy(expected.values.begin(), expected.values.end(), image.values.begin());
        CHECK_FALSE(compare(image, expected).passed);
    }
    SUBCASE("gamma 1.1") {
        Image image = expected;
        for (float& value : image.values) value = std::pow(value, 1.0f / 1.1f);
        CHECK_FALSE(compare(image, expected).passed);
    }
    SUBCASE("upside down and left for right") {
        Image rows = expected, columns = expected;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                rows.set_rgb(x, y, expected.rgb(x, kHeight - 1 - y));
                columns.set_rgb(x, y, expected.rgb(kWidth - 1 - x, y));
            }
        }
        CHECK_FALSE(compare(rows, expected).passed);
        CHECK_FALSE(compare(columns, expected).passed);
    }
    SUBCASE("one missing block of 16 x 16") {
        Image image = expected;
        for (int y = 64; y < 80; ++y) {
            for (int x = 96; x < 112; ++x) image.set_rgb(x, y, glm::vec3(0.0f));
        }
        const Comparison result = compare(image, expected);
        CHECK_FALSE(result.passed);
        CHECK(result.differing == 256);  // fewer than the 288 that may differ at all
        CHECK(check_named(result, "pixels that differ").ok);
        CHECK(check_named(result, "largest blob of those").value == 256.0);
    }
    SUBCASE("red and blue swapped") {
        Image image = expected;
        std::swap_ranges(image.values.begin(), image.values.begin() + kWidth * kHeight,
                         image.values.begin() + 2 * kWidth * kHeight);
        CHECK_FALSE(compare(image, expected).passed);
    }
}

TEST_CASE("compare: each tier stops at its limit and not before") {
    const Image expected = some_picture();
    SUBCASE("288 of 57600 pixels by one code are 0.5 percent") {
        Image image = expected;
        for (int i = 0; i < 288; ++i) add_codes(image, 0, i, 90, 1);
        CHECK(compare(image, expected).passed);
        add_codes(image, 0, 300, 90, 1);
        const Comparison result = compare(image, expected);
        CHECK_FALSE(result.passed);
        CHECK(check_named(result, "pixels that differ").limit == 288.0);
    }
    SUBCASE("16 pixels by more than one code") {
        Image image = expected;
        for (int i = 0; i < 16; ++i) add_codes(image, 1, 4 + 10 * i, 7, 2);
        CHECK(compare(image, expected).passed);
        add_codes(image, 1, 200, 100, 2);
        CHECK_FALSE(compare(image, expected).passed);
    }
    SUBCASE("4 pixels that touch at their corners") {
        Image image = expected;
        for (int i = 0; i < 4; ++i) add_codes(image, 1, 50 + i, 60 + i, 3);
        CHECK(compare(image, expected).passed);
        add_codes(image, 1, 54, 64, 3);
        const Comparison result = compare(image, expected);
        CHECK_FALSE(result.passed);
        CHECK(check_named(result, "largest blob of those").value == 5.0);
    }
}

TEST_CASE("compare: blobs do not reach from the last column to the first of the next row") {
    Image image = some_picture();
    for (const int y : {10, 11, 12}) {
        add_codes(image, 1, kWidth - 1, y, 5);
        add_codes(image, 1, 0, y + 1, 5);
    }
    CHECK(check_named(compare(image, some_picture()), "largest blob of those").value == 3.0);
}

TEST_CASE("compare: with a mask only its pixels may differ by more than a step") {
    const Image expected = some_picture();
    Image mask = raster::make_image(kWidth, kHeight, 1);
    mask.at(0, 30, 40) = 1.0f;
    Image image = expected;
    add_codes(image, 1, 30, 40, 20);
    add_codes(image, 1, 100, 40, 1);
    CHECK(compare(image, expected, {}, {}, &mask).passed);
    add_codes(image, 1, 101, 40, 2);
    CHECK(compare(image, expected).passed);
    const Comparison result = compare(image, expected, {}, {}, &mask);
    CHECK_FALSE(result.passed);
    CHECK(check_named(result, "outside of the mask").value == 1.0);
    const Image wrong = raster::make_image(kWidth, kHeight + 1, 1);
    CHECK_FALSE(compare(image, expected, {}, {}, &wrong).passed);
}

TEST_CASE("compare: the worst pixel has both values") {
    Image image = some_picture();
    add_codes(image, 0, 7, 9, -4);
    add_codes(image, 2, 120, 88, 11);
    const Comparison result = compare(image, some_picture());
    CHECK(result.worst.x == 120);
    CHECK(result.worst.y == 88);
    CHECK(result.worst.steps == 11.0);
    REQUIRE(result.worst.actual.size() == 3);
    CHECK(result.worst.actual[2] - result.worst.expected[2] == 11.0);
    CHECK(result.worst.actual[0] == result.worst.expected[0]);
}

TEST_CASE("compare: a step of floating-point numbers is 1/255 of what is expected but of 1/16 at least") {
    Image expected = raster::make_image(1, 3, 1), image = expected;
    expected.values = {8.0f, 1.0f, 0.0f};
    image.values = {8.0f * (1.0f + 2.0f / 255.0f), 1.0f - 2.0f / 255.0f, 2.0f / 255.0f / 16.0f};
    const Comparison result = compare(image, expected, {0});
    for (const float steps : result.steps) CHECK(steps == doctest::Approx(2.0).epsilon(1e-4));  // rounding of 8.06
    image.values = {8.0f * (1.0f + 1e-6f), 1.0f - 1e-6f, 1e-6f};  // about 16 times the rounding of one operation
    CHECK(compare(image, expected, {0}, kExact).passed);
    CHECK_FALSE(compare(image, expected, {0}, kExact).identical);
}

TEST_CASE("compare: the heat map is grey where nothing differs and red where much does") {
    Image image = some_picture();
    add_codes(image, 1, 5, 6, 1);
    add_codes(image, 1, 50, 60, 90);
    const Comparison result = compare(image, some_picture());
    const Image map = heat_map(result, some_picture(), {});
    const glm::vec3 same = map.rgb(0, 0), one = map.rgb(5, 6), many = map.rgb(50, 60);
    CHECK(same.x == same.y);
    CHECK(same.y == same.z);
    CHECK(one.z > one.x);
    CHECK(many.x > 2.0f * many.z);
}

TEST_CASE("compare: the command answers with its exit code in text and JSON and pictures") {
    const TempFolder folder;
    const Image expected = some_picture();
    Image close = expected, wrong = expected;
    add_codes(close, 1, 10, 10, 1);
    for (int y = 64; y < 80; ++y) {
        for (int x = 96; x < 112; ++x) wrong.set_rgb(x, y, glm::vec3(0.0f));
    }
    scene::write_png(folder.file("golden.png"), expected);
    scene::write_png(folder.file("close.png"), close);
    scene::write_png(folder.file("wrong.png"), wrong);
    folder.write("broken.png", "no picture");
    const std::string at = folder.path.string();

    const Outcome same = run_kreda({"compare", "golden.png", "golden.png"}, at);
    CHECK(same.exit_code == 0);
    CHECK(same.out.find("A and B are identical\n") != std::string::npos);
    const Outcome within = run_kreda({"compare", "close.png", "golden.png"}, at);
    CHECK(within.exit_code == 0);
    CHECK(within.out.find("the same within the limits") != std::string::npos);
    CHECK(run_kreda({"compare", "close.png", "golden.png", "--differing", "0"}, at).exit_code == 1);

    const Outcome differ =
        run_kreda({"compare", "wrong.png", "golden.png", "--heat-map", "heat.png", "--side-by-side", "both.png"}, at);
    CHECK(differ.exit_code == 1);
    CHECK(differ.out.find("worst pixel (") != std::string::npos);
    CHECK(scene::read_image(folder.file("heat.png")).width == kWidth);
    CHECK(scene::read_image(folder.file("both.png")).width == 3 * kWidth + 4 * 8);

    const Outcome json = run_kreda({"compare", "wrong.png", "golden.png", "--format", "json"}, at);
    CHECK(json.exit_code == 1);
    const nlohmann::json parsed = nlohmann::json::parse(json.out);
    CHECK(parsed["passed"] == false);
    CHECK(parsed["worst"]["a"] == std::vector<double>{0.0, 0.0, 0.0});

    for (const char* file : {"broken.png", "absent.png", "."}) {
        CAPTURE(file);
        const Outcome unreadable = run_kreda({"compare", file, "golden.png"}, at);
        CHECK(unreadable.exit_code == 2);
        CHECK(unreadable.out.empty());
        CHECK(line_count(unreadable.err) == 1);
    }
}

TEST_CASE("compare: files with other numbers or channels or all NaN are not the same") {
    const TempFolder folder;
    const std::string at = folder.path.string();
    Image grey = raster::make_image(16, 16, 3);
    std::fill(grey.values.begin(), grey.values.end(), 0.5f);
    scene::write_exr(folder.file("grey.exr"), grey);
    scene::write_exr(folder.file("named.exr"), grey, {"X", "Y", "Z"});
    scene::write_png(folder.file("grey.png"), grey);
    std::fill(grey.values.begin(), grey.values.end(), std::numeric_limits<float>::quiet_NaN());
    scene::write_exr(folder.file("nan.exr"), grey);
    CHECK(run_kreda({"compare", "grey.exr", "grey.exr"}, at).exit_code == 0);
    CHECK(run_kreda({"compare", "nan.exr", "grey.exr"}, at).exit_code == 1);
    CHECK(run_kreda({"compare", "nan.exr", "nan.exr"}, at).exit_code == 1);
    CHECK(run_kreda({"compare", "grey.png", "grey.exr"}, at).exit_code == 1);
    const Outcome named = run_kreda({"compare", "named.exr", "grey.exr"}, at);
    CHECK(named.exit_code == 1);
    CHECK(named.out.find("FAIL  names of channels") != std::string::npos);
}
