// Explain, second half: barycentrics, attributes, the light at the sample (or where it was lit before), fog, channels.
#include <cmath>
#include <memory>

#include "lighting/fog.hpp"
#include "scene/render/early_lighting.hpp"
#include "scene/render/render.hpp"
#include "tools/explain/explain.hpp"
#include "tools/explain/explain_light.hpp"

namespace kreda::tools {

namespace {

using scene::ShadingFrequency;

/// Two-sided lighting turned this triangle's normals.
bool is_turned(const SampleFacts& sample) {
    return sample.frame.plan.two_sided && sample.seen().triangle.behind;
}

constexpr const char* kTurned = "turned to the viewer, who sees the triangle from behind (shading.two_sided)";

/// One attribute: at the corners, and between them; turned: its negative.
template <class Attribute>
void interpolated(const char* name, const raster::AlignedVector<Attribute>& stream,
                  const std::array<std::uint32_t, 3>& vertex, const glm::vec3& b, const Attribute& value,
                  Section& section, bool turned = false) {
    std::string numbers;
    const auto text = [](const Attribute& a) {
        if constexpr (std::is_same_v<Attribute, float>)
            return number_text(a);
        else
            return vector_text(a);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        numbers += std::string(i ? " + " : "") + number_text(b[static_cast<int>(i)]) + "·" + text(stream[vertex[i]]);
    }
    std::vector<double> components;
    if constexpr (std::is_same_v<Attribute, float>)
        components = {double{value}};
    else
        for (int i = 0; i < Attribute::length(); ++i) components.push_back(value[i]);
    section.equation(name, (turned ? "-Σ b_i " : "Σ b_i ") + std::string(name) + "_i",
                     turned ? "-(" + numbers + ")" : numbers, components, turned ? kTurned : "");
}

void explain_weights(const SampleFacts& sample, const glm::vec3& b, Section& section) {
    const Cover& seen = sample.seen();
    const raster::VertexStreams& streams = sample.frame.buffers.streams;
    const double area2 = static_cast<double>(seen.edge[0] + seen.edge[1] + seen.edge[2]);
    section.equation(
        "area2", "E_bc + E_ca + E_ab",
        std::to_string(seen.edge[0]) + " + " + std::to_string(seen.edge[1]) + " + " + std::to_string(seen.edge[2]),
        std::vector<double>{area2}, "twice the triangle's area");
    const char* const opposite[3] = {"E_bc", "E_ca", "E_ab"};
    std::string q_sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const double lambda = static_cast<double>(seen.edge[i]) / area2;
        section.equation(std::string("λ_") + kCornerNames[i], std::string(opposite[i]) + " / area2",
                         std::to_string(seen.edge[i]) + " / " + number_text(area2), std::vector<double>{lambda});
    }
    if (sample.frame.plan.interpolation == raster::AttributeInterpolation::affine) {
        section.equation("b", "λ", "", b, "affine: as if nothing were in perspective (shading.interpolation)");
        return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double lambda = static_cast<double>(seen.edge[i]) / area2;
        const double inv_w = streams.screen[seen.triangle.vertex[i]].inv_w;
        section.equation(std::string("q_") + kCornerNames[i],
                         std::string("λ_") + kCornerNames[i] + " / w_" + kCornerNames[i],
                         number_text(lambda) + " · " + number_text(inv_w), std::vector<double>{lambda * inv_w});
    }
    section.equation("b", "q / (q_a + q_b + q_c)", "", b, "weights of the corners in perspective");
}

/// One light's worth of a batch of one.
std::unique_ptr<raster::Fragments> batch_of_one() {
    auto points = std::make_unique<raster::Fragments>();
    points->count = 1;
    return points;
}

/// Gouraud: the light at the three corners of the mesh's triangle.
void explain_corners(const SampleFacts& sample, Derivation& derivation) {
    const scene::Frame& frame = sample.frame;
    const SourceTriangle source = find_source(frame.buffers.instances, sample.seen().triangle.source);
    const std::uint32_t first = frame.buffers.instances[source.object].first_vertex;
    const bool turned = is_turned(sample);
    if (turned) {
        Section side{"side", "the side that is seen", {}};
        side.say(
            "The viewer sees this triangle from behind: its corners are lit once more with their normals turned, "
            "n = -normal (shading.two_sided), and these are the colours that it shows.");
        derivation.sections.push_back(side);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto points = batch_of_one();
        scene::set_vertex_points(frame, first + source.vertex[i], 1, turned, *points);
        const std::string number = std::to_string(i);
        explain_lighting(
            {frame, *points, sample.seen().triangle.material, "corner " + number + ": ", "corner_" + number + "_"},
            derivation);
    }
    Section section{"between", "between the corners", {}};
    section.equation("radiance", "Σ b_i radiance_i", "", sample.passes->fragments->color.at(0),
                     "shading.frequency = \"gouraud\": colours are interpolated, not lit again");
    derivation.sections.push_back(section);
}

/// Flat: the light at the centroid.
void explain_centroid(const SampleFacts& sample, Derivation& derivation) {
    const scene::Frame& frame = sample.frame;
    const raster::TriangleChunk& chunk = frame.buffers.triangles.chunks[sample.seen().id >> raster::kChunkShift];
    const auto points = batch_of_one();
    const float orientation = scene::orientation_of(frame.buffers.instances[chunk.instance].world_from_object);
    set_flat_point(frame.buffers, chunk, sample.seen().triangle, orientation, is_turned(sample), 0, *points);
    Section section{"centroid", "lit once for the whole triangle", {}};
    section.say(
        "shading.frequency = \"flat\": the triangle of the mesh is lit at its centroid, with the normal of its plane.");
    section.equation("centroid", "(p_0 + p_1 + p_2) / 3", "", points->position.at(0), "world space");
    const bool minus = is_turned(sample) != (orientation < 0.0f);
    section.equation("normal", minus ? "-(p_1 - p_0) × (p_2 - p_0)" : "(p_1 - p_0) × (p_2 - p_0)", "",
                     points->normal.at(0), is_turned(sample) ? kTurned : "");
    derivation.sections.push_back(section);
    explain_lighting({frame, *points, sample.seen().triangle.material, "centroid: ", "centroid_"}, derivation);
}

void explain_fog_factor(const SampleFacts& sample, Section& section) {
    const lighting::LightingSetup& setup = sample.frame.lighting;
    const lighting::Fog& fog = setup.fog;
    const glm::vec3 p = sample.passes->fragments->position.at(0);
    const bool planar = fog.distance == lighting::FogDistance::planar;
    const float z =
        planar ? lighting::planar_distance(p, setup.eye, setup.forward) : lighting::radial_distance(p, setup.eye);
    section.equation(
        "z_p", planar ? "(p - eye)·forward" : "|p - eye|",
        planar ? dot_text(p - setup.eye, setup.forward) : "|" + vector_text(p) + " - " + vector_text(setup.eye) + "|",
        z, planar ? "distance from the plane of the eye" : "distance from the eye");
    const float f = sample.passes->lighting->fog.at(0);
    const std::string d = number_text(fog.density), z_text = number_text(z);
    switch (fog.mode) {
        case lighting::FogMode::none: return;
        case lighting::FogMode::linear:
            return section.equation("f", "(end - z_p) / (end - start), in 0..1",
                                    "(" + number_text(fog.end) + " - " + z_text + ") / (" + number_text(fog.end) +
                                        " - " + number_text(fog.start) + ")",
                                    f);
        case lighting::FogMode::exp:
            return section.equation("f", "exp(-density z_p)", "exp(-" + d + "·" + z_text + ")", f);
        case lighting::FogMode::exp2:
            return section.equation("f", "exp(-(density z_p)²)", "exp(-(" + d + "·" + z_text + ")²)", f);
    }
}

}  // namespace

