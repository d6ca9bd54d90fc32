#include "tools/bench/time_report.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "raster/platform.hpp"

namespace kreda::tools {

namespace {

/// The clock is no better than a microsecond; more digits would only look exact.
double to_microseconds(double ms) {
    return std::round(ms * 1000.0) / 1000.0;
}

nlohmann::ordered_json stage_medians(const std::vector<scene::RenderStatistics>& frames) {
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    const auto& first = frames.front().times.stages;
    for (std::size_t s = 0; s < first.size(); ++s) {
        std::vector<double> values;
        for (const scene::RenderStatistics& frame : frames) values.push_back(frame.times.stages.at(s).second);
        stages[first[s].first] = to_microseconds(median(values));
    }
    return stages;
}

}  // namespace

double median(std::vector<double> values) {
    KREDA_EXPECT(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    if (values.size() % 2 == 1) return values[middle];
    return 0.5 * (values[middle - 1] + values[middle]);
}

std::string json_line(const TimeReport& report) {
    std::vector<double> totals;
    for (const scene::RenderStatistics& frame : report.frames) totals.push_back(frame.times.total_ms);
    std::vector<double> encoding;
    for (const scene::RenderStatistics& each : report.frames) encoding.push_back(each.times.display_ms);
    const scene::RenderStatistics& frame = report.frames.back();  // the counts are the same in every frame
    nlohmann::ordered_json json;
    json["stages"] = stage_medians(report.frames);
    json["total_ms"] = to_microseconds(median(totals));
    json["around"] = {{"loading", to_microseconds(report.around.load)},
                      {"baking", to_microseconds(report.around.bake)},
                      {"encoding", to_microseconds(median(encoding))},
                      {"writing", to_microseconds(report.around.write)}};
    json["triangles"] = frame.triangles.input;
    json["pixels_shaded"] = frame.samples_shaded;
    json["width"] = report.width;
    json["height"] = report.height;
    json["samples"] = report.samples;
    json["threads"] = report.threads;
    json["frames"] = report.frames.size();
    json["drawn"] = frame.triangles.drawn;
    json["culled"] = frame.triangles.culled;
    json["outside"] = frame.triangles.outside;
    json["clipped"] = frame.triangles.clipped;
    json["degenerate"] = frame.triangles.degenerate;
    json["non_finite"] = frame.triangles.non_finite;
    return json.dump();
}

}  // namespace kreda::tools
