// How likely the next bit of a module is 1, from the bits before: many tables of what came in a context, and a mixer
// that learns which of them to believe. The same steps pack and unpack, with floats, which are the same in every
// browser.
//   M. Mahoney, Adaptive weighing of context models for lossless data compression (2005): mixing, tables, counts
#pragma once

#include <cstdint>

#include "wasm_fields.hpp"

namespace kreda::pack {

constexpr int kContexts = 16;
constexpr int kFollowed = 3;              ///< contexts of which the last bytes are a context of their own
constexpr int kLines = 1 << 17;           ///< of a context's table, one for half a byte in a context
constexpr int kBytes = 1 << 22;           ///< the longest module
constexpr std::uint32_t kMostCount = 30;  ///< from here on a probability moves by a constant share
constexpr int kInputs = 2 * kContexts + 4;

/// Four numbers at a time.
using Lanes = float __attribute__((vector_size(16)));
using Ints = std::uint32_t __attribute__((vector_size(16)));

using Signed = std::int32_t __attribute__((vector_size(16)));

/// Numbers below 2^31 as floats and back: as numbers with a sign, which all processors convert.
inline Lanes as_floats(Ints numbers) {
    return __builtin_convertvector(reinterpret_cast<Signed>(numbers), Lanes);
}
inline Ints as_numbers(Lanes floats) {
    return reinterpret_cast<Ints>(__builtin_convertvector(floats, Signed));
}

/// A probability with 22 bits, and below it with 10 bits how often it was corrected.
using Counted = std::uint32_t;
constexpr Counted kEven = 1u << 31;

/// What came in a context: its name, and a probability for each way through half a byte.
struct Line {
    std::uint32_t name;
    Counted ways[15];
};

/// ln(p / (1 - p)) and its inverse, in tables.
class Logistic {
public:
    Logistic() {
        // e^(1/256), by its series, to the power of i: the same in every browser, which their Math.exp is not
        const double step = 1 + 1 / 256.0 + 1 / 131072.0 + 1 / 100663296.0 + 1 / 103079215104.0;
        double power = 1;
        for (int i = 0; i < 3072; ++i, power *= step) {
            squashed_[3072 + i] = static_cast<float>(power / (1 + power));
            squashed_[3072 - i] = static_cast<float>(1 / (1 + power));
        }
        squashed_[0] = squashed_[1];
        for (int p = 0, x = 0; p < 4096; ++p) {
            while (x < 6143 && squashed_[x] * 4096 < static_cast<float>(p) + 0.5f) ++x;
            stretched_[p] = static_cast<float>(x - 3072) / 256;
        }
    }
    float stretch(Counted p) const {
        return stretched_[p >> 20];
    }
    float squash(float x) const {
        const float bounded = x < -11.9f ? -11.9f : x > 11.9f ? 11.9f : x;
        return squashed_[static_cast<int>(bounded * 256 + 3072)];
    }

private:
    float squashed_[6144], stretched_[4096];
};

/// Weights of the inputs, a set for each value of something that is known, learnt from every bit.
template <int kSets>
class Mixer {
public:
    void start() {
        for (auto& set : sets_)
            for (int i = 0; i < kInputs; ++i) set[i / 4][i % 4] = i < kContexts ? 0.2f : 0;
    }
    float mix(const Lanes* inputs, std::uint32_t set) {
        used_ = sets_[set];
        Lanes sum = used_[0] * inputs[0];
        for (int i = 1; i < kInputs / 4; ++i) sum += used_[i] * inputs[i];
        return sum[0] + sum[1] + sum[2] + sum[3];
    }
    void learn(const Lanes* inputs, float error) {
        constexpr float kRate = 0.007f;
        const float step = error * kRate;
        for (int i = 0; i < kInputs / 4; ++i) used_[i] += step * inputs[i];
    }

private:
    Lanes sets_[kSets][kInputs / 4];
    Lanes* used_ = nullptr;
};

class Names;

/// Predicts the bits of `bytes`, which a packer has and an unpacker fills.
class Prediction {
public:
    explicit Prediction(const std::uint8_t* bytes) : bytes_(bytes) {}
    void start();

    /// Before each byte; then for its eight bits, the highest first, probability() and learn(bit); then end_byte(). A
    /// browser compiles a function well while it runs, and takes that at the next call: in line, in a loop that is
    /// entered once, they would be three times slower.
    [[gnu::noinline]] void begin_byte();
    [[gnu::noinline]] float probability();
    [[gnu::noinline]] void learn(int bit);
    [[gnu::noinline]] void end_byte();

private:
    std::uint32_t back(std::uint32_t distance) const {
        return at_ >= distance ? bytes_[at_ - distance] : 0;
    }
    /// An opcode, text or a table, the number of a local variable, another number.
    std::uint32_t kind_of_byte() const {
        if (reader_.part == WasmReader::kOpcode) return 1;
        if (reader_.part == WasmReader::kOther) return 2;
        constexpr std::uint32_t kLocalGet = 0x20;
        return reader_.opcode == kLocalGet ? 3 : 0;
    }
    /// The last bytes as one number, at most four.
    std::uint32_t last(std::uint32_t count) const {
        std::uint32_t bytes = 0;
        for (std::uint32_t i = 1; i <= count; ++i) bytes |= back(i) << 8 * (i - 1);
        return bytes;
    }
    void name_contexts();
    void name_in_text(Names& names) const;
    void name_in_code(Names& names) const;
    void find_lines();
    void follow_match();

