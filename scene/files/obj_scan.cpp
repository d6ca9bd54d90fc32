#include "scene/files/obj_scan.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <unordered_set>

namespace kreda::scene {

namespace {

constexpr int kKinds = 3;  // position, texture coordinate, normal: the order in v/vt/vn
constexpr std::array<const char*, kKinds> kKindNames = {"position", "texture coordinate", "normal"};
constexpr std::array<const char*, kKinds> kKindStatements = {"v", "vt", "vn"};

/// An index that names nothing so far: right if what it names comes later.
struct OpenReference {
    int kind = 0;
    std::int64_t index = 0;
    std::int64_t count = 0;  // how many there were before its line
    std::string_view token;
};

struct ObjScanner {
    const ObjText& text;
    ObjCursor cursor;
    ObjScan scan;
    std::array<std::int64_t, kKinds> counts{};
    std::vector<OpenReference> open;
    ObjWarnings warnings;
    std::unordered_set<std::string> seen_materials;
    std::uint32_t smoothing_group = 0;
    std::size_t ignored = 0;
    std::string first_ignored;  // its warning, with the place
    std::size_t colored = 0;
    std::string first_colored;

    explicit ObjScanner(const ObjText& obj) : text(obj), cursor(obj), warnings(obj) {
        scan.statements.reserve(obj.text.size());
    }
};

void warn(ObjScanner& s, std::string_view kind, std::string_view token, const std::string& message) {
    s.warnings.add(kind, s.cursor.offset_of(token), token_in_quotes(token) + ": " + message);
}

void append(ObjScanner& s, std::string_view word) {
    s.scan.statements += ' ';
    s.scan.statements += word;
}

void end_statement(ObjScanner& s, int kind) {
    s.scan.statements += '\n';
    ++s.counts[static_cast<std::size_t>(kind)];
}

/// v x y z, then nothing, a weight w, or a colour of 3 or 4 numbers; only x y z are used.
void scan_position(ObjScanner& s, std::size_t offset) {
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
    if (extra >= 3 && s.colored++ == 0) s.first_colored = warning_at(s.text, offset, "'v'");
    end_statement(s, 0);
}

/// What exporters write where there is no number: nan, -nan(ind), inf, and on Windows -1.#IND, 1.#QNAN, 1.#INF.
bool is_nan_or_infinity(std::string_view token) {
    if (!token.empty() && (token.front() == '-' || token.front() == '+')) token.remove_prefix(1);
    if (token.starts_with("1.#")) token.remove_prefix(3);
    static constexpr std::array<std::string_view, 10> kStarts = {"nan", "NaN", "NAN",  "inf",  "Inf",
                                                                 "INF", "IND", "QNAN", "SNAN", "ind"};
    return std::any_of(kStarts.begin(), kStarts.end(),
                       [&](std::string_view start) { return token.starts_with(start); });
}

/// vt u [v [w]]. What is no number becomes 0.
void scan_texture_coordinate(ObjScanner& s) {
    s.scan.statements += "vt";
    int numbers = 0;
    std::string_view bad;
    std::string_view token = s.cursor.next_number_token();
    for (; numbers == 0 || (!token.empty() && numbers < 3); token = s.cursor.next_number_token(), ++numbers) {
        if (is_nan_or_infinity(token)) {
            bad = token;
            append(s, "0");
            continue;
        }
        parse_finite(s.cursor, token, "a texture coordinate");
        append(s, token);
    }
    if (!token.empty()) s.cursor.fail(token, "wrong number of coordinates: a texture coordinate has 1, 2 or 3");
    if (!bad.empty()) warn(s, "texture coordinates (vt) that are no numbers", bad, "is no number; 0 is used instead");
    end_statement(s, 1);
}

/// vn x y z. Exporters write nan for degenerate faces: such a normal becomes 0 0 0, which counts as missing.
void scan_normal(ObjScanner& s) {
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

[[noreturn]] void fail_index(ObjScanner& s, int kind, std::string_view token, const std::string& why) {
    const std::size_t k = static_cast<std::size_t>(kind);
    s.cursor.fail(token, std::string("no such ") + kKindNames[k] + ": " + why + " (" + kKindStatements[k] + ")");
}

/// Whether the library shall see this index. What only comes later, or never, is settled when the text is read.
bool keeps_index(ObjScanner& s, int kind, std::int64_t index, std::string_view token) {
    const std::int64_t count = s.counts[static_cast<std::size_t>(kind)];
    if (index == 0 && kind == 0) fail_index(s, kind, token, "indices count from 1");
    if (index == 0) {
        warn(s, "indices 0", token,
             "indices count from 1; 0 is taken for no " + std::string(kKindNames[static_cast<std::size_t>(kind)]));
        return false;
    }
    if (index >= -count && index <= count) return true;
    s.open.push_back({kind, index, count, token});
    return index > 0 && index <= std::numeric_limits<std::int32_t>::max();
}

/// One corner: v, v/vt, v//vn or v/vt/vn. The library gets the indices that it shall see, in the form v/vt/vn, and no
/// slash at the end: it would take the next corner's index for the missing one.
void scan_corner(ObjScanner& s, std::string_view token) {
    static constexpr const char* kExpected = "expected a corner of a face: v, v/vt, v//vn or v/vt/vn, integers";
    const char* p = token.data();
    const char* const end = token.data() + token.size();
    std::array<std::string_view, kKinds> kept;
    for (int kind = 0; kind < kKinds && !(kind > 0 && p == end); ++kind) {
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
        const std::string_view digits(p, static_cast<std::size_t>(result.ptr - p));
        if (keeps_index(s, kind, index, token)) kept[static_cast<std::size_t>(kind)] = digits;
        p = result.ptr;
    }
    if (p != end) s.cursor.fail(token, kExpected);
    append(s, kept[0]);
    if (!kept[1].empty() || !kept[2].empty()) s.scan.statements.append("/").append(kept[1]);
    if (!kept[2].empty()) s.scan.statements.append("/").append(kept[2]);
}

void scan_face(ObjScanner& s, std::size_t offset) {
    const std::size_t start = s.scan.statements.size(), first_open = s.open.size();
    s.scan.statements += 'f';
    int corners = 0;
    std::string_view token = s.cursor.next_number_token();
    for (; !token.empty(); token = s.cursor.next_number_token(), ++corners) {
        if (corners == kMaxPolygonCorners) {
            s.cursor.fail(token, "a face may have " + std::to_string(kMaxPolygonCorners) +
                                     " corners at most; triangulate the mesh in a modelling program");
        }
        scan_corner(s, token);
    }
    if (corners < 3) {
        s.warnings.add("faces (f) of fewer than 3 corners", offset,
                       "a face of " + std::to_string(corners) + (corners == 1 ? " corner" : " corners") +
                           " covers nothing and is left out; a triangle has 3");
        s.scan.statements.resize(start);
        s.open.resize(first_open);
        return;
    }
    s.scan.statements += '\n';
    s.scan.faces.push_back({static_cast<std::uint32_t>(offset), s.smoothing_group});
}

/// s GROUP, s 0, s off or s on, which some programs write: one smooth group.
void scan_smoothing_group(ObjScanner& s) {
    const std::string_view token = s.cursor.next_number_token();
    const std::string word = in_lower_case(token);
    std::int64_t group = 0;  // a label: of any other number than 0 the lower half will do
    const std::from_chars_result result = std::from_chars(token.data(), token.data() + token.size(), group);
    const bool is_number = result.ec == std::errc() && result.ptr == token.data() + token.size();
    if (word == "on") {
        warn(s, "'s on'", token, "no smoothing group, which is a number; taken for group 1");
        group = 1;
    } else if (word != "off" && !is_number) {
        s.cursor.fail(token, "expected a smoothing group: a number or off");
    }
    s.smoothing_group = group == 0 ? 0 : std::max(static_cast<std::uint32_t>(group), 1u);
    s.scan.has_smoothing_groups = true;
}

void scan_name(ObjScanner& s, std::string_view keyword, std::size_t offset) {
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

void scan_ignored(ObjScanner& s, std::string_view keyword) {
    if (s.ignored++ == 0) {
        s.first_ignored = warning_at(s.text, s.cursor.offset_of(keyword), token_in_quotes(keyword));
    }
}

void scan_keyword(ObjScanner& s, std::string_view keyword) {
    const std::size_t offset = s.cursor.offset_of(keyword);
    if (keyword == "v") return scan_position(s, offset);
    if (keyword == "f") return scan_face(s, offset);
    if (keyword == "vn") return scan_normal(s);
    if (keyword == "vt") return scan_texture_coordinate(s);
    if (keyword == "s") return scan_smoothing_group(s);
    const bool is_name = keyword == "usemtl" || keyword == "mtllib" || keyword == "g" || keyword == "o";
    if (is_name) return scan_name(s, keyword, offset);
    scan_ignored(s, keyword);
}

void scan_statement(ObjScanner& s) {
    const std::string_view keyword = s.cursor.next_token();
    if (!keyword.empty() && keyword.front() == '#') return s.cursor.skip_line();
    if (!keyword.empty()) scan_keyword(s, keyword);
    s.cursor.skip_statement();
}

/// What an index names must be somewhere in the file. A normal that is nowhere is made, as for a corner without one;
/// texture coordinates of a file that has none are left out.
void settle_open_references(ObjScanner& s) {
    for (const OpenReference& reference : s.open) {
        const std::int64_t count = s.counts[static_cast<std::size_t>(reference.kind)];
        if (reference.index > 0 && reference.index <= count) continue;
        const bool can_do_without = reference.kind == 2 || (reference.kind == 1 && count == 0);
        const std::string why = reference.index > 0
                                    ? "the file has " + std::to_string(count)
                                    : "there are " + std::to_string(reference.count) + " before this line";
        if (!can_do_without) fail_index(s, reference.kind, reference.token, why);
        const bool is_normal = reference.kind == 2;
        warn(s,
             is_normal ? "indices of normals (vn) that are not there"
                       : "indices of texture coordinates (vt) in a file without",
             reference.token,
             is_normal ? "no such normal: " + why + " (vn); a smooth one is made"
                       : "no such texture coordinate: " + why + " (vt); the corner has none");
    }
}

}  // namespace

ObjScan scan_obj(const ObjText& text) {
    ObjScanner s(text);
    while (!s.cursor.at_end()) scan_statement(s);
    settle_open_references(s);
    s.scan.warnings = s.warnings.lines();
    if (s.colored > 0) {
        s.scan.warnings.push_back(s.first_colored + " with a colour: vertex colours are not used, " +
                                  std::to_string(s.colored) +
                                  " vertices have one; colour comes from materials and maps");
    }
    if (s.ignored > 0) {
        s.scan.warnings.push_back(s.first_ignored + " and what is like it is ignored: " + std::to_string(s.ignored) +
                                  " statements that make no triangle");
    }
    if (s.scan.faces.empty()) {
        throw UserError(Place{text.file}, "holds no triangle; an OBJ mesh needs `f` lines" +
                                              (s.ignored > 0 ? " (not read: " + s.first_ignored + ")" : ""));
    }
    return std::move(s.scan);
}

}  // namespace kreda::scene
