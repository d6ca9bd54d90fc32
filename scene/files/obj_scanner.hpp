// The memory of a scan of an OBJ text, or of a stretch of it: inside of scene/files, for obj_scan.cpp and the files
// beside it.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "scene/files/obj_scan.hpp"

namespace kreda::scene {

constexpr std::size_t kObjKinds = 3;  ///< position, texture coordinate, normal: the order in v/vt/vn

/// The index of that kind.
[[nodiscard]] inline int& index_of(ObjCorner& corner, std::size_t kind) {
    return kind == 0 ? corner.position : kind == 1 ? corner.uv : corner.normal;
}

/// An index that names nothing so far: right if what it names comes later.
struct OpenReference {
    std::size_t kind = 0;
    std::int64_t index = 0;
    std::int64_t count = 0;  ///< how many there were before its line
    std::string_view token;
};

/// An index of a stretch that counts from the stretch's first element, not the text's.
struct RelativeIndex {
    std::size_t corner = 0;
    std::size_t kind = 0;
};

/// A run whose name or material may have been given before the stretch.
struct RunOfStretch {
    std::optional<std::string> name, material;
    std::size_t first_face = 0;
};

struct ObjScanner {
    const ObjText& text;
    ObjCursor cursor;
    bool is_stretch = false;  ///< what comes before is not known: whatever is odd ends the scan
    bool is_odd = false;      ///< a stretch that must be scanned with all that comes before it

    ObjScan scan;  ///< all but the runs
    std::vector<RunOfStretch> runs;
    std::optional<std::string> name, material;  ///< that hold now
    bool starts_run = true;                     ///< the next face may belong to another run than the last
    std::uint32_t smoothing_group = 0;
    std::size_t faces_before_group = std::numeric_limits<std::size_t>::max();  ///< faces before the first `s`

    std::array<std::int64_t, kObjKinds> counts{};
    std::array<std::int64_t, kObjKinds> greatest{};  ///< of a stretch's indices
    std::vector<RelativeIndex> relative;             ///< of a stretch
    std::vector<OpenReference> open;                 ///< of a whole text
    std::unordered_set<std::string> seen_materials;

    ObjWarnings warnings;
    std::size_t ignored = 0;
    std::size_t first_ignored = 0;  ///< its offset, and how long its word is
    std::size_t ignored_length = 0;
    std::size_t colored = 0;
    std::size_t first_colored = 0;

    ObjScanner(const ObjText& obj, std::size_t begin, std::size_t end, bool stretch)
        : text(obj), cursor(obj, begin, end), is_stretch(stretch), warnings(obj) {}
};

/// One corner: v, v/vt, v//vn or v/vt/vn. Throws UserError.
void scan_corner(ObjScanner& s, std::string_view token);

/// The same where the next word is a corner of plain indices of what is there; false, and nothing is read: it is not.
[[nodiscard]] bool scan_plain_corner(ObjScanner& s);

/// What an index names must be somewhere in the text. A normal that is nowhere is made, as for a corner without one;
/// texture coordinates of a text that has none are left out. Throws UserError.
void settle_open_references(ObjScanner& s);

/// Scan all statements up to the end of the stretch. Throws UserError.
void scan_statements(ObjScanner& s);

/// One after another. False: an index leads nowhere, and the text must be scanned as a whole. The stretches are
/// emptied.
[[nodiscard]] bool join_stretches(std::vector<ObjScanner>& stretches, ObjScan& whole);

}  // namespace kreda::scene
