// Bounds of rounding, twice: Gappa proves each from the operations and the ranges of a formula (tests/bounds/NAME.g),
// and a million random inputs stay below it. The sweep reads the bound from the certificate: both speak of the same
// number.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <doctest/doctest.h>

#include "lighting/fog.hpp"
#include "lighting/fresnel.hpp"
#include "lighting/microfacet.hpp"
#include "raster/film.hpp"
#include "raster/scalar_math.hpp"

using namespace kreda;

namespace {

constexpr int kInputs = 1'000'000;

std::string path_of(const std::string& name) {
    return std::string(KREDA_SOURCE_DIR) + "/tests/bounds/" + name + ".g";
}

/// What stands behind "<=" in a certificate.
double bound_of(const std::string& name) {
    std::ifstream stream(path_of(name));
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const std::size_t at = text.rfind("| <= ");
    REQUIRE(at != std::string::npos);
    return std::stod(text.substr(at + 5));
}

/// The command says yes with 0: the proposition is proved.
bool is_proved(const std::string& name) {
    return std::system(("gappa '" + path_of(name) + "' >/dev/null 2>&1").c_str()) == 0;
}

/// Random floats of a range, the ends now and then.
struct Inputs {
    std::mt19937 random{18};
    float in(float from, float to) {
        const std::uint32_t die = random() % 64;
        if (die == 0) return from;
        if (die == 1) return to;
        return from + (to - from) * (static_cast<float>(random() >> 8) * 0x1p-24f);
    }
    /// As many of each power of ten.
    float log_in(float from, float to) {
        return std::min(std::max(from * std::pow(to / from, in(0.0f, 1.0f)), from), to);
    }
};

/// The greatest error of a million inputs, each drawn by error_of(inputs): at most the bound, and not far below it (a
/// bound that is far too large says nothing).
template <class Error>
void check_sweep(const std::string& name, Error error_of) {
    Inputs inputs;
    double worst = 0.0;
    for (int i = 0; i < kInputs; ++i) worst = std::max(worst, std::abs(error_of(inputs)));
    CAPTURE(name);
    CAPTURE(worst);
    CHECK(worst <= bound_of(name));
    CHECK(worst >= 0.2 * bound_of(name));
}

double square(double x) {
    return x * x;
}

}  // namespace

TEST_CASE("bounds: Gappa proves every certificate") {
    if (std::system("gappa --version >/dev/null 2>&1") != 0) {
        MESSAGE("SKIPPED: gappa is not installed");
        return;
    }
    for (const char* name : {"schlick", "smooth_ramp", "lerp", "fog_mix", "exp2_fraction", "ggx", "reinhard"}) {
        CAPTURE(name);
        CHECK(is_proved(name));
    }
}

TEST_CASE("bounds: Schlick's Fresnel") {
    check_sweep("schlick", [](Inputs& inputs) {
        const float c = inputs.in(0.0f, 1.0f), f0 = inputs.in(0.0f, 1.0f);
        const double x = 1.0 - double{c}, exact = double{f0} + (1.0 - double{f0}) * (square(x * x) * x);
        return double{lighting::fresnel_schlick(c, f0)} - exact;
    });
}

TEST_CASE("bounds: the smooth ramp") {
    check_sweep("smooth_ramp", [](Inputs& inputs) {
        const float t = inputs.in(0.0f, 1.0f);
        const double exact = square(double{t}) * (3.0 - 2.0 * double{t});
        return double{raster::smooth_ramp(t)} - exact;
    });
}

TEST_CASE("bounds: linear interpolation") {
    check_sweep("lerp", [](Inputs& inputs) {
        const float a = inputs.in(0.0f, 1.0f), b = inputs.in(0.0f, 1.0f), t = inputs.in(0.0f, 1.0f);
        const double exact = (1.0 - double{t}) * double{a} + double{t} * double{b};
        return double{raster::lerp(a, b, t)} - exact;
    });
}

TEST_CASE("bounds: mixing fog") {
    check_sweep("fog_mix", [](Inputs& inputs) {
        const float f = inputs.in(0.0f, 1.0f), s = inputs.in(0.0f, 16.0f), c = inputs.in(0.0f, 16.0f);
        const double exact = double{f} * double{s} + (1.0 - double{f}) * double{c};
        return double{lighting::mix_fog(f, glm::vec3(s), glm::vec3(c)).x} - exact;
    });
}

TEST_CASE("bounds: the polynomial of 2^f") {
    constexpr float kCoefficients[] = {0.00133968994f, 0.00961847045f, 0.0555033945f, 0.240226477f, 0.193147197f};
    check_sweep("exp2_fraction", [&](Inputs& inputs) {
        const float f = inputs.in(-0.5f, 0.5f);
        double p = double{0.00015342074f};
        for (const float a : kCoefficients) p = p * double{f} + double{a};
        const double exact = 1.0 + (0.5 * double{f} + double{f} * p);
        return double{raster::exp2_of_fraction(f)} - exact;
    });
}

TEST_CASE("bounds: GGX in narrow and wide highlights") {
    check_sweep("ggx", [](Inputs& inputs) {
        const float c = inputs.in(0.001f, 1.0f), alpha = inputs.log_in(0.001f, 1.0f), s = inputs.log_in(1e-12f, 1.0f);
        const double q = double{s} + square(double{c} * double{alpha});
        const double exact = square(double{alpha} / q) * double{raster::kInvPi};
        return double{lighting::ggx_distribution(c, s, alpha)} / exact - 1.0;
    });
}

TEST_CASE("bounds: Reinhard's operator in the dark") {
    check_sweep("reinhard", [](Inputs& inputs) {
        const float r = inputs.log_in(1e-15f, 1.0f);
        return double{raster::reinhard(r)} / (double{r} / (1.0 + double{r})) - 1.0;
    });
}
