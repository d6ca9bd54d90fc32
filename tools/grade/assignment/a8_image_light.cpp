// A8: light from an image, by samples.
#include <cmath>

#include <glm/geometric.hpp>

#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/sky.hpp"
#include "lighting/importance.hpp"
#include "lighting/microfacet.hpp"
#include "lighting/reflection.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

constexpr int kHeight = 16;  // of the image
constexpr int kWidth = 2 * kHeight;
constexpr int kSamples = 16;

/// Texel by texel, wrapped in u, cut in v.
glm::vec3 radiance_at(const StageRow& row, const glm::vec2& uv) {
    const float x = uv.x * kWidth - 0.5f, y = uv.y * kHeight - 0.5f;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const float s = x - static_cast<float>(left), t = y - static_cast<float>(top);
    const auto texel = [&](int column, int line) {
        const int wrapped = (column + kWidth) % kWidth;
        const int cut = line < 0 ? 0 : (line >= kHeight ? kHeight - 1 : line);
        return row.vec3_at("texels", static_cast<std::size_t>(cut * kWidth + wrapped));
    };
    const glm::vec3 upper = (1.0f - s) * texel(left, top) + s * texel(left + 1, top);
    const glm::vec3 lower = (1.0f - s) * texel(left, top + 1) + s * texel(left + 1, top + 1);
    return (1.0f - t) * upper + t * lower;
}

glm::vec3 radiance_from(const StageRow& row, const glm::vec3& d) {
    return radiance_at(row, lighting::equirect_point(d));
}

glm::vec3 irradiance(const StageRow& row, const glm::vec3& n, int samples) {
    const auto frame = lighting::frame_around(n);
    glm::vec3 sum(0.0f);
    for (int i = 0; i < samples; ++i) {
        sum += radiance_from(row, to_world(frame, lighting::cosine_direction(lighting::hammersley(i, samples))));
    }
    return sum * (raster::kPi / static_cast<float>(samples));
}

glm::vec3 prefiltered(const StageRow& row, const glm::vec3& n, float alpha, int samples) {
    const auto frame = lighting::frame_around(n);
    glm::vec3 sum(0.0f);
    float weights = 0.0f;
    for (int i = 0; i < samples; ++i) {
        const glm::vec3 h = to_world(frame, lighting::ggx_half_vector(lighting::hammersley(i, samples), alpha));
        const glm::vec3 l = lighting::mirror_vector(h, n);
        const float n_dot_l = glm::dot(n, l);
        if (n_dot_l <= 0.0f) continue;
        sum += n_dot_l * radiance_from(row, l);
        weights += n_dot_l;
    }
    return sum * (1.0f / weights);
}

/// lod = log2(w_s / w_p) / 2,  w_s = 1 / (N p),  w_p = 4 pi / (6 width^2)                 Krivanek & Colbert 2008
float mip_level(float density, int samples, int width) {
    const float side = static_cast<float>(width);
    const float share = 6.0f * side * side / (4.0f * raster::kPi * static_cast<float>(samples) * density);
    const float level = 0.5f * raster::log2(share);
    return level > 0.0f ? level : 0.0f;
}

glm::vec3 shade_image_light(const StageRow& row) {
    const glm::vec3 n = row.vec3("n");
    const int samples = static_cast<int>(row.integer("samples"));
    const glm::vec3 r = lighting::mirror_vector(n, row.vec3("v"));
    return 0.5f * raster::kInvPi * irradiance(row, n, samples) +
           0.5f * prefiltered(row, r, row.number("alpha"), samples);
}

/// The scene's sky as an image, with stripes: a smooth sky would not show which texel was read.
std::vector<double> texels_of(const SceneRecord& record) {
    std::vector<double> texels;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const glm::vec2 uv{(static_cast<float>(x) + 0.5f) / kWidth, (static_cast<float>(y) + 0.5f) / kHeight};
            const float stripes = 0.6f + 0.1f * static_cast<float>((5 * x + 3 * y) % 9);
            const glm::vec3 L =
                stripes * lighting::sky_radiance(record.scene().environment.sky, lighting::equirect_direction(uv));
            texels.insert(texels.end(), {L.x, L.y, L.z});
        }
    }
    return texels;
}

