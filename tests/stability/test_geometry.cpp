// Scales and shapes at the edges: with every kind of light and every shadow method the picture stays what it is.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "scene/render/threads.hpp"

using namespace kreda;

namespace {

struct Setting {
    std::string light, method;
};

/// Planar shadows fall on a floor, maps and the others on everything; a spot is a point light with one picture.
std::vector<Setting> settings() {
    std::vector<Setting> all;
    for (const char* const light : {"directional", "point", "spot"}) {
        for (const char* const method : {"map", "planar", "volume", "irregular", "exact"})
            all.push_back({light, method});
    }
    return all;
}

std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    return std::string(text).find_first_of(".en") == std::string::npos ? std::string(text) + ".0" : text;
}

std::string place(double x, double y, double z) {
    return "[" + number(x) + ", " + number(y) + ", " + number(z) + "]";
}

/// What may be at its edges; the scene is a ball on a floor.
struct Extreme {
    double scale = 1.0;    ///< of the whole scene
    double offset = 0.0;   ///< of the whole scene, along each axis
    double near = 1.0;     ///< in scales
    double far = 20.0;     ///< in scales
    double stretch = 1.0;  ///< of the ball's width: a sliver where it is small
    double floor = 4.0;    ///< half the floor's side, in scales: beyond the camera w passes through 0
    double wall = 0.0;     ///< half the side of a wall behind the ball, and the camera looks straight at it; 0: none
    double speck = 0.0;    ///< the radius of another ball in the air; 0: none
    std::string size = "[64, 48]";
};

/// A place of the scene, given in scales.
std::string place_in(const Extreme& e, double x, double y, double z) {
    return place(x * e.scale + e.offset, y * e.scale + e.offset, z * e.scale + e.offset);
}

/// Under parallel rays the wall casts nothing: their map would begin where the wall does, far before what is seen, and
/// its bias is a share of that.
std::string objects_of(const Extreme& e, bool wall_casts) {
    const double s = e.scale;
    const std::string ball = "[[object]]\nmesh = \"sphere\"\ndetail = 12\n", plane = "[[object]]\nmesh = \"plane\"\n";
    std::string text = ball + "scale = " + place(e.stretch * s, s, s) + "\ntranslate = " + place_in(e, 0.0, 1.0, 0.0) +
                       "\n" + plane + "scale = " + number(e.floor * s) + "\ntranslate = " + place_in(e, 0.0, 0.0, 0.0) +
                       "\n";
    if (e.wall > 0.0)
        text += plane + (wall_casts ? "" : "casts_shadow = false\n") +
                "rotate = [90, 0, 0]\nscale = " + number(e.wall * s) + "\ntranslate = " + place_in(e, 0.0, 0.0, -1.0) +
                "\n";
    if (e.speck > 0.0)
        text += ball + "scale = " + number(e.speck * s) + "\ntranslate = " + place_in(e, 1.0, 2.0, 2.0) + "\n";
    return text;
}

raster::Image draw(const Extreme& e, const Setting& setting) {
    const double s = e.scale, eye_x = e.wall > 0.0 ? 0.0 : 1.0, eye_y = e.wall > 0.0 ? 0.75 : 2.5;
    const std::string text = "[image]\nsize = " + e.size +
                             "\nbackground = [0.2, 0.3, 0.4]\n[camera]\nposition = " + place_in(e, eye_x, eye_y, 5.0) +
                             "\ntarget = " + place_in(e, 0.0, 0.75, 0.0) + "\nnear = " + number(e.near * s) +
                             "\nfar = " + number(e.far * s) + "\n[[light]]\nshadow = true\ntype = \"" + setting.light +
                             "\"\nposition = " + place_in(e, 2.0, 5.0, 1.5) +
                             "\ndirection = [-2.0, -5.0, -1.5]\n[shadow]\nsize = 128\nmethod = \"" + setting.method +
                             "\"\n" + objects_of(e, setting.light != "directional");
    return render(scene::read_scene_text(text, "extreme", ""));
}

/// Pixels that differ by more than 2 %: those on an edge of the ball or of a shadow may fall to the other side.
int differing_pixels(const raster::Image& a, const raster::Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const glm::vec3 d = glm::abs(a.rgb(x, y) - b.rgb(x, y));
            count += !(std::max({d.x, d.y, d.z}) <= 0.02f);
        }
    }
    return count;
}

