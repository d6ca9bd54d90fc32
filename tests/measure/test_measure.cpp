// Tables, times and files of experiments.
#include <string>

#include <doctest/doctest.h>

#include "tests/scene/temp_folder.hpp"
#include "tools/draw/gnuplot.hpp"
#include "tools/measure/measure.hpp"
#include "tools/measure/paired_times.hpp"
#include "tools/measure/picture.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::tools;

TEST_CASE("csv: a table comes back with commas and quotes and line breaks") {
    const ResultTable table{{"a, b", "c"}, {{"1", "say \"x\""}, {"two\nlines", ""}}};
    const ResultTable back = table_of_csv(csv_of(table));
    CHECK(back.columns == table.columns);
    CHECK(back.rows == table.rows);
}

TEST_CASE("paired times: medians and quartiles and a ratio that is told apart or not") {
    // First 10 in every round; the second is twice that but for a round that somebody else disturbed; the third varies.
    const std::vector<PairedTime> times =
        paired_times_of({{10, 20, 9}, {10, 20, 11}, {10, 90, 12}, {10, 20, 8}, {10, 20, 10}});
    CHECK(times[1].median == 20.0);
    CHECK(times[1].ratio == 2.0);
    CHECK(times[1].is_told_apart);
    CHECK(times[2].lower == 9.0);
    CHECK(times[2].upper == 11.0);
    CHECK_FALSE(times[2].is_told_apart);
    CHECK(in_words(times[1], "X") == "2.00 times the time of X");
    CHECK(in_words(times[2], "X").find("noise") != std::string::npos);
}

TEST_CASE("code error: of four pixels by hand") {
    raster::Image a = raster::make_image(2, 2, 3), b = a;
    b.set_rgb(0, 0, glm::vec3(3.0f, 1.0f, 0.0f) / 255.0f);
    b.set_rgb(1, 1, glm::vec3(0.0f, 0.0f, 9.0f) / 255.0f);
    const CodeError error = code_error(a, b);
    CHECK(error.mean == doctest::Approx((3.0 + 9.0) / 4.0));  // the most of the channels counts
    CHECK(error.worst == 9.0);
    CHECK(error.p99 == 9.0);
}

TEST_CASE("code error: one pixel of two hundred is beyond the 99th percentile") {
    std::vector<float> differences(200, 1.0f);
    differences[17] = 100.0f;
    CHECK(code_error(differences).p99 == 1.0);
    differences[18] = differences[19] = 100.0f;
    CHECK(code_error(differences).p99 == 100.0);
}

TEST_CASE("measure: an experiment that is whole is not run again and one that is damaged is") {
    const TempFolder folder;
    const MeasureOptions options{folder.path.string(), true, false, 1};
    const Experiment& experiment = *find_experiment("transfer");
    CHECK(measure_one(experiment, options));
    CHECK_FALSE(measure_one(experiment, options));
    CHECK(measure_one(experiment, {options.folder, false, false, 1}));  // not quick: other inputs
    folder.write("transfer.csv", "damaged");
    CHECK(measure_one(experiment, options));
    CHECK(table_of_csv(bytes_of(folder.file("transfer.csv"))).rows.size() == 40);
    if (has_gnuplot()) CHECK(bytes_of(folder.file("transfer.svg")).find("<svg") != std::string::npos);
    CHECK(report_page(options.folder).find("power of 2.2") != std::string::npos);
}

TEST_CASE("measure: a paragraph's numbers are those of its table") {
    const Finding finding = find_experiment("depth")->run({true, 1, {}});
    double at_1e9 = 0.0;
    for (const auto& row : finding.table.rows) {
        if (row[0] == "24 bits" && row[1] == "1e+09") at_1e9 = std::stod(row[3]);
    }
    // z^2 (f - n) / (f n 2^24) over the distance, z = 0.999 f: 0.998 1e9 / 16777215
    CHECK(at_1e9 == doctest::Approx(0.999 * 0.999 * 1e9 / 16777215.0).epsilon(1e-3));
    CHECK(finding.text.find(digits(at_1e9)) != std::string::npos);
}

TEST_CASE("measure: Schlick misses what was published and a table errs as the square of its step") {
    const Finding fresnel = find_experiment("fresnel")->run({true, 1, {}});
    const auto error = [&](const std::string& material, const std::string& method) {
        for (const auto& row : fresnel.table.rows) {
            if (row[0] == material && row[1] == method) return std::stod(row[2]);
        }
        return -1.0;
    };
    // Stetic-Kozic 2014, tables 2 and 3, in percent
    CHECK(std::abs(error("gold", "Schlick, rescaled") - 0.98) < 0.02);
    CHECK(std::abs(error("platinum", "Schlick, rescaled") - 5.31) < 0.02);
    CHECK(std::abs(error("water", "Schlick, without k") - 8.68) < 0.02);
    CHECK(std::abs(error("diamond", "Schlick, without k") - 3.8) < 0.02);
    CHECK(std::abs(error("gold", "corrected") - 0.82) < 0.02);
    CHECK(std::abs(error("platinum", "corrected") - 2.07) < 0.02);
}

TEST_CASE(
    "measure: the plots' names in a script are quoted and a point that a logarithm has no place for is left out") {
    const Plot plot{"x's", "y", true, true, {{"it's", {{1.0, 2.0}, {0.0, 1.0}}}}, true};
    const std::string script = gnuplot_script(plot, "t", "f'g");
    CHECK(script.find("'it''s'") != std::string::npos);
    CHECK(script.find("'f''g.svg'") != std::string::npos);
    CHECK(script.find("0 1\n") == std::string::npos);
    CHECK(script.find("1 2\n") != std::string::npos);
}
