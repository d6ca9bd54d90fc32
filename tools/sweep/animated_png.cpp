#include "tools/sweep/animated_png.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <zlib.h>

namespace kreda::tools {

namespace {

using Bytes = std::vector<unsigned char>;

constexpr std::size_t kSignature = 8;

struct Chunk {
    std::string type;
    std::span<const unsigned char> data;
};

std::uint32_t read_number(const unsigned char* at) {
    return std::uint32_t{at[0]} << 24 | std::uint32_t{at[1]} << 16 | std::uint32_t{at[2]} << 8 | at[3];
}

void append_number(Bytes& to, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<unsigned char>(number >> shift));
}

void append_short(Bytes& to, int number) {
    to.push_back(static_cast<unsigned char>(number >> 8));
    to.push_back(static_cast<unsigned char>(number));
}

/// Length, type, data, and the check sum of type and data.
void append_chunk(Bytes& to, const std::string& type, std::span<const unsigned char> data) {
    append_number(to, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = to.size();
    to.insert(to.end(), type.begin(), type.end());
    to.insert(to.end(), data.begin(), data.end());
    append_number(to, static_cast<std::uint32_t>(crc32(0, &to[begin], static_cast<uInt>(to.size() - begin))));
}

std::vector<Chunk> chunks_of(const Bytes& file) {
    std::vector<Chunk> chunks;
    for (std::size_t at = kSignature; at + 12 <= file.size();) {
        const std::size_t size = read_number(&file[at]);
        const std::string type(file.begin() + std::ptrdiff_t(at) + 4, file.begin() + std::ptrdiff_t(at) + 8);
        chunks.push_back({type, std::span(file).subspan(at + 8, size)});
        at += size + 12;
    }
    return chunks;
}

/// fcTL: the whole picture, shown for so long, replacing the one before.
Bytes frame_control(std::uint32_t sequence, std::span<const unsigned char> header, int milliseconds) {
    Bytes data;
    append_number(data, sequence);
    data.insert(data.end(), header.begin(), header.begin() + 8);  // width and height
    append_number(data, 0);
    append_number(data, 0);
    append_short(data, milliseconds);
    append_short(data, 1000);
    data.push_back(0);
    data.push_back(0);
    return data;
}

/// acTL: how many frames there are, and that they repeat for ever.
Bytes animation_control(std::size_t frame_count) {
    Bytes data;
    append_number(data, static_cast<std::uint32_t>(frame_count));
    append_number(data, 0);
    return data;
}

/// fdAT: the pixels of a later frame behind their number.
Bytes numbered(std::uint32_t sequence, std::span<const unsigned char> pixels) {
    Bytes data;
    append_number(data, sequence);
    data.insert(data.end(), pixels.begin(), pixels.end());
    return data;
}

}  // namespace

std::vector<unsigned char> animated_png(const std::vector<std::vector<unsigned char>>& frames, int milliseconds) {
    const Bytes& first = frames.at(0);
    Bytes file(first.begin(), first.begin() + kSignature);
    for (const Chunk& chunk : chunks_of(first)) {  // what stands before the pixels
        if (chunk.type == "IDAT") break;
        append_chunk(file, chunk.type, chunk.data);
        if (chunk.type == "IHDR") append_chunk(file, "acTL", animation_control(frames.size()));
    }
    std::uint32_t sequence = 0;
    for (const Bytes& frame : frames) {
        const std::vector<Chunk> chunks = chunks_of(frame);
        append_chunk(file, "fcTL", frame_control(sequence++, chunks[0].data, milliseconds));
        for (const Chunk& chunk : chunks) {
            if (chunk.type != "IDAT") continue;
            if (&frame == &first)
                append_chunk(file, "IDAT", chunk.data);
            else
                append_chunk(file, "fdAT", numbered(sequence++, chunk.data));
        }
    }
    append_chunk(file, "IEND", {});
    return file;
}

}  // namespace kreda::tools
