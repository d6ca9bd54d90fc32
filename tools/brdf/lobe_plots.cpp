#include "tools/brdf/lobe_plots.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tools/draw/gnuplot.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

constexpr int kWidth = 1100, kRowHeight = 220, kBallSide = 180;
constexpr double kLobeIncidences[] = {20.0, 60.0};

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

std::string line_of(const LobeModel& model, float roughness, double incidence) {
    return std::string(model.name) + "," + number(double(roughness)) + "," + number(incidence) + ",";
}

std::vector<float> rows_of(const LobeModel& model) {
    return model.has_roughness ? plotted_roughnesses() : std::vector<float>{1.0f};
}

/// Calls visit(theta, f) along the plane of incidence; the lamp stands at -incidence.
template <class Visit>
void walk_plane(const Reflector& reflector, double incidence, Visit visit) {
    constexpr int kSteps = 359;
    for (int i = 1; i <= kSteps; ++i) {
        const double theta = -90.0 + 0.5 * i;
        visit(theta, brdf(reflector, direction(-incidence), direction(theta)));
    }
}

/// The greatest f of a list that is not empty.
double greatest(const std::vector<double>& all) {
    return std::max(*std::max_element(all.begin(), all.end()), 1e-30);
}

/// Block $pR_I of a row: theta, f, and f as a share of its greatest value.
std::string plane_block(const Reflector& reflector, int row, std::size_t i) {
    std::vector<double> angles, values;
    walk_plane(reflector, plotted_incidences()[i], [&](double theta, double f) {
        angles.push_back(theta);
        values.push_back(f);
    });
    const double most = greatest(values);
    std::string text = "$p" + std::to_string(row) + "_" + std::to_string(i) + " << EOD\n";
    for (std::size_t k = 0; k < values.size(); ++k)
        text += number(angles[k]) + " " + number(values[k]) + " " + number(values[k] / most) + "\n";
    return text + "EOD\n";
}

/// Block $lR_I of a row: the points of a lobe, which is 1 long where it is longest.
std::string lobe_block(const Reflector& reflector, int row, std::size_t i) {
    constexpr int kRings = 45, kSectors = 60;
    std::vector<glm::dvec3> directions;
    std::vector<double> values;
    for (int ring = 0; ring <= kRings; ++ring) {
        for (int sector = 0; sector <= kSectors; ++sector) {
            directions.push_back(direction(89.9 * ring / kRings, 360.0 * sector / kSectors));
            values.push_back(brdf(reflector, direction(-kLobeIncidences[i]), directions.back()));
        }
    }
    const double most = greatest(values);
    std::string text = "$l" + std::to_string(row) + "_" + std::to_string(i) + " << EOD\n";
    for (std::size_t k = 0; k < values.size(); ++k) {
        const glm::dvec3 p = directions[k] * (values[k] / most);
        text += number(p.x) + " " + number(p.y) + " " + number(p.z) + "\n";
        if ((k + 1) % (kSectors + 1) == 0) text += "\n";
    }
    return text + "EOD\n";
}

/// One panel's place: column of five, row from the top.
std::string place(int column, int row, int rows) {
    const double height = 0.93 / rows;
    return "set origin " + number(0.2 * column) + "," + number(0.93 - height * (row + 1)) + "\nset size 0.2," +
           number(height) + "\n";
}

std::string curves(int row, const std::string& columns, bool named, const std::vector<double>& reflectances) {
    std::string text = "plot ";
    for (std::size_t i = 0; i < plotted_incidences().size(); ++i) {
        char name[64];
        std::snprintf(name, sizeof name, "%g°  R = %.3f", plotted_incidences()[i], reflectances[i]);
        text += std::string(i ? ", " : "") + "$p" + std::to_string(row) + "_" + std::to_string(i) + " using " +
                columns + " with lines linewidth 1.5 dashtype " + std::to_string(i + 1) + " linecolor " +
                std::to_string(i + 1) + (named ? " title '" + std::string(name) + "'" : " notitle");
    }
    return text + "\n";
}

std::string lobe_panel(int row, int rows, int i) {
    return place(2 + i, row, rows) + "set title 'lobe, lamp at " + number(kLobeIncidences[i]) +
           "°'\nset view 65,30,2.1\nset view equal xyz\nset xyplane 0\nset hidden3d\nunset tics\nunset border\n"
           "set xrange [-1:1]\nset yrange [-1:1]\nset zrange [0:1]\nsplot $l" +
           std::to_string(row) + "_" + std::to_string(i) +
           " with lines linecolor rgb '#2060a0' linewidth 0.4 notitle\nset tics\nset border\n";
}

