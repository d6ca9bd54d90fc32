// Letters on pictures: laws of their layout, and how much they cover.
#include <cmath>
#include <cstdlib>
#include <string>

#include <doctest/doctest.h>
#include <glm/common.hpp>

#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/draw/draw.hpp"
#include "tools/draw/markup.hpp"
#include "tools/draw/type.hpp"

using namespace kreda;
using namespace kreda::tools;

namespace {

const glm::vec3 kWhite(1.0f);

raster::Image black(int width, int height) {
    return make_board(width, height, glm::vec3(0.0f));
}

/// Says so, too.
bool no_typeface() {
    if (has_typeface()) return false;
    MESSAGE("SKIPPED: no typeface");
    return true;
}

/// Pixels' worth of white on a black picture.
double light_of(const raster::Image& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) sum += static_cast<double>(image.rgb(x, y).x);
    }
    return sum;
}

double light_of_text(const char* text, glm::vec2 start, float size) {
    raster::Image image = black(200, 120);
    draw_type(image, start, text, kWhite, size);
    return light_of(image);
}

double area_of(const TypeBox& box) {
    return static_cast<double>((box.high.x - box.low.x) * (box.high.y - box.low.y));
}

}  // namespace

TEST_CASE("markup: scripts and italics stand between dollars only") {
    const std::vector<TypeRun> runs = parse_markup("a_b $F_{82}(α^2)$ \\$5");
    REQUIRE(runs.size() == 7);
    CHECK(runs[0].text == U"a_b ");
    CHECK_FALSE(runs[0].italic);
    CHECK((runs[1].text == U"F" && runs[1].italic && runs[1].script == Script::none));
    CHECK((runs[2].text == U"82" && !runs[2].italic && runs[2].script == Script::sub));
    CHECK((runs[3].text == U"(" && !runs[3].italic));
    CHECK((runs[4].text == U"α" && runs[4].italic));
    CHECK((runs[5].text == U"2" && runs[5].script == Script::super));
    CHECK(runs[6].text == U") $5");
}

TEST_CASE("markup: what is no UTF-8 is shown as such and ends nothing") {
    CHECK(code_points("č\xff"
                      "ž") == U"č\ufffdž");
    CHECK(code_points("\xe2\x82") == U"\ufffd\ufffd");
    CHECK(code_points("€𝛼") == U"€𝛼");
}

TEST_CASE("type: a text is as wide as its letters one after the other") {
    if (no_typeface()) return;
    for (const char* text : {"roughness", "AVATAR", "čćžšđřěů", "Шта је сенка?"}) {
        float sum = 0.0f;
        for (const char32_t c : code_points(text)) {
            std::string letter;  // as UTF-8: these are below U+0800
            if (c >= 0x80)
                letter = {static_cast<char>(0xc0 | c >> 6), static_cast<char>(0x80 | (c & 0x3f))};
            else
                letter = static_cast<char>(c);
            sum += type_width(letter, 20.0f);
        }
        CAPTURE(text);
        CHECK(type_width(text, 20.0f) == doctest::Approx(sum).epsilon(1e-5));  // floats are added in another order
    }
    CHECK(type_width("width", 40.0f) == doctest::Approx(2.0f * type_width("width", 20.0f)).epsilon(1e-5));
}

TEST_CASE("type: letters of five languages are in the typeface") {
    if (no_typeface()) return;
    const TypeBox missing = type_ink({0.0f, 0.0f}, "\U000e0fff", 64.0f);  // a plane without letters
    for (const char* letter :
         {"č", "ć", "ž", "š", "đ", "ř", "ě", "ů", "Ж", "љ", "ћ", "α", "$α$", "π", "θ", "≤", "·", "²"}) {
        const TypeBox ink = type_ink({0.0f, 0.0f}, letter, 64.0f);
        CAPTURE(letter);
        CHECK(area_of(ink) > 0.0);
        CHECK_FALSE(area_of(ink) == doctest::Approx(area_of(missing)));
    }
}

TEST_CASE("type: a subscript reaches below the baseline and a superscript above what stands on it") {
    if (no_typeface()) return;
    const TypeBox x = type_ink({0.0f, 0.0f}, "$x$", 30.0f);
    const TypeBox sub = type_ink({0.0f, 0.0f}, "$x_0$", 30.0f), super = type_ink({0.0f, 0.0f}, "$x^0$", 30.0f);
    CHECK(x.high.y < 1.0f);
    CHECK(sub.high.y > 4.0f);
    CHECK(super.low.y < x.low.y - 4.0f);
    CHECK(super.high.y == doctest::Approx(x.high.y));
    CHECK(type_width("$x_0$", 30.0f) == doctest::Approx(type_width("$x^0$", 30.0f)));
}