void record_directions(const SceneRecord& record, std::vector<StageTable>& tables) {
    TableBuilder point("equirect_point", record.name), read("radiance", record.name);
    TableBuilder cosine("cosine_direction", record.name), half("ggx_half_vector", record.name);
    TableBuilder level("mip_level", record.name);
    read.list("texels", texels_of(record));
    for (int i = 0; i < 256; ++i) {
        const glm::vec2 u = lighting::hammersley(i, 256);
        const glm::vec3 d = lighting::equirect_direction({u.x, 0.02f + 0.96f * u.y});
        point.add("d", d);
        point.end_row();
        read.add("u_v", u);
        read.end_row();
        cosine.add("u", u);
        cosine.end_row();
        const float alpha = 0.05f + 0.9f * static_cast<float>(i) / 256.0f;
        half.add("u", u);
        half.add("alpha", alpha);
        half.end_row();
        level.add("density", 0.02f + 3.0f * u.y);
        level.add("samples", 8 << (i % 6));
        level.add("width", 16 << (i % 4));
        level.end_row();
    }
    for (const TableBuilder* t : {&point, &read, &cosine, &half, &level}) append_rows(tables, t->table);
}

void record_sums(const SceneRecord& record, float alpha, std::vector<StageTable>& tables) {
    TableBuilder falls("irradiance", record.name), blurred("prefiltered", record.name);
    for (TableBuilder* t : {&falls, &blurred}) t->list("texels", texels_of(record));
    for (const SeenPoint& p : some_points(record, 150)) {
        for (TableBuilder* t : {&falls, &blurred}) {
            t->add("n", lighting::unit(p.normal));
            if (t == &blurred) t->add("alpha", alpha);
            t->add("samples", kSamples);
            t->end_row(p.pixel);
        }
    }
    append_rows(tables, falls.table);
    append_rows(tables, blurred.table);
}

}  // namespace

void record_a8(const SceneRecord& record, std::vector<StageTable>& tables) {
    const lighting::Material& material = record.frame.plan.materials[0].material;
    const float alpha = lighting::alpha_from_roughness(material.cook_torrance.roughness);
    record_directions(record, tables);
    record_sums(record, alpha, tables);
    TableBuilder picture("shade", record.name);
    picture.list("texels", texels_of(record));
    for (const SeenPoint& p : record.points) {
        picture.add("n", lighting::unit(p.normal));
        picture.add("v", lighting::unit(record.frame.lighting.eye - p.position));
        picture.add("alpha", alpha);
        picture.add("samples", kSamples);
        picture.end_row(p.pixel);
    }
    append_rows(tables, picture.table);
}

void reference_a8(StageRow row) {
    const auto samples = [&] { return static_cast<int>(row.integer("samples")); };
    if (row.is("equirect_point")) {
        row.put("u_v", lighting::equirect_point(row.vec3("d")));
    } else if (row.is("radiance")) {
        row.put("L", radiance_at(row, row.vec2("u_v")));
    } else if (row.is("cosine_direction")) {
        row.put("l", lighting::cosine_direction(row.vec2("u")));
    } else if (row.is("irradiance")) {
        row.put("E", irradiance(row, row.vec3("n"), samples()));
    } else if (row.is("ggx_half_vector")) {
        row.put("h", lighting::ggx_half_vector(row.vec2("u"), row.number("alpha")));
    } else if (row.is("mip_level")) {
        row.put("level", mip_level(row.number("density"), samples(), static_cast<int>(row.integer("width"))));
    } else if (row.is("prefiltered")) {
        row.put("blurred", prefiltered(row, row.vec3("n"), row.number("alpha"), samples()));
    } else if (row.is("shade")) {
        row.put("color", shade_image_light(row));
    }
}

}  // namespace kreda::tools
