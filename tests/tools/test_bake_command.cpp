// `kreda bake`: files that hold what rendering reads, and refusals that leave nothing behind.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "lighting/environment/environment_image.hpp"
#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/bake/bake.hpp"
#include "tools/progress_bar.hpp"

using namespace kreda;
using kreda::tests::bytes_of;
using kreda::tests::line_count;
using kreda::tests::names_in;
using kreda::tests::Outcome;
using kreda::tests::run_kreda;
using kreda::tests::TempFolder;

namespace {

constexpr float kPi = 3.14159265f;

/// A small equirectangular image of L(direction).
template <class Radiance>
raster::Image image_of(Radiance L, int height = 8) {
    raster::Image image = raster::make_image(2 * height, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            const glm::vec2 point{(float(x) + 0.5f) / float(2 * height), (float(y) + 0.5f) / float(height)};
            image.set_rgb(x, y, L(lighting::equirect_direction(point)));
        }
    }
    return image;
}

glm::vec3 even(const glm::vec3&) {
    return {0.5f, 1.0f, 2.0f};
}

/// Something else in every direction.
glm::vec3 colorful(const glm::vec3& d) {
    return {1.0f + d.x, 1.0f + d.y * d.z, std::exp(3.0f * d.z)};
}

void check_baked(const TempFolder& folder, std::vector<std::string> args) {
    args.insert(args.begin(), "bake");
    const Outcome outcome = run_kreda(args, folder.path.string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
}

/// The greatest |difference| from a colour.
float distance_from(const raster::Image& image, const glm::vec3& color) {
    float greatest = 0.0f;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const glm::vec3 difference = glm::abs(image.rgb(x, y) - color);
            greatest = std::max({greatest, difference.x, difference.y, difference.z});
        }
    }
    return greatest;
}

/// The strip that a file should hold, texel by texel.
void check_strip(const std::string& file, const lighting::CubeMap& map, int level) {
    CAPTURE(file);
    const raster::Image strip = scene::read_image(file);
    const int size = map.levels[static_cast<std::size_t>(level)].size;
    REQUIRE(strip.width == 6 * size);
    REQUIRE(strip.height == size);
    int different = 0;
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) different += strip.rgb(face * size + x, y) != map.texel(level, face, x, y);
        }
    }
    CHECK(different == 0);
}

}  // namespace

TEST_CASE("bake: even light stays L in every mirror and is pi L on every plane") {
    const TempFolder folder;
    scene::write_exr(folder.file("even.exr"), image_of(even));
    check_baked(folder, {"even.exr", "-o", "out", "--samples", "64"});
    const glm::vec3 L = even({});
    for (const char* file : {"environment", "prefiltered_1", "prefiltered_4", "prefiltered_7"}) {
        CAPTURE(file);
        CHECK(distance_from(scene::read_image(folder.file("out/" + std::string(file) + ".exr")), L) <
              4e-6f);  // sums of floats
    }
    // The largest of the three is 2 pi; the texels' centres are not their centroids: 3e-4.
    CHECK(distance_from(scene::read_image(folder.file("out/irradiance.exr")), kPi * L) < 2e-3f);
    const nlohmann::json sh9 = nlohmann::json::parse(bytes_of(folder.file("out/sh9.json")));
    for (std::size_t k = 0; k < 9; ++k) {
        CAPTURE(k);
        for (int c = 0; c < 3; ++c) {
            const double expected = k == 0 ? double(kPi * L[c]) : 0.0;
            CHECK(std::abs(sh9.at("coefficients").at(k).at(static_cast<std::size_t>(c)).get<double>() - expected) <
                  1e-4);
        }
    }
    CHECK(sh9.at("repaired_texels").at("negative") == 0);
    CHECK(sh9.at("settings").at("samples") == 64);
    CHECK(scene::read_image(folder.file("out/contact_sheet.png")).width > 1000);
}

