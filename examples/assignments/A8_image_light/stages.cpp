// A8: which of your functions a row of numbers is for. There is nothing to change here.
#include "assignment.hpp"
#include "harness.hpp"

namespace {

/// The image is the same for all rows of a table: it is read once.
const Environment& image_of(const harness::Row& row) {
    static const harness::Table* table = nullptr;
    static Environment image;
    if (table != &row.table || row.index == 0) {
        table = &row.table;
        const int texels = static_cast<int>(row.count("texels", 3));
        const int height = static_cast<int>(std::lround(std::sqrt(texels / 2.0)));
        image = {2 * height, height, {}};
        for (int i = 0; i < texels; ++i) image.texels.push_back(row.vec3_at("texels", static_cast<std::size_t>(i)));
    }
    return image;
}

}  // namespace

void run_row(harness::Row row) {
    const auto samples = [&] { return static_cast<int>(row.integer("samples")); };
    if (row.is("equirect_point")) {
        row.put("u_v", equirect_point(row.vec3("d")));
    } else if (row.is("radiance")) {
        row.put("L", radiance(image_of(row), row.vec2("u_v")));
    } else if (row.is("cosine_direction")) {
        row.put("l", cosine_direction(row.vec2("u")));
    } else if (row.is("irradiance")) {
        row.put("E", irradiance(image_of(row), row.vec3("n"), samples()));
    } else if (row.is("ggx_half_vector")) {
        row.put("h", ggx_half_vector(row.vec2("u"), row.number("alpha")));
    } else if (row.is("mip_level")) {
        row.put("level", mip_level(row.number("density"), samples(), static_cast<int>(row.integer("width"))));
    } else if (row.is("prefiltered")) {
        row.put("blurred", prefiltered(image_of(row), row.vec3("n"), row.number("alpha"), samples()));
    } else if (row.is("shade")) {
        row.put("color", shade(image_of(row), row.vec3("n"), row.vec3("v"), row.number("alpha"), samples()));
    }
}
