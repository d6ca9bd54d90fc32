#include "scene/files/obj_scan.hpp"

#include <array>
#include <charconv>
#include <limits>
#include <unordered_set>

namespace kreda::scene {

namespace {

constexpr int kKinds = 3;  // position, texture coordinate, normal: the order in v/vt/vn
constexpr std::array<const char*, kKinds> kKindNames = {"position", "texture coordinate", "normal"};
constexpr std::array<const char*, kKinds> kKindStatements = {"v", "vt", "vn"};

/// An index that is larger than the count at its line: right if what it names comes later.
struct ForwardReference {
    int kind = 0;
    std::int64_t index = 0;
    std::string_view token;
};

struct Scanner {
    const ObjText& text;
    ObjCursor cursor;
    ObjScan scan;
    std::array<std::int64_t, kKinds> counts{};
    std::vector<ForwardReference> forward;
    std::unordered_set<std::string> seen_materials;
    std::uint32_t smoothing_group = 0;
    std::size_t ignored = 0;
    std::string first_ignored;  // its warning, with the place

    explicit Scanner(const ObjText& obj) : text(obj), cursor(obj) {
        scan.statements.reserve(obj.text.size());
    }
};

void append(Scanner& s, std::string_view word) {
    s.scan.statements += ' ';
    s.scan.statements += word;
}

void end_statement(Scanner& s, int kind) {
    s.scan.statements += '\n';
    ++s.counts[static_cast<std::size_t>(kind)];
}

/// v x y z, then nothing, a weight w, or a colour of 3 or 4 numbers; only x y z are used.
void scan_position(Scanner& s) {
    static constexpr std::array<const char*, 3> kAxes = {"an x coordinate", "a y coordinate", "a z coordinate"};
    s.scan.statements += 'v';
    for (const char* axis : kAxes) {
        const std::string_view token = s.cursor.next_number_token();
        parse_finite(s.cursor, token, axis);
        append(s, token);
    }
    int extra = 0;
    std::string_view token = s.cursor.next_number_token();
    for (; !token.empty() && extra < 4; token = s.cursor.next_number_token(), ++extra) {
        parse_finite(s.cursor, token, "a weight or a colour");
    }
    if (!token.empty() || extra == 2) {
        s.cursor.fail(token,
                      "wrong number of coordinates: a vertex is x y z, and perhaps a weight (1 number more) or a "
                      "colour (3 or 4 more)");
    }
    end_statement(s, 0);
}

/// vt u [v [w]]
void scan_texture_coordinate(Scanner& s) {
    s.scan.statements += "vt";
    int numbers = 0;
    std::string_view token = s.cursor.next_number_token();
    for (; numbers == 0 || (!token.empty() && numbers < 3); token = s.cursor.next_number_token(), ++numbers) {
        parse_finite(s.cursor, token, "a texture coordinate");
        append(s, token);
    }
    if (!token.empty()) s.cursor.fail(token, "wrong number of coordinates: a texture coordinate has 1, 2 or 3");
    end_statement(s, 1);
}

bool is_nan_or_infinity(std::string_view token) {
    if (!token.empty() && (token.front() == '-' || token.front() == '+')) token.remove_prefix(1);
    const std::string_view start = token.substr(0, 3);
    return start == "nan" || start == "NaN" || start == "NAN" || start == "inf" || start == "Inf" || start == "INF";
}

/// vn x y z. Exporters write nan for degenerate faces: such a normal becomes 0 0 0, which counts as missing.
void scan_normal(Scanner& s) {
    s.scan.statements += "vn";
    for (int i = 0; i < 3; ++i) {
        std::string_view token = s.cursor.next_number_token();
        if (is_nan_or_infinity(token)) {
            append(s, "nan");
            continue;
        }
        parse_finite(s.cursor, token, "a normal's component");
        append(s, token);
    }
    const std::string_view token = s.cursor.next_number_token();
    if (!token.empty()) s.cursor.fail(token, "wrong number of coordinates: a normal has 3");
    end_statement(s, 2);
}

[[noreturn]] void fail_index(Scanner& s, int kind, std::string_view token, const std::string& why) {
    const std::size_t k = static_cast<std::size_t>(kind);
    s.cursor.fail(token, std::string("no such ") + kKindNames[k] + ": " + why + " (" + kKindStatements[k] + ")");
}

void check_index(Scanner& s, int kind, std::int64_t index, std::string_view token) {
    const std::int64_t count = s.counts[static_cast<std::size_t>(kind)];
    if (index == 0) fail_index(s, kind, token, "indices count from 1");
    if (index < -count) fail_index(s, kind, token, "there are " + std::to_string(count) + " before this line");
    if (index > count) s.forward.push_back({kind, index, token});
}

/// One corner: v, v/vt, v//vn or v/vt/vn.
void scan_corner(Scanner& s, std::string_view token) {
    static constexpr const char* kExpected = "expected a corner of a face: v, v/vt, v//vn or v/vt/vn, integers";
    const char* p = token.data();
    const char* const end = token.data() + token.size();
    for (int kind = 0; kind < kKinds; ++kind) {
        if (kind > 0) {
            if (p == end) return;
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
        check_index(s, kind, index, token);
        p = result.ptr;
    }
    if (p != end) s.cursor.fail(token, kExpected);
}

/// 1// means 1, but the library would take the next corner's index for the missing one.
std::string_view without_trailing_slashes(std::string_view corner) {
    return corner.substr(0, corner.find_last_not_of('/') + 1);
}

void scan_face(Scanner& s, std::size_t offset) {
    s.scan.statements += 'f';
    int corners = 0;
    std::string_view token = s.cursor.next_number_token();
    for (; !token.empty(); token = s.cursor.next_number_token(), ++corners) {
        if (corners == kMaxPolygonCorners) {
            s.cursor.fail(token, "a face may have " + std::to_string(kMaxPolygonCorners) +
                                     " corners at most; triangulate the mesh in a modelling program");
        }
        scan_corner(s, token);
        append(s, without_trailing_slashes(token));
    }
    if (corners < 3) s.cursor.fail(token, "a face needs at least 3 corners, found " + std::to_string(corners));
    s.scan.statements += '\n';
    s.scan.faces.push_back({static_cast<std::uint32_t>(offset), s.smoothing_group});
}

/// s GROUP, s 0 or s off
void scan_smoothing_group(Scanner& s) {
    const std::string_view token = s.cursor.next_number_token();
    std::uint32_t group = 0;
    const std::from_chars_result result = std::from_chars(token.data(), token.data() + token.size(), group);
    const bool is_number = result.ec == std::errc() && result.ptr == token.data() + token.size();
    if (token != "off" && !is_number) s.cursor.fail(token, "expected a smoothing group: a number or off");
    s.smoothing_group = token == "off" ? 0 : group;
    s.scan.has_smoothing_groups = true;
}

void scan_name(Scanner& s, std::string_view keyword, std::size_t offset) {
    const std::string name = s.cursor.rest_of_statement();
    if (keyword == "mtllib") {
        s.scan.material_files.push_back({name, offset});
        return;
    }
    if (keyword == "usemtl" && !name.empty() && s.seen_materials.insert(name).second) {
        s.scan.materials.push_back({name, offset});
    }
    s.scan.statements += keyword;
    append(s, keyword == "g" && name.empty() ? "default" : name);
    s.scan.statements += '\n';
}

void scan_ignored(Scanner& s, std::string_view keyword) {
    if (s.ignored++ == 0) { s.first_ignored = warning_at(s.text, s.cursor.offset_of(keyword), in_quotes(keyword)); }
}

void scan_statement(Scanner& s) {
    const std::string_view keyword = s.cursor.next_token();
    const std::size_t offset = s.cursor.offset_of(keyword);
    if (keyword.empty() || keyword.front() == '#') return;
    if (keyword == "v") return scan_position(s);
    if (keyword == "f") return scan_face(s, offset);
    if (keyword == "vn") return scan_normal(s);
    if (keyword == "vt") return scan_texture_coordinate(s);
    if (keyword == "s") return scan_smoothing_group(s);
    const bool is_name = keyword == "usemtl" || keyword == "mtllib" || keyword == "g" || keyword == "o";
    if (is_name) return scan_name(s, keyword, offset);
    scan_ignored(s, keyword);
}

void check_forward_references(Scanner& s) {
    for (const ForwardReference& reference : s.forward) {
        const std::int64_t count = s.counts[static_cast<std::size_t>(reference.kind)];
        if (reference.index > count) {
            fail_index(s, reference.kind, reference.token, "the file has " + std::to_string(count));
        }
    }
}

}  // namespace

ObjScan scan_obj(const ObjText& text) {
    Scanner s(text);
    while (!s.cursor.at_end()) {
        scan_statement(s);
        s.cursor.skip_statement();
    }
    check_forward_references(s);
    if (s.ignored > 0) {
        s.scan.warnings.push_back(s.first_ignored + " and what is like it is ignored: " + std::to_string(s.ignored) +
                                  " statements that make no triangle");
    }
    if (s.scan.faces.empty()) throw UserError(Place{text.file}, "holds no triangle; an OBJ mesh needs `f` lines");
    return std::move(s.scan);
}

}  // namespace kreda::scene
