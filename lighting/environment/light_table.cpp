#include "lighting/environment/light_table.hpp"

#include <algorithm>

namespace kreda::lighting {

namespace {

double luminance(const glm::vec3& color) {
    return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
}

/// The mean of the bilinear look-up over a texel: 3 x 3 texels with weights 1 6 1 a side. Half a texel to each side of
/// the centre, a neighbour's weight grows from 0 to 1/2: 1/8 in the mean.
double mean_luminance(const CubeMap& map, int face, int x, int y) {
    constexpr double kWeight[3] = {0.125, 0.75, 0.125};
    double sum = 0.0;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            sum += kWeight[i] * kWeight[j] * luminance(map.texel(0, face, x + i - 1, y + j - 1));
        }
    }
    return std::max(sum, 0.0);
}

/// Weights of one row of texels.
std::vector<double> row_weights(const CubeMap& map, int row, bool black) {
    const int size = map.levels[0].size;
    std::vector<double> weights(static_cast<std::size_t>(size));
    for (int x = 0; x < size; ++x) {
        const double bright = black ? 1.0 : mean_luminance(map, row / size, x, row % size);
        weights[static_cast<std::size_t>(x)] = bright * texel_solid_angle(size, x, row % size);
    }
    return weights;
}

/// Running sums over the total, the last one 1; returns the total.
double accumulate(const std::vector<double>& weights, float* ends) {
    double total = 0.0, sum = 0.0;
    for (const double weight : weights) total += weight;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i];
        ends[i] = total > 0.0 ? static_cast<float>(sum / total) : 1.0f;
    }
    ends[weights.size() - 1] = 1.0f;
    return total;
}

bool is_black(const CubeMap& map) {
    const int size = map.levels[0].size;
    for (int row = 0; row < kCubeFaces * size; ++row) {
        for (int x = 0; x < size; ++x) {
            if (mean_luminance(map, row / size, x, row % size) > 0.0) return false;
        }
    }
    return true;
}

/// An interval of a CDF, and where in it u lies, in [0, 1).
struct Choice {
    int index;
    float within;
};
Choice choose(const float* ends, int count, float u) {
    const int index = std::min(static_cast<int>(std::upper_bound(ends, ends + count, u) - ends), count - 1);
    const float begin = index > 0 ? ends[index - 1] : 0.0f;
    const float width = ends[index] - begin;
    return {index, width > 0.0f ? std::min((u - begin) / width, 0.99999994f) : 0.5f};
}

}  // namespace

LightTable make_light_table(const CubeMap& map) {
    LightTable table;
    table.size = map.levels[0].size;
    const int size = table.size, rows = kCubeFaces * size;
    const auto row_count = static_cast<std::size_t>(rows), side = static_cast<std::size_t>(size);
    const bool black = is_black(map);
    table.row_end.resize(row_count);
    table.column_end.resize(row_count * side);
    table.density.resize(row_count * side);
    std::vector<double> row_total(row_count);
#pragma omp parallel for
    for (int row = 0; row < rows; ++row) {
        const auto r = static_cast<std::size_t>(row);
        row_total[r] = accumulate(row_weights(map, row, black), &table.column_end[r * side]);
    }
    accumulate(row_total, table.row_end.data());
    // The density is that of the CDFs as they are in float: what is chosen is what is divided by.
    for (std::size_t r = 0; r < row_count; ++r) {
        const double row_share = double{table.row_end[r]} - (r > 0 ? table.row_end[r - 1] : 0.0f);
        for (std::size_t x = 0; x < side; ++x) {
            const float* end = &table.column_end[r * side];
            const double share = row_share * (double{end[x]} - (x > 0 ? end[x - 1] : 0.0f));
            table.density[r * side + x] = static_cast<float>(share * size * size * 0.25);
        }
    }
    return table;
}

glm::vec3 choose_light(const LightTable& table, const glm::vec2& u) {
    const int size = table.size;
    const Choice row = choose(table.row_end.data(), kCubeFaces * size, u.y);
    const Choice column = choose(&table.column_end[static_cast<std::size_t>(row.index) * table.size], size, u.x);
    const float scale = 1.0f / static_cast<float>(size);
    const CubePoint point{row.index / size, (static_cast<float>(column.index) + column.within) * scale,
                          (static_cast<float>(row.index % size) + row.within) * scale};
    return glm::normalize(direction_of(point));
}

}  // namespace kreda::lighting