TEST_CASE("bake: every file holds the very texels that rendering reads") {
    const TempFolder folder;
    scene::write_exr(folder.file("colors.exr"), image_of(colorful));
    check_baked(folder, {"colors.exr", "-o", "out", "--samples", "128", "--geometry", "smith_correlated"});
    scene::EnvironmentSettings settings;
    settings.image = std::make_shared<raster::Image>(scene::read_image(folder.file("colors.exr")));
    settings.samples = 128;
    lighting::EnvironmentNeeds needs;
    needs.blurred = needs.irradiance = true;
    needs.brdf = {{lighting::Distribution::ggx, lighting::Geometry::smith_correlated}};
    const lighting::EnvironmentMaps maps = prepare_environment(settings, needs).maps;
    check_strip(folder.file("out/environment.exr"), maps.prefiltered, 0);
    for (int level = 1; level < lighting::kPrefilterLevels; ++level) {
        check_strip(folder.file("out/prefiltered_" + std::to_string(level) + ".exr"), maps.prefiltered, level);
    }
    check_strip(folder.file("out/irradiance.exr"), maps.irradiance, 0);
    const raster::Image brdf = scene::read_image(folder.file("out/brdf_map.exr"));
    REQUIRE(brdf.width == lighting::kBrdfMapSize);
    for (const int i : {0, 20, 63}) {
        for (const int j : {0, 31, 63}) {
            const float* texel = &maps.brdf[0].texels[static_cast<std::size_t>(4 * (64 * j + i))];
            CHECK(brdf.rgb(i, j) == glm::vec3(texel[0], texel[1], texel[2]));
        }
    }
    needs = {};
    needs.irradiance = true;
    needs.form = lighting::IrradianceForm::sh9;
    const lighting::Sh9 sh9 = *prepare_environment(settings, needs).maps.sh9;
    const nlohmann::json json = nlohmann::json::parse(bytes_of(folder.file("out/sh9.json")));
    for (std::size_t k = 0; k < 9; ++k) CHECK(json.at("coefficients").at(k).at(2).get<float>() == sh9.c[k].z);
    CHECK(json.at("files").size() == 10);
    CHECK(json.at("files").at(5).at("roughness").get<float>() == doctest::Approx(0.5));  // alpha = 2^(5 - 7)
}

TEST_CASE("bake: a turn by 90 degrees carries +x to -z and intensity multiplies") {
    const TempFolder folder;
    scene::write_exr(folder.file("lamp.exr"),
                     image_of([](const glm::vec3& d) { return glm::vec3(d.x > 0.9f ? 1.0f : 0.0f); }, 64));
    check_baked(folder, {"lamp.exr", "-o", "out", "--samples", "32", "--rotation", "90", "--intensity", "3"});
    const raster::Image strip = scene::read_image(folder.file("out/environment.exr"));
    const int size = strip.height;
    const float faces[] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 3.0f};  // +x -x +y -y +z -z
    for (int face = 0; face < 6; ++face) {
        CAPTURE(face);
        CHECK(strip.at(0, face * size + size / 2, size / 2) == doctest::Approx(faces[face]));
    }
}

TEST_CASE("bake: texels that are no light are repaired and counted") {
    const TempFolder folder;
    raster::Image image = image_of(even);
    image.at(0, 3, 2) = -1.0f;
    image.at(1, 5, 2) = std::nanf("");
    image.at(2, 7, 3) = INFINITY;
    image.at(2, 9, 3) = -5.0f;
    scene::write_exr(folder.file("bad.exr"), image);
    const Outcome outcome = run_kreda({"bake", "bad.exr", "-o", "out", "--samples", "32"}, folder.path.string());
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.find("warning: bad.exr holds texels that are no light: 2 negative") != std::string::npos);
    const nlohmann::json counts = nlohmann::json::parse(bytes_of(folder.file("out/sh9.json"))).at("repaired_texels");
    CHECK(counts.at("negative") == 2);
    CHECK(counts.at("not_a_number") == 1);
    CHECK(counts.at("infinite") == 1);
    CHECK(count_non_finite(scene::read_image(folder.file("out/environment.exr"))) == 0);
}