TEST_CASE("type: ink stays in the box that is told of it and reaches its sides") {
    if (no_typeface()) return;
    const glm::vec2 start(7.3f, 40.6f);
    const char* text = "$E_{ab}$ gÖ^";
    raster::Image image = black(160, 60);
    draw_type(image, start, text, kWhite, 24.0f);
    const TypeBox ink = type_ink(start, text, 24.0f);
    glm::ivec2 low(1000), high(-1);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.rgb(x, y).x == 0.0f) continue;
            low = glm::min(low, glm::ivec2(x, y));
            high = glm::max(high, glm::ivec2(x + 1, y + 1));
        }
    }
    // Pixels are whole, the box is not; the box holds the control points of the curves, which may lie outside a little.
    for (int i = 0; i < 2; ++i) {
        CHECK(static_cast<float>(low[i]) >= std::floor(ink.low[i]));
        CHECK(static_cast<float>(low[i]) <= ink.low[i] + 2.0f);
        CHECK(static_cast<float>(high[i]) <= std::ceil(ink.high[i]));
        CHECK(static_cast<float>(high[i]) >= ink.high[i] - 2.0f);
    }
}

TEST_CASE("type: a rectangle covers its area wherever it stands") {
    if (no_typeface()) return;
    for (const glm::vec2 start : {glm::vec2(20.0f, 80.0f), glm::vec2(20.25f, 80.5f), glm::vec2(20.7f, 79.1f)}) {
        const double area = area_of(type_ink(start, "█", 50.0f));  // U+2588, a full block
        // Coverage comes in steps of 1/256 along a border of 2 (30 + 60) pixels, off by half a step each at most.
        CHECK(light_of_text("█", start, 50.0f) == doctest::Approx(area).epsilon(0.005));
    }
}

TEST_CASE("type: the area of letters grows with the square of their size") {
    if (no_typeface()) return;
    const double small = light_of_text("Bg", {10.0f, 90.0f}, 30.0f), large = light_of_text("Bg", {10.0f, 90.0f}, 60.0f);
    CHECK(large == doctest::Approx(4.0 * small).epsilon(0.01));  // the same outline, rounded to 1/64 pixel
}

TEST_CASE("type: letters are blended in linear light") {
    if (no_typeface()) return;
    raster::Image on_black = black(100, 80), on_grey = make_board(100, 80, glm::vec3(0.5f));
    draw_type(on_black, {10.2f, 60.3f}, "S", kWhite, 60.0f);
    draw_type(on_grey, {10.2f, 60.3f}, "S", kWhite, 60.0f);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 100; ++x) {
            const float coverage = on_black.rgb(x, y).x;
            CHECK(on_grey.rgb(x, y).x == doctest::Approx(0.5f + 0.5f * coverage).epsilon(1e-6));
        }
    }
}

TEST_CASE("type: what lies outside of the picture is cut off") {
    if (no_typeface()) return;
    raster::Image image = black(20, 20);
    for (const glm::vec2 start : {glm::vec2(-30.0f, 15.0f), glm::vec2(5.0f, -2.0f), glm::vec2(15.0f, 40.0f)}) {
        draw_type(image, start, "Wg", kWhite, 40.0f);
    }
    CHECK(light_of(image) < 400.0);
}

TEST_CASE("type: without a typeface one line says what to install and the slide is drawn all the same") {
    const tests::TempFolder folder;
    folder.write("ball.toml", "[image]\nsize = [24, 16]\n[[light]]\n[[object]]\nmesh = \"sphere\"\ndetail = 8\n");
    const auto slide = [&](const char* name) {
        return tests::run_kreda({"render", "ball.toml", "--slides", "dark", "-o", name}, folder.path.string());
    };
    setenv("KREDA_FONTS", folder.path.c_str(), 1);
    const tests::Outcome without = slide("without.png");
    unsetenv("KREDA_FONTS");
    CHECK(without.exit_code == 0);
    CHECK(without.err.find("fonts-dejavu-core") != std::string::npos);
    CHECK(without.err.find("fonts-dejavu-core") == without.err.rfind("fonts-dejavu-core"));
    const raster::Image plain = scene::read_image(folder.file("without.png"));
    CHECK(plain.width == 1920);
    if (no_typeface()) return;
    const tests::Outcome with = slide("with.png");
    CHECK(with.exit_code == 0);
    CHECK(with.err.find("fonts-dejavu-core") == std::string::npos);
    CHECK(scene::read_image(folder.file("with.png")).values != plain.values);  // the title
}
