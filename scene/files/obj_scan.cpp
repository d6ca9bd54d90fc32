#include "scene/files/obj_scan.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "raster/platform.hpp"
#include "scene/files/obj_scanner.hpp"

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kreda::scene {

namespace {

void warn(ObjScanner& s, std::string_view kind, std::string_view token, const std::string& message) {
    s.warnings.add(kind, s.cursor.offset_of(token), token_in_quotes(token) + ": " + message);
}

/// The next word of the statement as a finite number.
double next_number(ObjScanner& s, const char* what) {
    double number = 0.0;
    if (s.cursor.take_number(number)) return number;
    return parse_finite(s.cursor, s.cursor.next_number_token(), what);
}

/// v x y z, then nothing, a weight w, or a colour of 3 or 4 numbers; only x y z are used.
void scan_position(ObjScanner& s, std::size_t offset) {
    const double x = next_number(s, "an x coordinate");
    const double y = next_number(s, "a y coordinate");
    const double z = next_number(s, "a z coordinate");
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
    if (extra >= 3 && s.colored++ == 0) s.first_colored = offset;
    s.scan.positions.emplace_back(x, y, z);
    ++s.counts[0];
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
    std::array<double, 3> uvw{};
    std::size_t numbers = 0;
    std::string_view bad;
    while (numbers < 3) {
        if (s.cursor.take_number(uvw[numbers])) {
            ++numbers;
            continue;
        }
        const std::string_view token = s.cursor.next_number_token();
        if (token.empty() && numbers > 0) break;
        if (is_nan_or_infinity(token))
            bad = token;
        else
            uvw[numbers] = parse_finite(s.cursor, token, "a texture coordinate");
        ++numbers;
    }
    const std::string_view token = s.cursor.next_number_token();
    if (!token.empty()) s.cursor.fail(token, "wrong number of coordinates: a texture coordinate has 1, 2 or 3");
    if (!bad.empty()) warn(s, "texture coordinates (vt) that are no numbers", bad, "is no number; 0 is used instead");
    s.scan.uvs.emplace_back(uvw[0], uvw[1]);
    ++s.counts[1];
}

/// vn x y z. Exporters write nan for degenerate faces: that component becomes 0. A normal of three 0 counts as missing.
void scan_normal(ObjScanner& s) {
    std::array<double, 3> xyz{};
    for (double& component : xyz) {
        if (s.cursor.take_number(component)) continue;
        const std::string_view token = s.cursor.next_number_token();
        if (!is_nan_or_infinity(token)) component = parse_finite(s.cursor, token, "a normal's component");
    }
    const std::string_view token = s.cursor.next_number_token();
    if (!token.empty()) s.cursor.fail(token, "wrong number of coordinates: a normal has 3");
    s.scan.normals.emplace_back(xyz[0], xyz[1], xyz[2]);
    ++s.counts[2];
}

/// The group and material of the next face, unless they are those of the one before.
void continue_run(ObjScanner& s) {
    if (!s.starts_run) return;
    s.starts_run = false;
    if (!s.runs.empty() && s.runs.back().name == s.name && s.runs.back().material == s.material) return;
    s.runs.push_back({s.name, s.material, s.scan.faces.size()});
}

void scan_face(ObjScanner& s, std::size_t offset) {
    const std::size_t first = s.scan.corners.size(), first_open = s.open.size(), first_relative = s.relative.size();
    std::size_t corners = 0;
    for (;; ++corners) {
        const bool is_full = corners == kMaxPolygonCorners;
        if (!is_full && scan_plain_corner(s)) continue;
        const std::string_view token = s.cursor.next_number_token();
        if (token.empty()) break;
        if (is_full) {
            s.cursor.fail(token, "a face may have " + std::to_string(kMaxPolygonCorners) +
                                     " corners at most; triangulate the mesh in a modelling program");
        }
        scan_corner(s, token);
    }
    if (corners < 3) {
        s.warnings.add("faces (f) of fewer than 3 corners", offset,
                       "a face of " + std::to_string(corners) + (corners == 1 ? " corner" : " corners") +
                           " covers nothing and is left out; a triangle has 3");
        s.scan.corners.resize(first);
        s.open.resize(first_open);
        s.relative.resize(first_relative);
        return;
    }
    continue_run(s);
    s.scan.faces.push_back({static_cast<std::uint32_t>(offset), s.smoothing_group, static_cast<std::uint32_t>(first)});
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
    if (!s.scan.has_smoothing_groups) s.faces_before_group = s.scan.faces.size();
    s.scan.has_smoothing_groups = true;
}

/// A face may be in several groups: their names become one, with a blank between them.
std::string joined_words(const std::string& names) {
    std::string joined;
    for (std::size_t first = names.find_first_not_of(" \t"); first != names.npos;) {
        const std::size_t end = std::min(names.find_first_of(" \t", first), names.size());
        joined.append(joined.empty() ? "" : " ").append(names, first, end - first);
        first = names.find_first_not_of(" \t", end);
    }
    return joined;
}

void scan_name(ObjScanner& s, std::string_view keyword, std::size_t offset) {
    const std::string name = s.cursor.rest_of_statement();
    if (keyword == "mtllib") {
        s.scan.material_files.push_back({name, offset});
        return;
    }
    s.starts_run = true;
    if (keyword == "usemtl") {
        s.material = name;
        if (!name.empty() && s.seen_materials.insert(name).second) s.scan.materials.push_back({name, offset});
    } else {
        s.name = keyword == "o" ? name : name.empty() ? "default" : joined_words(name);
    }
}

void scan_ignored(ObjScanner& s, std::string_view keyword) {
    if (s.ignored++ > 0) return;
    s.first_ignored = s.cursor.offset_of(keyword);
    s.ignored_length = keyword.size();
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

/// Where the next line begins, at or behind `from`, that no backslash joins to the one before.
std::size_t line_start(const std::string& text, std::size_t from) {
    while (from < text.size()) {
        const std::size_t end = text.find('\n', from);
        if (end == text.npos) return text.size();
        const std::size_t last = end > 0 && text[end - 1] == '\r' ? end - 1 : end;
        if (last == 0 || text[last - 1] != '\\') return end + 1;
        from = end + 1;
    }
    return text.size();
}

std::vector<ObjScanner> cut_text(const ObjText& text, int stretches) {
    std::vector<ObjScanner> cut;
    std::size_t begin = 0;
    for (int i = 1; i <= stretches && begin < text.text.size(); ++i) {
        const std::size_t about = text.text.size() / static_cast<std::size_t>(stretches) * static_cast<std::size_t>(i);
        const std::size_t end = i == stretches ? text.text.size() : line_start(text.text, std::max(about, begin));
        cut.emplace_back(text, begin, end, true);
        begin = end;
    }
    return cut;
}

/// False where something is odd: it is told with what comes before it known.
bool scan_side_by_side(const ObjText& text, int stretches, std::vector<ObjScanner>& cut) {
    cut = cut_text(text, stretches);
    const int count = static_cast<int>(cut.size());
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
        ObjScanner& s = cut[static_cast<std::size_t>(i)];
        try {
            scan_statements(s);
        } catch (const UserError&) { s.is_odd = true; }
        s.is_odd = s.is_odd || !s.warnings.empty();
    }
    return std::none_of(cut.begin(), cut.end(), [](const ObjScanner& s) { return s.is_odd; });
}

/// What is the same however the text was cut.
void finish(const ObjText& text, const std::vector<ObjScanner>& cut, ObjScan& scan) {
    std::size_t ignored = 0, colored = 0;
    std::string first_ignored, first_colored;
    for (const ObjScanner& s : cut) {
        const std::string_view word = std::string_view(text.text).substr(s.first_ignored, s.ignored_length);
        if (ignored == 0 && s.ignored > 0) first_ignored = warning_at(text, s.first_ignored, token_in_quotes(word));
        if (colored == 0 && s.colored > 0) first_colored = warning_at(text, s.first_colored, "'v'");
        ignored += s.ignored;
        colored += s.colored;
    }
    if (colored > 0) {
        scan.warnings.push_back(first_colored + " with a colour: vertex colours are not used, " +
                                std::to_string(colored) + " vertices have one; colour comes from materials and maps");
    }
    if (ignored > 0) {
        scan.warnings.push_back(first_ignored + " and what is like it is ignored: " + std::to_string(ignored) +
                                " statements that make no triangle");
    }
    if (!scan.faces.empty()) return;
    throw UserError(Place{text.file}, "holds no triangle; an OBJ mesh needs `f` lines" +
                                          (ignored > 0 ? " (not read: " + first_ignored + ")" : ""));
}

int stretches_for(const ObjText& text) {
#if defined(_OPENMP)
    constexpr std::size_t kWorthThreads = std::size_t(1) << 20;  // bytes
    return text.text.size() > kWorthThreads ? 4 * omp_get_max_threads() : 1;
#else
    static_cast<void>(text);
    return 1;
#endif
}

}  // namespace

void scan_statements(ObjScanner& s) {
    while (!s.cursor.at_end() && !s.is_odd) scan_statement(s);
}

ObjScan scan_obj(const ObjText& text, int stretches) {
    if (stretches == 0) stretches = stretches_for(text);
    std::vector<ObjScanner> cut;
    ObjScan scan;
    if (stretches < 2 || !scan_side_by_side(text, stretches, cut) || !join_stretches(cut, scan)) {
        cut.clear();
        scan = {};
        cut.emplace_back(text, 0, text.text.size(), false);
        scan_statements(cut[0]);
        settle_open_references(cut[0]);
        if (!join_stretches(cut, scan)) KREDA_EXPECT(false);
    }
    finish(text, cut, scan);
    return scan;
}

}  // namespace kreda::scene