TEST_CASE("bake: files of an earlier bake are replaced and others stay") {
    const TempFolder folder;
    folder.write("out/irradiance.exr", "old");
    folder.write("out/notes.txt", "mine");
    scene::write_exr(folder.file("even.exr"), image_of(even));
    check_baked(folder, {"even.exr", "-o", "out", "--samples", "32"});
    CHECK(scene::read_image(folder.file("out/irradiance.exr")).height == 32);
    CHECK(bytes_of(folder.file("out/notes.txt")) == "mine");
    CHECK(names_in(folder.file("out")).size() == 13);  // ten maps, sh9.json, the sheet, the notes: no temporary file
}

TEST_CASE("bake: what cannot be baked is refused with the remedy and writes no file") {
    const TempFolder folder;
    folder.write("text.hdr", "no image");
    folder.write("file", "");
    scene::write_exr(folder.file("tiny.exr"), raster::make_image(2, 1, 3));
    const auto refused = [&](const std::vector<std::string>& args, const char* remedy) {
        const Outcome outcome = run_kreda(args, folder.path.string());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(line_count(outcome.err) == 1);
        CHECK(outcome.err.find(remedy) != std::string::npos);
    };
    refused({"bake", "stduio", "-o", "o"},
            "stduio: is neither a file nor a built-in sky (studio, sunset, gradient); did you mean studio?");
    refused({"bake", "nowhere/x.hdr", "-o", "o"}, "expected an equirectangular .hdr or .exr");
    refused({"bake", "text.hdr", "-o", "o"}, "text.hdr: cannot be read as an image");
    refused({"bake", "tiny.exr", "-o", "o"},
            "tiny.exr: is 2 x 1 pixels; an equirectangular image is twice as wide as high");
    refused({"bake", "studio", "-o", "file"}, "file: this folder cannot be made");
    refused({"bake", "studio"}, "--output");
    refused({"bake", "studio", "-o", "o", "--samples", "3"}, "--samples");
    refused({"bake", "studio", "-o", "o", "--rotation", "nan"}, "--rotation");
    refused({"bake", "studio", "-o", "o", "--intensity", "nan"}, "--intensity");
    refused({"bake", "studio", "-o", "o", "--geometry", "smth"}, "--geometry");
    if (geteuid() != 0) {  // root may write everywhere
        namespace fs = std::filesystem;
        fs::create_directory(folder.path / "closed");
        fs::permissions(folder.path / "closed", fs::perms::owner_read | fs::perms::owner_exec);
        refused({"bake", "studio", "-o", "closed"},
                "closed: nothing can be written into this folder; choose another one with -o");
        fs::permissions(folder.path / "closed", fs::perms::owner_all);
    }
    const std::vector<std::string> names = names_in(folder.path.string());
    CHECK(std::find(names.begin(), names.end(), "o") == names.end());
}

TEST_CASE("bake: the bar moves evenly through every step to its end") {
    tools::BakeRequest request;
    request.environment.samples = 32;
    std::vector<double> shares{0.0};
    static_cast<void>(tools::bake_all(request, [&](double share) { shares.push_back(share); }));
    CHECK(shares.back() == 1.0);
    double longest = 0.0;
    for (std::size_t i = 1; i < shares.size(); ++i) {
        CHECK(shares[i] >= shares[i - 1] - 1e-12);
        longest = std::max(longest, shares[i] - shares[i - 1]);
    }
    CHECK(longest < 0.05);
    CHECK(tools::progress_text("baking", 0.0) == "baking [..............................]   0 %");
    CHECK(tools::progress_text("baking", 0.5) == "baking [###############...............]  50 %");
    CHECK(tools::progress_text("baking", 1.5) == "baking [##############################] 100 %");
}