    const std::uint8_t* bytes_;
    std::uint32_t at_ = 0;   ///< bytes so far
    std::uint32_t way_ = 1;  ///< 1, then the bits of this byte so far
    std::uint32_t word_ = 0;
    WasmReader reader_;
    Logistic logistic_;

    union {
        Ints names_in_lanes_[kContexts / 4];
        std::uint32_t names_[kContexts];
    };
    Line tables_[kContexts][kLines];
    Line* lines_[kContexts];
    std::uint32_t node_ = 0;  ///< which of a line's ways is at hand
    union {
        Ints counted_[kContexts / 4];  ///< that way in each line
        Counted one_counted_[kContexts];
    };

    std::uint32_t followers_[kFollowed][1 << 18];  ///< the four bytes that came last in a context
    std::uint32_t follower_at_[kFollowed];

    std::uint32_t places_[1 << 20];         ///< where six bytes were before
    std::uint32_t match_ = 0, length_ = 0;  ///< what follows there, and how many bytes before it are the same
    Counted of_match_[64];
    Counted* counted_match_ = nullptr;  ///< none where nothing matches

    union {
        Lanes inputs_[kInputs / 4];
        float input_[kInputs];
    };
    float mixed_[2];
    Mixer<1024> by_place_;
    Mixer<1024> by_way_;
};

/// A number, or four, that tells pairs apart.
template <class Number>
Number mixed_hash(Number a, std::uint32_t b) {
    Number x = (a ^ (b + 0x9e3779b9u + (a << 6) + (a >> 2))) * 0x85ebca6bu;
    x ^= x >> 15;
    return x * 0xc2b2ae35u ^ x >> 13;
}

inline void Prediction::start() {
    for (auto& table : tables_)
        for (Line& line : table) line.name = 0;
    for (Counted& p : of_match_) p = kEven;
    by_place_.start();
    by_way_.start();
}

/// Names of contexts, one after the other, that hold where the byte stands as well.
class Names {
public:
    Names(std::uint32_t* names, std::uint32_t here) : first_(names), next_(names), here_(here) {}
    void add(std::uint32_t a, std::uint32_t b = 0) {
        const std::uint32_t number = 0x10001 * static_cast<std::uint32_t>(next_ - first_);
        *next_++ = mixed_hash(mixed_hash(here_, a), b + number);
    }

private:
    std::uint32_t *first_, *next_, here_;
};

inline void Prediction::name_contexts() {
    const WasmReader& r = reader_;
    const std::uint32_t field = mixed_hash(r.place(), mixed_hash(r.opcode * 4 + r.field, r.begun));
    Names names(names_, r.part == WasmReader::kOther ? r.section : field);
    if (r.part == WasmReader::kOther) {
        name_in_text(names);
    } else {
        name_in_code(names);
    }
    const std::uint32_t keys[kFollowed] = {names_[1], names_[8], names_[5]},
                        besides[kFollowed] = {0, r.before[0], back(1)};
    for (int i = 0; i < kFollowed; ++i) {
        follower_at_[i] = keys[i] >> 14;
        names.add(followers_[i][follower_at_[i]] & 0xffff, besides[i]);
    }
}

/// Text by its last letters and its word, tables by the bytes four and eight before.
inline void Prediction::name_in_text(Names& names) const {
    const std::uint32_t column = at_ & 3, four = last(4);
    for (std::uint32_t count = 1; count <= 4; ++count) names.add(last(count));
    names.add(four, back(5));
    names.add(mixed_hash(four, back(5) | back(6) << 8));
    names.add(column);
    names.add(column, back(4));
    names.add(column, back(4) | back(1) << 8);
    names.add(column, back(4) | back(8) << 8);
    names.add(word_);
    names.add(word_, back(1));
    names.add(back(2) | back(3) << 8);
}

/// Code by opcodes, bytes, the function, local variables and distances before.
inline void Prediction::name_in_code(Names& names) const {
    const WasmReader& r = reader_;
    const std::uint32_t op = r.before[0], two = op << 10 | r.before[1], three = two << 10 | r.before[2];
    names.add(op);
    names.add(two);
    names.add(three);
    names.add(three, r.before[3] << 10 | r.before[4]);
    for (std::uint32_t count = 2; count <= 4; ++count) names.add(last(count));
    names.add(r.function);
    names.add(r.function, op);
    names.add(r.locals[0], op);
    names.add(r.locals[0], r.locals[1] + 1);
    names.add(r.function, r.locals[0] << 12);
    names.add(r.offset, op);
}

/// The lines of this half of the byte; one that another context had begins anew.
inline void Prediction::find_lines() {
    union {
        Ints in_lanes[kContexts / 4];
        std::uint32_t names[kContexts];
    };
    for (int v = 0; v < kContexts / 4; ++v) in_lanes[v] = mixed_hash(names_in_lanes_[v], way_) | 1;
    for (int i = 0; i < kContexts; ++i) {
        Line& line = tables_[i][names[i] >> 15];
        lines_[i] = &line;
        if (line.name == names[i]) continue;
        line.name = names[i];
        for (Counted& p : line.ways) p = kEven;
    }
}

inline void Prediction::begin_byte() {
    way_ = 1;
    name_contexts();
    find_lines();
}

/// As two inputs: its logarithm of odds, and how far from even it is.
inline Lanes from_even(Ints counted) {
    return as_floats(counted >> 10) * (4.0f / (1 << 22)) - 2.0f;
}

inline float Prediction::probability() {
    const int depth = 31 - __builtin_clz(way_), begun = depth & 3;  // bits so far, and those of this half
    node_ = (1u << begun) - 1 + (way_ & ((1u << begun) - 1));
    for (int i = 0; i < kContexts; ++i) one_counted_[i] = lines_[i]->ways[node_];
    for (int i = 0; i < kContexts; ++i) input_[i] = logistic_.stretch(one_counted_[i]);
    for (int v = 0; v < kContexts / 4; ++v) inputs_[kContexts / 4 + v] = from_even(counted_[v]);
    inputs_[kContexts / 2] = Lanes{0, 0, 0.3f, 0};
    counted_match_ = nullptr;
    if (length_ > 0 && (bytes_[match_] | 256u) >> (8 - depth) == way_) {
        const std::uint32_t bit = bytes_[match_] >> (7 - depth) & 1;
        counted_match_ = &of_match_[(length_ < 31 ? length_ : 31) * 2 + bit];
        inputs_[kContexts / 2] =
            Lanes{logistic_.stretch(*counted_match_), from_even(Ints{*counted_match_})[0], 0.3f, 0};
    }
    mixed_[0] = by_place_.mix(inputs_, reader_.place());
    mixed_[1] = by_way_.mix(inputs_, way_ + 256 * kind_of_byte());
    return logistic_.squash((mixed_[0] + mixed_[1]) / 2);
}

/// Moved towards 0 or 1, the less the oftener it was before.
inline Ints corrected(Ints counted, int bit) {
    const Ints count = counted & 1023;
    const float goal = bit ? (1 << 22) - 1 : 0;
    const Lanes was = as_floats(counted >> 10);
    const Lanes now = was + (goal - was) / (as_floats(count) + 1.25f);
    const Ints more = count - reinterpret_cast<Ints>(count < kMostCount);  // a comparison that is true is -1
    return as_numbers(now) << 10 | more;
}

inline void Prediction::learn(int bit) {
    by_place_.learn(inputs_, static_cast<float>(bit) - logistic_.squash(mixed_[0]));
    by_way_.learn(inputs_, static_cast<float>(bit) - logistic_.squash(mixed_[1]));
    for (Ints& four : counted_) four = corrected(four, bit);
    for (int i = 0; i < kContexts; ++i) lines_[i]->ways[node_] = one_counted_[i];
    if (counted_match_) *counted_match_ = corrected(Ints{*counted_match_}, bit)[0];
    way_ = way_ * 2 + bit;
    if (way_ >= 16 && way_ < 32) find_lines();
}

inline void Prediction::follow_match() {
    const std::uint32_t last = bytes_[at_ - 1];
    if (length_ > 0 && bytes_[match_] == last) {
        ++match_;
        ++length_;
    } else {
        length_ = 0;
    }
    if (at_ < 6) return;
    std::uint32_t key = 0;
    for (std::uint32_t i = 1; i <= 6; ++i) key = mixed_hash(key, back(i));
    std::uint32_t& place = places_[key >> 12];
    if (length_ == 0 && place > 0) {
        match_ = place;
        while (length_ < 32 && match_ > length_ && bytes_[match_ - 1 - length_] == bytes_[at_ - 1 - length_]) ++length_;
        if (length_ < 5) length_ = 0;
    }
    place = at_;
}

inline void Prediction::end_byte() {
    const std::uint32_t byte = bytes_[at_++];
    for (int i = 0; i < kFollowed; ++i) {
        std::uint32_t& last = followers_[i][follower_at_[i]];
        last = last << 8 | byte;
    }
    const std::uint32_t small = byte | 32;
    word_ = (small >= 'a' && small <= 'z') || byte > 127 ? mixed_hash(word_, small) : 0;
    follow_match();
    reader_.read(static_cast<std::uint8_t>(byte));
}

}  // namespace kreda::pack
