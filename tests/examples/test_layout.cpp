// The judge of layouts finds what it should.
#include <doctest/doctest.h>

#include "layout.hpp"
#include "plot_layout.hpp"
#include "tools/draw/type.hpp"

using namespace kreda::tests;

TEST_CASE("layout: a text that leaves its picture or lies over another one or is too small is found") {
    const PlacedText good{"a", 640, 360, 10, 10, 60, 30, 16, "good"};
    PlacedText outside = good, over = good, small = good, elsewhere = good, beside = good;
    outside.right = 641;
    over.left = 59;
    over.right = 90;
    small.size = 11.9f;
    elsewhere.picture = "b";
    beside.left = 60;
    beside.right = 90;
    CHECK(layout_faults({good}).empty());
    CHECK(layout_faults({good, elsewhere}).empty());
    CHECK(layout_faults({good, beside}).empty());
    CHECK(layout_faults({outside}).size() == 1);
    CHECK(layout_faults({good, over}).size() == 1);
    CHECK(layout_faults({small}).size() == 1);
}

namespace {

/// What gnuplot 5.4 writes of a plot of 400 x 200, shortened: a text, a curve, the ground of the legend, a name in it.
std::string small_plot(const char* size, const char* place, const char* curve) {
    return std::string("<svg\n width=\"400\" height=\"200\"\n>\n<g transform=\"translate(") + place +
           ")\" stroke=\"none\" font-family=\"DejaVu Sans\" font-size=\"" + size +
           "\"  text-anchor=\"end\">\n\t\t<text><tspan font-family=\"DejaVu Sans\" > 10</tspan></text>\n</g>\n"
           "<g id=\"gnuplot_plot_1\" ><title>exp</title>\n<path stroke='rgb(1,2,3)'  d='" +
           curve +
           "'/></g>\n<polygon fill = 'rgb(0,0,0)' points = '200,80 300,80 300,20 200,20 '/>\n"
           "<g id=\"gnuplot_plot_1\" ><title>exp</title>\n<g transform=\"translate(280,50)\" stroke=\"none\" "
           "font-size=\"20\"  text-anchor=\"end\">\n<text><tspan>exp</tspan></text>\n</g>\n"
           "<path d='M210,50 L240,50  '/></g>\n";
}

std::vector<std::string> faults_of(const char* size, const char* place, const char* curve) {
    return plot_faults(read_plot_layout("p", small_plot(size, place, curve)), 15.0f);
}

}  // namespace

TEST_CASE("layout: a plot whose legend hides a curve or whose texts are cut or small is found") {
    const char* const beside = "M0,100 L400,90  ";
    CHECK(faults_of("20.00", "60,150", beside).empty());
    CHECK(faults_of("14.00", "60,150", beside).size() == 1);
    CHECK(faults_of("20.00", "60,150", "M0,0 L400,100  ").size() == 1);  // passes (240, 60)
    CHECK(faults_of("20.00", "60,150", "M0,80 L400,80  ").empty());      // along the legend's border
    if (!kreda::tools::has_typeface()) return;                           // then texts have no width
    CHECK(faults_of("20.00", "10,150", beside).size() == 1);             // two digits are 25 wide
    CHECK(faults_of("20.00", "270,50", beside).size() == 1);             // over the legend's text
}
