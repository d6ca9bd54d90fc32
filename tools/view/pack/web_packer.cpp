// A module of its own, kept small: with `pack` for node at build time (KREDA_PACK), with `unpack` alone for the page.
// Both walk over the same bytes with the same predictions; a bit that was likely costs little.   I. Witten, R. Neal, J.
// Cleary, Arithmetic coding for data compression (1987)
#include "prediction.hpp"

namespace {

using namespace kreda::pack;

std::uint8_t plain[kBytes], packed[kBytes];
Prediction prediction{plain};

/// The interval that is left, as 32 bits: what a packer narrows and an unpacker finds its number in.
struct Interval {
    std::uint32_t low = 0, high = 0xffffffff;

    std::uint32_t split(float probability) const {
        const float p = probability * 65536;
        const std::uint32_t share = p < 4 ? 4 : p > 65532 ? 65532 : static_cast<std::uint32_t>(p);
        return low + static_cast<std::uint32_t>((std::uint64_t(high - low) * share) >> 16);
    }
    void keep(int bit, std::uint32_t middle) {
        (bit ? high : low) = bit ? middle : middle + 1;
    }
    bool has_byte() const {
        return (low ^ high) >> 24 == 0;
    }
    void shift() {
        low <<= 8;
        high = high << 8 | 255;
    }
};

/// Where unpacking stands between two calls.
struct Unpacking {
    Interval interval;
    std::uint32_t read = 0, number = 0, written = 0;
} unpacking;

}  // namespace

extern "C" {

/// Where the page puts packed bytes and node plain ones.
__attribute__((export_name("plain_bytes"))) std::uint8_t* plain_bytes() {
    return plain;
}
__attribute__((export_name("packed_bytes"))) std::uint8_t* packed_bytes() {
    return packed;
}

#ifdef KREDA_PACK
__attribute__((export_name("most_bytes"))) std::uint32_t most_bytes() {
    return kBytes;
}
/// How many bytes it becomes.
__attribute__((export_name("pack"))) std::uint32_t pack(std::uint32_t count) {
    prediction.start();
    Interval interval;
    std::uint32_t written = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        prediction.begin_byte();
        for (int k = 7; k >= 0; --k) {
            const int bit = plain[i] >> k & 1;
            interval.keep(bit, interval.split(prediction.probability()));
            prediction.learn(bit);
            for (; interval.has_byte(); interval.shift()) packed[written++] = interval.high >> 24;
        }
        prediction.end_byte();
    }
    for (int k = 0; k < 4; ++k, interval.shift()) packed[written++] = interval.high >> 24;
    return written;
}
#endif

/// The next bytes, up to the first `count` of all: a page calls it again and again, and says how far it is.
__attribute__((export_name("unpack"))) void unpack(std::uint32_t count) {
    auto [interval, read, number, written] = unpacking;
    if (read == 0) prediction.start();
    for (; read < 4; ++read) number = number << 8 | packed[read];
    // clang-tidy does not see that a binding changes.
    for (; written < count; ++written) {  // NOLINT(bugprone-infinite-loop)
        prediction.begin_byte();
        std::uint32_t byte = 0;
        for (int k = 0; k < 8; ++k) {
            const std::uint32_t middle = interval.split(prediction.probability());
            const int bit = number <= middle ? 1 : 0;
            byte = byte * 2 + bit;
            interval.keep(bit, middle);
            prediction.learn(bit);
            for (; interval.has_byte(); interval.shift()) number = number << 8 | packed[read++];
        }
        plain[written] = static_cast<std::uint8_t>(byte);
        prediction.end_byte();
    }
    unpacking = {interval, read, number, written};
}
}
