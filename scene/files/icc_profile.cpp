#include "scene/files/icc_profile.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace kreda::scene {

namespace {

/// Numbers of a profile; all are big-endian. Bytes beyond the end read as 0.
struct Profile {
    std::string_view bytes;

    [[nodiscard]] std::uint32_t number(std::size_t at, int size) const {
        std::uint32_t value = 0;
        for (std::size_t i = at; i < at + static_cast<std::size_t>(size); ++i) {
            value = value << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u);
        }
        return value;
    }
    /// s15Fixed16Number
    [[nodiscard]] double fixed(std::size_t at) const {
        return static_cast<double>(static_cast<std::int32_t>(number(at, 4))) / 65536.0;
    }
    [[nodiscard]] std::string_view word(std::size_t at) const {
        return at <= bytes.size() ? bytes.substr(at, 4) : std::string_view();
    }
    /// Where the data of a tag begins.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view tag) const {
        constexpr std::size_t kTable = 128, kMostTags = 100;
        const std::size_t count = number(kTable, 4);
        for (std::size_t i = 0; i < count && i < kMostTags; ++i) {
            const std::size_t entry = kTable + 4 + 12 * i;
            if (word(entry) == tag) return number(entry + 4, 4);
        }
        return std::nullopt;
    }
};

/// Its description: ASCII in version 2, UTF-16 in version 4.
std::string name_of(const Profile& profile) {
    const std::optional<std::size_t> at = profile.find("desc");
    std::string name;
    if (at && profile.word(*at) == "desc") {
        const std::size_t length = std::min<std::size_t>(profile.number(*at + 8, 4), 100);
        for (std::size_t i = 0; i + 1 < length; ++i) name += static_cast<char>(profile.number(*at + 12 + i, 1));
    } else if (at && profile.word(*at) == "mluc") {
        const std::size_t length = std::min<std::size_t>(profile.number(*at + 20, 4), 200);
        const std::size_t text = *at + profile.number(*at + 24, 4);
        for (std::size_t i = 0; i + 1 < length; i += 2) {
            const std::uint32_t letter = profile.number(text + i, 2);
            name += letter < 128 ? static_cast<char>(letter) : '?';
        }
    }
    return name.empty() ? "a colour profile without a name" : name;
}

/// The share of light at half of the range, by the curve at `at`.
double light_at_half(const Profile& profile, std::size_t at) {
    if (profile.word(at) == "para") {
        const double g = profile.fixed(at + 12);
        const bool has_offset = profile.number(at + 8, 2) > 0;
        const double a = has_offset ? profile.fixed(at + 16) : 1.0, b = has_offset ? profile.fixed(at + 20) : 0.0;
        return std::pow(a * 0.5 + b, g);
    }
    const std::size_t count = profile.number(at + 8, 4);
    if (count == 0) return 0.5;
    if (count == 1) return std::pow(0.5, profile.number(at + 12, 2) / 256.0);
    return profile.number(at + 12 + 2 * ((count - 1) / 2), 2) / 65535.0;
}

bool has_curve_of_srgb(const Profile& profile, const char* tag) {
    const std::optional<std::size_t> at = profile.find(tag);
    return !at || std::abs(light_at_half(profile, *at) - 0.214) < 0.02;  // a table's middle may be half a step off
}

/// XYZ of the primaries under D50: the columns of sRGB's matrix, adapted by Bradford's method (ICC's own sRGB profile).
bool has_primaries_of_srgb(const Profile& profile) {
    struct Primary {
        const char* tag;
        std::array<double, 3> xyz;
    };
    constexpr std::array<Primary, 3> kPrimaries = {
        {{"rXYZ", {0.4361, 0.2225, 0.0139}}, {"gXYZ", {0.3851, 0.7169, 0.0971}}, {"bXYZ", {0.1431, 0.0606, 0.7141}}}};
    for (const Primary& primary : kPrimaries) {
        const std::optional<std::size_t> at = profile.find(primary.tag);
        if (!at) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::abs(profile.fixed(*at + 8 + 4 * i) - primary.xyz[i]) > 0.01) return false;
        }
    }
    return true;
}

}  // namespace

std::string profile_other_than_srgb(std::string_view bytes) {
    const Profile profile{bytes};
    if (profile.word(36) != "acsp") return "";
    const bool is_grey = profile.word(16) == "GRAY";
    const bool is_srgb = is_grey ? has_curve_of_srgb(profile, "kTRC")
                                 : has_primaries_of_srgb(profile) && has_curve_of_srgb(profile, "rTRC");
    return is_srgb ? "" : name_of(profile);
}

}  // namespace kreda::scene
