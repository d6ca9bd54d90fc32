// Stretches of an OBJ text that were scanned side by side become one scan.
#include <algorithm>
#include <utility>

#include "scene/files/obj_scanner.hpp"

namespace kreda::scene {

namespace {

/// Where the elements of each stretch begin among all.
struct Offsets {
    std::array<std::int64_t, kObjKinds> elements{};  ///< positions, texture coordinates, normals
    std::size_t corners = 0;
    std::size_t faces = 0;
};

std::vector<Offsets> offsets_of(const std::vector<ObjScanner>& stretches) {
    std::vector<Offsets> offsets(1);
    for (const ObjScanner& s : stretches) {
        Offsets next = offsets.back();
        for (std::size_t kind = 0; kind < kObjKinds; ++kind) next.elements[kind] += s.counts[kind];
        next.corners += s.scan.corners.size();
        next.faces += s.scan.faces.size();
        offsets.push_back(next);
    }
    return offsets;
}

/// Indices that count from the stretch's first element count from the text's. False: one leads nowhere.
bool settle_indices(ObjScanner& s, const Offsets& first, const Offsets& all) {
    for (std::size_t kind = 0; kind < kObjKinds; ++kind) {
        if (s.greatest[kind] > all.elements[kind]) return false;
    }
    for (const RelativeIndex& relative : s.relative) {
        int& index = index_of(s.scan.corners[relative.corner], relative.kind);
        const std::int64_t from_zero = index + first.elements[relative.kind];
        if (from_zero < 0) return false;
        index = static_cast<int>(from_zero);
    }
    return true;
}

template <class Element>
void copy_to(std::vector<Element>& whole, std::size_t first, std::vector<Element>& part) {
    std::copy(part.begin(), part.end(), whole.begin() + static_cast<std::ptrdiff_t>(first));
    part = {};
}

void join_arrays(std::vector<ObjScanner>& stretches, const std::vector<Offsets>& offsets, ObjScan& whole) {
    const Offsets& all = offsets.back();
    whole.positions.resize(static_cast<std::size_t>(all.elements[0]));
    whole.uvs.resize(static_cast<std::size_t>(all.elements[1]));
    whole.normals.resize(static_cast<std::size_t>(all.elements[2]));
    whole.corners.resize(all.corners);
    whole.faces.resize(all.faces);
    const int count = static_cast<int>(stretches.size());
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
        ObjScan& part = stretches[static_cast<std::size_t>(i)].scan;
        const Offsets& first = offsets[static_cast<std::size_t>(i)];
        for (ObjFace& face : part.faces) face.first_corner += static_cast<std::uint32_t>(first.corners);
        copy_to(whole.positions, static_cast<std::size_t>(first.elements[0]), part.positions);
        copy_to(whole.uvs, static_cast<std::size_t>(first.elements[1]), part.uvs);
        copy_to(whole.normals, static_cast<std::size_t>(first.elements[2]), part.normals);
        copy_to(whole.corners, first.corners, part.corners);
        copy_to(whole.faces, first.faces, part.faces);
    }
}

/// What holds from one statement to the next one of its kind goes on from stretch to stretch.
struct Carried {
    std::string name, material;
    std::uint32_t smoothing_group = 0;
};

void join_runs(const ObjScanner& s, std::size_t first_face, Carried& carried, ObjScan& whole) {
    for (const RunOfStretch& run : s.runs) {
        const ObjRun next{run.name.value_or(carried.name), run.material.value_or(carried.material),
                          first_face + run.first_face};
        const bool goes_on =
            !whole.runs.empty() && whole.runs.back().name == next.name && whole.runs.back().material == next.material;
        if (!goes_on) whole.runs.push_back(next);
    }
    carried.name = s.name.value_or(carried.name);
    carried.material = s.material.value_or(carried.material);
}

void join_smoothing_groups(ObjScanner& s, Carried& carried) {
    const std::size_t end = std::min(s.faces_before_group, s.scan.faces.size());
    for (std::size_t f = 0; f < end; ++f) s.scan.faces[f].smoothing_group = carried.smoothing_group;
    if (s.scan.has_smoothing_groups) carried.smoothing_group = s.smoothing_group;
}

}  // namespace

bool join_stretches(std::vector<ObjScanner>& stretches, ObjScan& whole) {
    const std::vector<Offsets> offsets = offsets_of(stretches);
    Carried carried;
    std::unordered_set<std::string> seen_materials;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        ObjScanner& s = stretches[i];
        if (!settle_indices(s, offsets[i], offsets.back())) return false;
        join_smoothing_groups(s, carried);
        join_runs(s, offsets[i].faces, carried, whole);
        whole.has_smoothing_groups |= s.scan.has_smoothing_groups;
        for (ObjName& name : s.scan.material_files) whole.material_files.push_back(std::move(name));
        for (ObjName& used : s.scan.materials) {
            if (seen_materials.insert(used.name).second) whole.materials.push_back(std::move(used));
        }
        for (std::string& line : s.warnings.lines()) whole.warnings.push_back(std::move(line));
    }
    if (stretches.size() > 1) {
        join_arrays(stretches, offsets, whole);
        return true;
    }
    ObjScan& only = stretches[0].scan;
    whole.positions = std::move(only.positions);
    whole.uvs = std::move(only.uvs);
    whole.normals = std::move(only.normals);
    whole.corners = std::move(only.corners);
    whole.faces = std::move(only.faces);
    return true;
}

}  // namespace kreda::scene