void explain_interpolation(const SampleFacts& sample, Derivation& derivation) {
    const raster::VertexStreams& streams = sample.frame.buffers.streams;
    const std::uint32_t material = sample.seen().triangle.material;
    const raster::FragmentNeeds& needs = sample.frame.plan.fragment_of_material[material];
    const raster::Fragments& f = *sample.passes->fragments;
    const std::array<std::uint32_t, 3> v = sample.seen().triangle.vertex;
    const glm::vec3 b =
        corner_weights_at(streams, sample.seen().triangle, sample.x, sample.y, sample.frame.plan.interpolation);
    Section section{"interpolation", "barycentric coordinates and attributes", {}};
    explain_weights(sample, b, section);
    if (needs.position) interpolated("position", streams.position_world, v, b, f.position.at(0), section);
    if (needs.normal) interpolated("normal", streams.normal_world, v, b, f.normal.at(0), section, is_turned(sample));
    if (needs.uv) interpolated("uv", streams.uv, v, b, glm::vec2(f.u.at(0), f.v.at(0)), section);
    if (needs.color && !streams.color.empty()) {
        const auto& color = is_turned(sample) ? streams.color_behind : streams.color;
        interpolated("color", color, v, b, f.color.at(0), section);
    }
    if (needs.fog) interpolated("fog", streams.fog, v, b, f.fog.at(0), section);
    derivation.sections.push_back(section);
}

