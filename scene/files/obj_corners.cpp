// Corners of faces: indices that count from 1, or from the last element back, of what is there or comes later.
#include <charconv>

#include "scene/files/obj_scanner.hpp"

namespace kreda::scene {

namespace {

constexpr std::array<const char*, kObjKinds> kKindNames = {"position", "texture coordinate", "normal"};
constexpr std::array<const char*, kObjKinds> kKindStatements = {"v", "vt", "vn"};

void warn(ObjScanner& s, std::string_view kind, std::string_view token, const std::string& message) {
    s.warnings.add(kind, s.cursor.offset_of(token), token_in_quotes(token) + ": " + message);
}

[[noreturn]] void fail_index(const ObjScanner& s, std::size_t kind, std::string_view token, const std::string& why) {
    s.cursor.fail(token, std::string("no such ") + kKindNames[kind] + ": " + why + " (" + kKindStatements[kind] + ")");
}

/// An index of a stretch: what it names may be anywhere in the text.
int index_in_stretch(ObjScanner& s, std::size_t kind, std::int64_t index) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
    if (index == 0 || index > kMost || index < -kMost) {
        s.is_odd = true;
        return -1;
    }
    if (index < 0) {
        s.relative.push_back({s.scan.corners.size(), kind});
        return static_cast<int>(s.counts[kind] + index);
    }
    s.greatest[kind] = std::max(s.greatest[kind], index);
    return static_cast<int>(index - 1);
}

/// From 0; -1: the corner has none. What only comes later, or never, is settled when the text is read.
int index_from_zero(ObjScanner& s, std::size_t kind, std::int64_t index, std::string_view token) {
    if (s.is_stretch) return index_in_stretch(s, kind, index);
    const std::int64_t count = s.counts[kind];
    if (index == 0 && kind == 0) fail_index(s, kind, token, "indices count from 1");
    if (index == 0) {
        warn(s, "indices 0", token, "indices count from 1; 0 is taken for no " + std::string(kKindNames[kind]));
        return -1;
    }
    if (index >= -count && index <= count) return static_cast<int>(index > 0 ? index - 1 : count + index);
    s.open.push_back({kind, index, count, token});
    const bool may_come = index > 0 && index <= std::numeric_limits<std::int32_t>::max();
    return may_come ? static_cast<int>(index - 1) : -1;
}

}  // namespace

void scan_corner(ObjScanner& s, std::string_view token) {
    static constexpr const char* kExpected = "expected a corner of a face: v, v/vt, v//vn or v/vt/vn, integers";
    const char* p = token.data();
    const char* const end = token.data() + token.size();
    ObjCorner corner;
    for (std::size_t kind = 0; kind < kObjKinds && !(kind > 0 && p == end); ++kind) {
        if (kind > 0) {
            if (*p != '/') s.cursor.fail(token, kExpected);
            ++p;
            if (p == end || *p == '/') continue;
        }
        std::int64_t index = 0;
        const std::from_chars_result result = std::from_chars(p, end, index);
        if (result.ec == std::errc::invalid_argument) s.cursor.fail(token, kExpected);
        if (result.ec == std::errc::result_out_of_range) {
            index = *p == '-' ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
        }
        index_of(corner, kind) = index_from_zero(s, kind, index, token);
        p = result.ptr;
    }
    if (p != end) s.cursor.fail(token, kExpected);
    s.scan.corners.push_back(corner);
}

bool scan_plain_corner(ObjScanner& s) {
    const std::string_view rest = s.cursor.rest_of_text();
    const char* p = rest.data();
    const char* const end = p + rest.size();
    std::array<std::int32_t, kObjKinds> index{};  // 0: none
    for (std::size_t kind = 0; kind < kObjKinds; ++kind) {
        if (kind > 0 && (p == end || *p != '/')) break;
        if (kind > 0) ++p;
        if (kind == 1 && p != end && *p == '/') continue;
        const std::from_chars_result result = std::from_chars(p, end, index[kind]);
        const std::int64_t most = s.is_stretch ? std::numeric_limits<std::int32_t>::max() : s.counts[kind];
        if (result.ec != std::errc() || index[kind] < 1 || index[kind] > most) return false;
        p = result.ptr;
    }
    if (!s.cursor.take_up_to(p)) return false;
    s.scan.corners.push_back({index[0] - 1, index[1] - 1, index[2] - 1});
    if (!s.is_stretch) return true;
    for (std::size_t kind = 0; kind < kObjKinds; ++kind) {
        s.greatest[kind] = std::max<std::int64_t>(s.greatest[kind], index[kind]);
    }
    return true;
}

void settle_open_references(ObjScanner& s) {
    for (const OpenReference& reference : s.open) {
        const std::int64_t count = s.counts[reference.kind];
        if (reference.index > 0 && reference.index <= count) continue;
        const bool is_normal = reference.kind == 2;
        const bool can_do_without = is_normal || (reference.kind == 1 && count == 0);
        const std::string why = reference.index > 0
                                    ? "the file has " + std::to_string(count)
                                    : "there are " + std::to_string(reference.count) + " before this line";
        if (!can_do_without) fail_index(s, reference.kind, reference.token, why);
        warn(s,
             is_normal ? "indices of normals (vn) that are not there"
                       : "indices of texture coordinates (vt) in a file without",
             reference.token,
             is_normal ? "no such normal: " + why + " (vn); a smooth one is made"
                       : "no such texture coordinate: " + why + " (vt); the corner has none");
    }
    if (s.open.empty()) return;
    for (ObjCorner& corner : s.scan.corners) {
        if (corner.normal >= s.counts[2]) corner.normal = -1;
        if (s.counts[1] == 0) corner.uv = -1;
    }
}

}  // namespace kreda::scene
