// Where in a WebAssembly module a byte stands: an opcode, or which of the numbers that follow one. What comes next
// depends on that more than on the bytes before. A module that is not understood is packed less well, and unpacked all
// the same.
//   WebAssembly Core Specification 2.0 (2022), 5. Binary format; the proposal for exceptions
#pragma once

#include <cstdint>

namespace kreda::pack {

/// What follows an opcode, a letter each: n: a number in LEB128, 1 to 9: so many bytes, v: 16 bytes, t: a table of
/// numbers.
inline const char* fields_after(int opcode) {
    if (opcode == 0x0e) return "t";
    if (opcode == 0x11 || (opcode >= 0x28 && opcode <= 0x3e)) return "nn";
    if (opcode == 0x43) return "4";
    if (opcode == 0x44) return "8";
    if (opcode == 0x3f || opcode == 0x40) return "1";
    const bool takes_one = (opcode >= 0x02 && opcode <= 0x04) || (opcode >= 0x06 && opcode <= 0x09) || opcode == 0x0c ||
                           opcode == 0x0d || opcode == 0x10 || opcode == 0x18 || (opcode >= 0x20 && opcode <= 0x26) ||
                           opcode == 0x41 || opcode == 0x42 || opcode == 0xd0 || opcode == 0xd2;
    return takes_one ? "n" : "";
}

/// The same after the number of an instruction whose first byte is 0xfc (memory at large, saturating conversions).
inline const char* fields_after_fc(int number) {
    if (number == 8) return "n1";
    if (number == 10) return "2";
    if (number == 11) return "1";
    return number == 9 || (number >= 12 && number <= 17) ? "n" : "";
}

/// The same for 0xfd (lanes).
inline const char* fields_after_fd(int number) {
    if (number <= 11 || number == 92 || number == 93) return "nn";
    if (number == 12 || number == 13) return "v";
    if (number >= 21 && number <= 34) return "1";
    return number >= 84 && number <= 91 ? "nn1" : "";
}

/// Reads a module byte by byte. All its members are small numbers that hint at the next byte.
class WasmReader {
public:
    /// What the next byte is.
    enum Part : std::uint8_t {
        kSectionId,
        kSectionSize,
        kFunctions,
        kFunctionSize,
        kGroups,
        kGroupSize,
        kGroupType,
        kOpcode,
        kSecondOpcode,
        kField,
        kOther
    };

    Part part = kOther;
    std::uint32_t section = 0;
    std::uint32_t opcode =
        0;  ///< of the instruction whose fields come now: 0 to 255, 256 + n after 0xfc, 512 + n after 0xfd
    std::uint32_t field = 0;       ///< which one
    std::uint32_t begun = 0;       ///< the bytes of this field so far
    std::uint32_t before[5] = {};  ///< the opcodes before, the last first
    std::uint32_t locals[2] = {};  ///< numbers of the local variables that came last, the last first
    std::uint32_t offset = 0;      ///< the last distance from an address
    std::uint32_t function = 0;    ///< counted from 1

    /// What the next byte is, as one number below 1024.
    std::uint32_t place() const {
        if (part != kField) return part;
        const std::uint32_t kind = opcode < 256 ? opcode : 256 + (opcode & 127);
        return 16 + 2 * kind + (begun != 0 ? 1 : 0);
    }

    void read(std::uint8_t byte);

private:
    bool number(std::uint8_t byte);
    void start(Part next);
    void next_field();
    void read_field(std::uint8_t byte);
    void end_of_code();

    std::uint64_t at_ = 0, section_end_ = 0, function_end_ = 0, value_ = 0;
    std::uint32_t shift_ = 0, groups_ = 0, bytes_left_ = 0, entries_left_ = 0;
    const char* fields_ = "";
};

inline void WasmReader::start(Part next) {
    part = next;
    value_ = shift_ = begun = 0;
}

/// Takes a byte of a number in LEB128; says whether it was the last.
inline bool WasmReader::number(std::uint8_t byte) {
    if (shift_ < 64) value_ |= std::uint64_t(byte & 127) << shift_;
    shift_ += 7;
    begun = (begun + 1) << 8 | byte;
    return byte < 128;
}

inline void WasmReader::next_field() {
    const char kind = fields_[field];
    if (kind == 0) {
        for (int i = 4; i > 0; --i) before[i] = before[i - 1];
        before[0] = opcode;
        return start(kOpcode);
    }
    start(kField);
    bytes_left_ = kind == 'v' ? 16 : kind >= '1' && kind <= '9' ? kind - '0' : 0;
    entries_left_ = 0;
}

inline void WasmReader::read_field(std::uint8_t byte) {
    bool is_done = false;
    if (bytes_left_ > 0) {
        begun = (begun + 1) << 8 | byte;
        is_done = --bytes_left_ == 0;
    } else if (number(byte)) {
        const bool is_count = fields_[field] == 't' && entries_left_ == 0;
        if (is_count) entries_left_ = static_cast<std::uint32_t>(value_) + 2;
        is_done = fields_[field] != 't' || --entries_left_ == 0;
        if (!is_done) start(kField);
    }
    if (!is_done) return;
    if (opcode >= 0x20 && opcode <= 0x22) {
        locals[1] = locals[0];
        locals[0] = static_cast<std::uint32_t>(value_);
    }
    if (field == 1) offset = static_cast<std::uint32_t>(value_);
    ++field;
    next_field();
}

inline void WasmReader::end_of_code() {
    if (at_ >= function_end_) start(at_ >= section_end_ ? kSectionId : kFunctionSize);
}

inline void WasmReader::read(std::uint8_t byte) {
    constexpr std::uint32_t kHeader = 8, kCode = 10;
    if (++at_ <= kHeader) {
        if (at_ == kHeader) start(kSectionId);
        return;
    }
    switch (part) {
        case kSectionId: section = byte; return start(kSectionSize);
        case kSectionSize:
            if (!number(byte)) return;
            section_end_ = at_ + value_;
            return start(section == kCode ? kFunctions : kOther);
        case kFunctions:
            if (number(byte)) start(kFunctionSize);
            return;
        case kFunctionSize:
            if (!number(byte)) return;
            function_end_ = at_ + value_;
            ++function;
            locals[0] = locals[1] = 0;
            return start(kGroups);
        case kGroups:
            if (!number(byte)) return;
            groups_ = static_cast<std::uint32_t>(value_);
            return start(groups_ > 0 ? kGroupSize : kOpcode);
        case kGroupSize:
            if (number(byte)) start(kGroupType);
            return;
        case kGroupType: return start(--groups_ > 0 ? kGroupSize : kOpcode);
        case kOpcode:
            field = 0;
            opcode = byte;
            if (byte == 0xfc || byte == 0xfd) return start(kSecondOpcode);
            fields_ = fields_after(byte);
            next_field();
            return end_of_code();
        case kSecondOpcode: {
            if (!number(byte)) return;
            const int second = static_cast<int>(value_ & 255);
            fields_ = opcode == 0xfc ? fields_after_fc(second) : fields_after_fd(second);
            opcode = (opcode == 0xfc ? 256 : 512) + second;
            return next_field();
        }
        case kField: read_field(byte); return end_of_code();
        case kOther:
            if (at_ >= section_end_) start(kSectionId);
            return;
    }
}

}  // namespace kreda::pack
