#include "scene/files/png_bytes.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <exception>

#include <png.h>

#include "scene/error.hpp"
#include "scene/files/deflate_strips.hpp"

namespace kreda::scene {

namespace {

struct Output {
    std::vector<unsigned char> bytes;
    char complaint[128] = "";
};

void append(png_structp png, png_bytep bytes, png_size_t count) {
    auto& output = *static_cast<Output*>(png_get_io_ptr(png));
    try {
        output.bytes.insert(output.bytes.end(), bytes, bytes + count);
    } catch (const std::exception&) {  // an exception must not cross a library of C
        png_error(png, "not enough memory");
    }
}

void flush_nothing(png_structp) {}

/// libpng's way out of an error: back to setjmp.
[[noreturn]] void jump_out(png_structp png, png_const_charp message) {
    auto& output = *static_cast<Output*>(png_get_error_ptr(png));
    std::snprintf(output.complaint, sizeof output.complaint, "%s", message);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// What stands before the pixels. The colour space as numbers as well, for viewers that do not know the name sRGB.
void write_header(png_structp png, png_infop info, const PngPicture& picture) {
    png_set_IHDR(png, info, png_uint_32(picture.width), png_uint_32(picture.height), 8,
                 picture.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
    png_set_oFFs(png, info, 0, 0, PNG_OFFSET_PIXEL);
    char key[] = "oiio:ColorSpace", text[] = "sRGB";  // what OpenImageIO reads back
    png_text note{};
    note.compression = PNG_TEXT_COMPRESSION_NONE;
    note.key = key;
    note.text = text;
    note.text_length = sizeof text - 1;
    png_set_text(png, info, &note, 1);
    png_write_info(png, info);
}

/// The rows as PNG compresses them: before each stands the number of its filter. Smooth pictures are smallest without
/// any (0), and deflate is done with them in half the time.
std::vector<unsigned char> unfiltered_rows(const PngPicture& picture) {
    const std::size_t row_size = std::size_t(picture.width) * std::size_t(picture.channels);
    std::vector<unsigned char> rows((row_size + 1) * std::size_t(picture.height));
    for (std::size_t y = 0; y < std::size_t(picture.height); ++y) {
        std::copy_n(picture.values.data() + y * row_size, row_size, rows.data() + y * (row_size + 1) + 1);
    }
    return rows;
}

/// False on an error; its text is then in the output. Nothing here has a destructor, which longjmp would skip.
bool write_picture(png_structp png, png_infop info, const PngPicture& picture,
                   const std::vector<std::vector<unsigned char>>& pixels) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    write_header(png, info, picture);
    const auto chunk = [&](const char* name, const unsigned char* bytes, std::size_t count) {
        png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), bytes, count);
    };
    for (const std::vector<unsigned char>& part : pixels) chunk("IDAT", part.data(), part.size());
    chunk("IEND", nullptr, 0);
    return true;
}

}  // namespace

std::vector<unsigned char> encode_png(const std::string& path, const PngPicture& picture) {
    const std::vector<std::vector<unsigned char>> pixels = deflate_strips(unfiltered_rows(picture));
    Output output;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, jump_out, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (png) png_set_write_fn(png, &output, append, flush_nothing);
    const bool is_written = info && write_picture(png, info, picture, pixels);
    png_destroy_write_struct(&png, &info);
    if (is_written) return std::move(output.bytes);
    throw UserError(Place{path}, "cannot be written: " + std::string(info ? output.complaint : "libpng has no memory"));
}

}  // namespace kreda::scene