void explain_shading(const SampleFacts& sample, Derivation& derivation) {
    switch (sample.frame.plan.frequency) {
        case ShadingFrequency::phong:
            explain_lighting({sample.frame, *sample.passes->fragments, sample.seen().triangle.material, "", ""},
                             derivation);
            return;
        case ShadingFrequency::gouraud: return explain_corners(sample, derivation);
        case ShadingFrequency::flat: return explain_centroid(sample, derivation);
    }
}

void explain_fog(const SampleFacts& sample, Derivation& derivation) {
    const scene::RenderPlan& plan = sample.frame.plan;
    if (!plan.fog_at_pixels && !plan.fog_at_vertices) return;
    Section section{"fog", "fog", {}};
    if (plan.fog_at_pixels)
        explain_fog_factor(sample, section);
    else
        section.equation("f", "Σ b_i f_i", "", sample.passes->lighting->fog.at(0),
                         "fog.frequency = \"vertex\": interpolated");
    const float f = sample.passes->lighting->fog.at(0);
    section.equation("c_f", "", "", sample.frame.lighting.fog.color, "the fog's colour");
    section.equation(
        "radiance", "f radiance + (1 - f) c_f",
        number_text(f) + "·radiance + " + number_text(1.0f - f) + "·" + vector_text(sample.frame.lighting.fog.color),
        sample.radiance);
    derivation.sections.push_back(section);
}

void explain_channels(const SampleFacts& sample, Derivation& derivation) {
    Section section{"channels", "every channel that the passes left", {}};
    Table table{"channels", {"channel", "value", "what it is"}, {}};
    const scene::BatchChannels batch{*sample.passes->fragments, *sample.passes->lighting};
    for (const scene::View* view : sample.frame.plan.views) {
        if (!view->holds(sample.frame.plan, sample.seen().triangle.material)) continue;
        std::string value = number_text(sample.seen().depth);
        if (view->value && view->components == 1) value = number_text(view->value(batch, 0, 0));
        if (view->value && view->components == 3) {
            value =
                vector_text(glm::vec3(view->value(batch, 0, 0), view->value(batch, 0, 1), view->value(batch, 0, 2)));
        }
        table.rows.push_back({std::string(view->name), value, std::string(view->meaning)});
    }
    section.put(table);
    derivation.sections.push_back(section);
}

}  // namespace kreda::tools