/// No NaN, no infinity, nothing negative, and something in it.
bool is_light(const raster::Image& film) {
    float most = 0.0f;
    for (const float value : film.values) {
        if (!raster::is_finite(value) || value < 0.0f) return false;
        most = std::max(most, value);
    }
    return most > 0.0f;
}

struct GeometryRow {
    std::string what;
    Extreme extreme;
    int most_pixels = 0;  ///< that may differ from the plain picture
};

/// The rows of the page's table: each is compared with the same picture at scale 1.
void check_row(const GeometryRow& row, const Extreme& plain) {
    const scene::ThreadLimit one_thread(1);  // waking another costs more than drawing so small a picture
    int worst = 0, drawn = 0;
    std::string where = "all";
    for (const Setting& setting : settings()) {
        CAPTURE(row.what);
        CAPTURE(setting.light);
        CAPTURE(setting.method);
        const raster::Image picture = draw(row.extreme, setting);
        CHECK(is_light(picture));
        const int differing = differing_pixels(draw(plain, setting), picture);
        CHECK(differing <= row.most_pixels);
        if (differing > worst) where = setting.light + ", " + setting.method;
        worst = std::max(worst, differing);
        ++drawn;
    }
    const std::string text = "| " + row.what + " | " + std::to_string(drawn) + " | " + std::to_string(worst) +
                             (worst > 0 ? " (" + where + ")" : "") + " |";
    std::ostringstream page;
    page << std::ifstream(KREDA_SOURCE_DIR "/docs/97_extremes.md").rdbuf();
    const bool is_on_page = page.str().find(text + "\n") != std::string::npos;
    CHECK_MESSAGE(is_on_page, "docs/97_extremes.md needs the row\n", text);
    if (std::getenv("KREDA_PRINT_FORMULAS")) std::cout << text << "\n";
}

Extreme scaled(double scale) {
    Extreme e;
    e.scale = scale;
    return e;
}

}  // namespace

TEST_CASE("geometry: scales from 1e-8 to 1e7 give the same picture with every light and shadow") {
    check_row({"everything 1e-8 times as large", scaled(1e-8), 16}, {});
    check_row({"everything 1e4 times as large", scaled(1e4), 16}, {});
    check_row({"everything 1e7 times as large", scaled(1e7), 16}, {});  // no number in a file is beyond 1e9
}

TEST_CASE("geometry: 1e4, 1e6 and 1e8 away from the origin the picture is the same with every light and shadow") {
    for (const char* const away : {"1e4", "1e6", "1e8"}) {
        Extreme moved;
        moved.offset = std::stod(away);
        check_row({"everything " + std::string(away) + " away from the origin, along each axis", moved, 16}, {});
    }
}

TEST_CASE("geometry: a far plane a thousand million times as far as the near one gives the same picture") {
    Extreme deep;
    deep.near = 1e-3;
    deep.far = 1e6;
    check_row({"far / near = 1e9", deep, 16}, {});
}

TEST_CASE("geometry: a floor that runs through the camera's plane and beyond looks as far as it is seen") {
    Extreme wide, wider;
    wide.floor = 1e3;
    wider.floor = 1e4;
    wide.far = wider.far = 500.0;
    check_row({"a floor of 1e4 through w = 0, beside one of 1e3", wider, 60}, wide);
}

TEST_CASE("geometry: triangles of 1e7 pixels and of 1e-7 leave the picture what it is") {
    Extreme wall, wide_wall, speck;
    wall.wall = 10.0;
    wide_wall.wall = 0.5e7 * 6.0 * 2.0 * std::tan(std::numbers::pi / 8.0) / 48.0;  // 6 away, 45 degrees in 48 rows
    speck.speck = 1e-8;  // its triangles are 12 around, 3 away: a pixel is 0.05 there
    check_row({"a wall of two triangles of 1e7 x 1e7 pixels, beside one of 97 x 97", wide_wall, 60}, wall);
    check_row({"another ball of triangles of 1e-7 pixels", speck, 16}, {});
}

TEST_CASE("geometry: slivers and pictures of one pixel or one column are light") {
    Extreme sliver, flat, pixel, column;
    sliver.stretch = 1e-7;
    flat.stretch = 1e-5;
    check_row({"a ball 1e-7 wide, beside one of 1e-5", sliver, 16}, flat);
    pixel.size = "[1, 1]";
    column.size = "[1, 16384]";
    for (const Setting& setting : settings()) {
        CAPTURE(setting.light);
        CAPTURE(setting.method);
        CHECK(is_light(draw(pixel, setting)));
        if (setting.method == "exact") CHECK(is_light(draw(column, setting)));
    }
}