std::string row_script(const LobeModel& model, float roughness, int row, int rows, const std::string& ball) {
    const Reflector reflector = make_reflector(model, roughness);
    std::vector<double> reflectances;
    std::string text;
    for (std::size_t i = 0; i < plotted_incidences().size(); ++i) {
        reflectances.push_back(reflectance(reflector, plotted_incidences()[i]));
        text += plane_block(reflector, row, i);
    }
    for (std::size_t i = 0; i < std::size(kLobeIncidences); ++i) text += lobe_block(reflector, row, i);
    const std::string label = model.has_roughness ? ", roughness " + number(double(roughness)) : "";
    text += place(0, row, rows) + "set title 'f / greatest f" + label +
            "'\nset size ratio -1\nset xrange [-1.05:1.05]\nset yrange [-0.85:1.05]\nunset tics\nunset border\n" +
            curves(row, "($3*sin($1*pi/180)):($3*cos($1*pi/180))", true, reflectances);
    text += "set size noratio\nset tics\nset border\n" + place(1, row, rows) +
            "set title 'f [1/sr] over the angle'\nset xrange [-90:90]\nset xtics 45\nset logscale y\n"
            "set format y '%g'\nset yrange [0.01:*]\n" +
            curves(row, "1:2", false, reflectances) + "unset logscale y\nset xtics autofreq\n";
    for (int i = 0; i < 2; ++i) text += lobe_panel(row, rows, i);
    return text + place(4, row, rows) +
           "set title 'ball'\nunset tics\nunset border\nset autoscale\nset size ratio -1\nplot " +
           in_gnuplot_quotes(ball) +
           " binary filetype=png with rgbimage notitle\nset size noratio\nset tics\nset border\n";
}

}  // namespace

const std::vector<float>& plotted_roughnesses() {
    static const std::vector<float> all = {0.3f, 0.5f, 0.8f};
    return all;
}

const std::vector<double>& plotted_incidences() {
    static const std::vector<double> all = {0.0, 30.0, 60.0, 80.0};
    return all;
}

std::string lobe_csv(const LobeModel& model) {
    std::string text = "model,roughness,incidence [deg],theta [deg],f [1/sr]\n";
    for (const float roughness : rows_of(model)) {
        const Reflector reflector = make_reflector(model, roughness);
        for (const double incidence : plotted_incidences()) {
            walk_plane(reflector, incidence, [&](double theta, double f) {
                text += line_of(model, roughness, incidence) + number(theta) + "," + number(f) + "\n";
            });
        }
    }
    return text;
}

std::string reflectance_csv(const std::vector<LobeModel>& models) {
    std::string text = "model,roughness,incidence [deg],reflectance\n";
    for (const LobeModel& model : models) {
        for (const float roughness : rows_of(model)) {
            const Reflector reflector = make_reflector(model, roughness);
            for (const double incidence : plotted_incidences())
                text += line_of(model, roughness, incidence) + number(reflectance(reflector, incidence)) + "\n";
        }
    }
    return text;
}

raster::Image lit_ball(const LobeModel& model, float roughness, int side) {
    const std::string size = std::to_string(side);
    const lighting::Material material = model.material(roughness);
    // A lamp that is s = 1 to the lecture's models is pi to the others.
    const bool is_physical = material.model == lighting::ReflectionModel::cook_torrance;
    scene::Scene scene =
        scene::read_scene_text("[image]\nsize = [" + size + ", " + size +
                                   "]\nsamples = 3\nbackground = [1, 1, 1]\n[camera]\nposition = [0, 0, 5]\n"
                                   "projection = 'orthographic'\nheight = 2.1\n[ambient]\ncolor = [0, 0, "
                                   "0]\n[[light]]\ndirection = [-1, -1, -1]\n"
                                   "intensity = " +
                                   std::string(is_physical ? "3.14159265" : "1") + "\n[[object]]\nmesh = 'sphere'\n",
                               "ball", "");
    scene.materials.at(static_cast<std::size_t>(scene.objects.at(0).part_material.at(0))) = material;
    return raster::develop(scene::render(scene), film_settings(scene.image));
}

bool write_figure(const LobeModel& model, const std::string& folder) {
    const std::string stem = (std::filesystem::path(folder) / model.name).string();
    write_file(stem + ".csv", lobe_csv(model));
    const std::vector<float> roughnesses = rows_of(model);
    const int rows = static_cast<int>(roughnesses.size());
    std::string script = "set terminal pngcairo noenhanced font ',8' size " + std::to_string(kWidth) + "," +
                         std::to_string(kRowHeight * rows + 40) + "\nset output " + in_gnuplot_quotes(stem + ".png") +
                         "\nset grid\nset key bottom center samplen 2\nset multiplot title '" +
                         std::string(model.title) + "' font ',12'\n";
    std::vector<std::string> balls;
    for (int row = 0; row < rows; ++row) {
        const float roughness = roughnesses[static_cast<std::size_t>(row)];
        balls.push_back(stem + "_ball_" + std::to_string(row) + ".png");
        scene::write_png(balls.back(), lit_ball(model, roughness, kBallSide));
        script += row_script(model, roughness, row, rows, balls.back());
    }
    const bool drawn = run_gnuplot(script + "unset multiplot\n");
    std::error_code ignored;
    for (const std::string& ball : balls) std::filesystem::remove(ball, ignored);
    if (!drawn) std::filesystem::remove(stem + ".png", ignored);
    return drawn;
}

}  // namespace kreda::tools
