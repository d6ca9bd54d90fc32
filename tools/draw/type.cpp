#include "tools/draw/type.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <glm/common.hpp>

#include "tools/draw/font_files.hpp"
#include "tools/draw/markup.hpp"

namespace kreda::tools {

namespace {

constexpr float kScriptSize = 0.7f;     ///< of the text's size
constexpr float kSubDrop = 0.22f;       ///< of the text's size, below the baseline
constexpr float kSuperRise = 0.36f;     ///< above it
constexpr FT_Fixed kSlant = 0x3366;     ///< 0.2 in 16.16: how far upright letters lean where there are no italic ones
constexpr float kFreeTypeUnit = 64.0f;  ///< FreeType counts 1/64 pixels, y up

/// A font file that is open. One thread at a time may use it.
struct OpenFont {
    FT_Face face = nullptr;
    bool slanted = false;
};

/// The library and its two fonts; a thread opens them when it writes its first text.
struct Typeface {
    FT_Library library = nullptr;
    OpenFont upright, italic;

    Typeface() {
        if (FT_Init_FreeType(&library) != 0) return;
        const FontFiles files = find_font_files();
        if (!files.upright.empty()) open(files.upright, upright);
        if (!upright.face) return;
        if (!files.italic.empty()) open(files.italic, italic);
        if (!italic.face) italic = {upright.face, true};
    }
    ~Typeface() {
        if (library) FT_Done_FreeType(library);  // closes the faces, too
    }
    Typeface(const Typeface&) = delete;
    Typeface& operator=(const Typeface&) = delete;

    void open(const std::string& file, OpenFont& font) const {
        if (FT_New_Face(library, file.c_str(), 0, &font.face) != 0) font.face = nullptr;
    }
};

Typeface& typeface() {
    thread_local Typeface opened;
    return opened;
}

/// A letter with its place on the baseline.
struct PlacedGlyph {
    OpenFont font;
    FT_UInt index = 0;
    float size = 0.0f;
    glm::vec2 origin{0.0f};
};

struct Line {
    std::vector<PlacedGlyph> glyphs;
    float advance = 0.0f;
};

bool set_size(const OpenFont& font, float size) {
    const auto units = static_cast<FT_F26Dot6>(std::lround(std::max(size, 1.0f) * kFreeTypeUnit));
    return FT_Set_Char_Size(font.face, units, units, 72, 72) == 0;
}

bool load(const PlacedGlyph& glyph) {
    if (!set_size(glyph.font, glyph.size)) return false;
    if (FT_Load_Glyph(glyph.font.face, glyph.index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) return false;
    FT_Matrix lean = {0x10000, kSlant, 0, 0x10000};
    if (glyph.font.slanted) FT_Outline_Transform(&glyph.font.face->glyph->outline, &lean);
    return true;
}

float advance_of(const PlacedGlyph& glyph) {
    return load(glyph) ? static_cast<float>(glyph.font.face->glyph->linearHoriAdvance) / 65536.0f : 0.0f;
}

/// Letters from left to right; each begins where the one before it ends.
Line set_line(std::string_view markup, float size) {
    Line line;
    if (!has_typeface()) return line;
    const Typeface& type = typeface();
    for (const TypeRun& run : parse_markup(markup)) {
        const float drop = run.script == Script::sub ? kSubDrop : run.script == Script::super ? -kSuperRise : 0.0f;
        for (const char32_t c : run.text) {
            OpenFont font = run.italic ? type.italic : type.upright;
            if (FT_Get_Char_Index(font.face, c) == 0) font = type.upright;
            PlacedGlyph glyph{font,
                              FT_Get_Char_Index(font.face, c),
                              run.script == Script::none ? size : kScriptSize * size,
                              {line.advance, drop * size}};
            line.advance += advance_of(glyph);
            line.glyphs.push_back(glyph);
        }
    }
    return line;
}

/// Blend the coverage that FreeType found for a glyph; (left, top) is its first pixel.
void blend_bitmap(raster::Image& image, const FT_Bitmap& bitmap, int left, int top, const glm::vec3& color) {
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
        for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
            const int x = left + column, y = top + row;
            if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
            const float coverage = static_cast<float>(bitmap.buffer[row * bitmap.pitch + column]) / 255.0f;
            image.set_rgb(x, y, glm::mix(image.rgb(x, y), color, coverage));
        }
    }
}

}  // namespace

float least_type_size(int picture_height) {
    return static_cast<float>(picture_height) / 30.0f;
}

bool has_typeface() {
    static const bool found = [] {
        if (typeface().upright.face) return true;
        std::cerr << missing_font_message() << '\n';
        return false;
    }();
    return found && typeface().upright.face;
}

float type_width(std::string_view markup, float size) {
    return set_line(markup, size).advance;
}

TypeBox type_ink(glm::vec2 start, std::string_view markup, float size) {
    TypeBox ink{start, start};
    bool any = false;
    for (const PlacedGlyph& glyph : set_line(markup, size).glyphs) {
        if (!load(glyph) || glyph.font.face->glyph->outline.n_points == 0) continue;
        FT_BBox box;
        FT_Outline_Get_CBox(&glyph.font.face->glyph->outline, &box);
        const glm::vec2 at = start + glyph.origin;
        const glm::vec2 low = at + glm::vec2(box.xMin, -box.yMax) / kFreeTypeUnit;
        const glm::vec2 high = at + glm::vec2(box.xMax, -box.yMin) / kFreeTypeUnit;
        ink = any ? TypeBox{glm::min(ink.low, low), glm::max(ink.high, high)} : TypeBox{low, high};
        any = true;
    }
    return ink;
}

void draw_type(raster::Image& image, glm::vec2 start, std::string_view markup, const glm::vec3& color, float size) {
    for (const PlacedGlyph& glyph : set_line(markup, size).glyphs) {
        if (!load(glyph)) continue;
        const glm::vec2 at = start + glyph.origin, whole = glm::floor(at);
        const glm::vec2 rest = kFreeTypeUnit * (at - whole);
        FT_GlyphSlot slot = glyph.font.face->glyph;
        FT_Outline_Translate(&slot->outline, std::lround(rest.x), -std::lround(rest.y));
        if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) continue;
        blend_bitmap(image, slot->bitmap, static_cast<int>(whole.x) + slot->bitmap_left,
                     static_cast<int>(whole.y) - slot->bitmap_top, color);
    }
}

}  // namespace kreda::tools