namespace {

const char* const kShinyBall =
    "[image]\nsize = [48, 32]\nbackground = \"environment\"\n[environment]\nfile = \"colors.exr\"\nsamples = 64\n"
    "[[object]]\nmesh = \"sphere\"\nmaterial = \"m\"\n[[material]]\nname = \"m\"\nmodel = \"cook_torrance\"\n";

/// A folder with a scene that is lit by an image.
struct LitFolder : TempFolder {
    LitFolder() {
        write("scene.toml", kShinyBall);
        scene::write_exr(file("colors.exr"), image_of(colorful));
    }
    [[nodiscard]] Outcome render(const std::vector<std::string>& more) const {
        std::vector<std::string> args{"render", "scene.toml"};
        args.insert(args.end(), more.begin(), more.end());
        return run_kreda(args, path.string());
    }
};

}  // namespace

TEST_CASE("cache: a picture from kept maps is that from maps baked anew byte for byte") {
    const LitFolder folder;
    REQUIRE(folder.render({"-o", "plain.exr", "--no-cache"}).exit_code == 0);
    CHECK_FALSE(std::filesystem::exists(folder.path / ".kreda-cache"));
    REQUIRE(folder.render({"-o", "cold.exr"}).exit_code == 0);
    CHECK(names_in(folder.file(".kreda-cache")).size() == 5);  // three maps, .gitignore, CACHEDIR.TAG
    REQUIRE(folder.render({"-o", "warm.exr", "--time"}).exit_code == 0);
    CHECK(bytes_of(folder.file("cold.exr")) == bytes_of(folder.file("plain.exr")));
    CHECK(bytes_of(folder.file("warm.exr")) == bytes_of(folder.file("plain.exr")));
    const std::vector<std::string> before = names_in(folder.path.string());
    REQUIRE(folder.render({"-o", "warm.exr", "--cache", "maps"}).exit_code == 0);
    CHECK(names_in(folder.file("maps")).size() == 5);
    CHECK(bytes_of(folder.file("warm.exr")) == bytes_of(folder.file("plain.exr")));
    CHECK(folder.render({"-o", "warm.exr", "--cache", "maps", "--no-cache"}).exit_code == 2);
}

TEST_CASE("cache: several renders at once share a cold folder") {
    const LitFolder folder;
    REQUIRE(folder.render({"-o", "plain.exr", "--no-cache"}).exit_code == 0);
    std::vector<std::thread> renders;
    std::vector<Outcome> outcomes(4);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        renders.emplace_back([&, i] {
            outcomes[i] = folder.render({"-o", std::to_string(i) + ".exr", "--threads", "1"});
        });
    }
    for (std::thread& thread : renders) thread.join();
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        CAPTURE(outcomes[i].err);
        CHECK(outcomes[i].exit_code == 0);
        CHECK(bytes_of(folder.file(std::to_string(i) + ".exr")) == bytes_of(folder.file("plain.exr")));
    }
    CHECK(names_in(folder.file(".kreda-cache")).size() == 5);  // no temporary file is left
}

TEST_CASE("cache: where it cannot be written the picture is drawn and a word is said") {
    const LitFolder folder;
    folder.write(".kreda-cache", "a file in its place");
    const Outcome outcome = folder.render({"-o", "p.png"});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.find("note: the baked maps are not kept: .kreda-cache: this folder cannot be made") !=
          std::string::npos);
    CHECK(std::filesystem::exists(folder.path / "p.png"));
    CHECK(bytes_of(folder.file(".kreda-cache")) == "a file in its place");
}

TEST_CASE("cache: explain and stages use it too and a scene without an environment leaves no folder") {
    const LitFolder folder;
    folder.write("plain.toml", "[[object]]\nmesh = \"sphere\"\n");
    REQUIRE(run_kreda({"render", "plain.toml", "--size", "32x18", "-o", "p.png"}, folder.path.string()).exit_code == 0);
    CHECK_FALSE(std::filesystem::exists(folder.path / ".kreda-cache"));
    REQUIRE(run_kreda({"explain", "scene.toml", "--pixel", "24,16"}, folder.path.string()).exit_code == 0);
    CHECK(names_in(folder.file(".kreda-cache")).size() == 5);
    REQUIRE(run_kreda({"stages", "scene.toml", "-o", "s", "--cache", "maps"}, folder.path.string()).exit_code == 0);
    CHECK(names_in(folder.file("maps")) == names_in(folder.file(".kreda-cache")));
}
