// Maps that are kept on disk: the same as those baked anew, to the last bit, whatever happened to the files.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "lighting/environment/environment_image.hpp"
#include "scene/files/environment_cache.hpp"
#include "scene/files/map_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/files/trim_maps.hpp"
#include "scene/plan/environment_plan.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using namespace kreda::scene;
using kreda::tests::bytes_of;
using kreda::tests::TempFolder;

namespace {

/// A shining ball before an environment with something else in every texel.
Scene ball(const std::string& environment = "") {
    Scene scene = read_scene_text(
        "[image]\nsize = [32, 32]\nbackground = \"environment\"\n[camera]\nposition = [0, 0, 4]\n[environment]\nsky = "
        "\"studio\"\n"
        "samples = 32\n" +
            environment +
            "[[object]]\nmesh = \"sphere\"\ndetail = 16\nmaterial = \"m\"\n[[material]]\nname = \"m\"\nmodel = "
            "\"cook_torrance\"\n"
            "roughness = 0.4\n",
        "test", "");
    raster::Image image = raster::make_image(8, 4, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<float>(i % 7);
    scene.environment.image = std::make_shared<raster::Image>(image);
    return scene;
}

struct Cached {
    PreparedEnvironment environment;
    CacheReport report;
};

Cached cached(const Scene& scene, const std::string& folder) {
    Cached result;
    result.environment = cached_environment(scene.environment, environment_needs(scene), folder, {}, result.report);
    return result;
}

bool same_maps(const PreparedEnvironment& a, const PreparedEnvironment& b) {
    if (a.maps.brdf.size() != b.maps.brdf.size() || a.maps.sh9.has_value() != b.maps.sh9.has_value()) return false;
    for (std::size_t k = 0; k < a.maps.brdf.size(); ++k) {
        if (a.maps.brdf[k].texels != b.maps.brdf[k].texels) return false;
    }
    return a.maps.prefiltered.texels == b.maps.prefiltered.texels &&
           a.maps.irradiance.texels == b.maps.irradiance.texels && (!a.maps.sh9 || a.maps.sh9->c == b.maps.sh9->c);
}

PreparedEnvironment fresh(const Scene& scene) {
    return prepare_environment(scene.environment, environment_needs(scene));
}

std::vector<std::string> map_files(const std::string& folder) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".map") files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The old file is removed first: a file system may wait for the disk when one is cut to nothing and written again.
void overwrite(const std::string& file, const std::string& bytes) {
    std::filesystem::remove(file);
    std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("environment cache: maps from it and the film drawn with them are those baked anew to the last bit") {
    for (const char* form : {"map", "sh9"}) {
        CAPTURE(form);
        const TempFolder folder;
        Scene scene = ball("irradiance = \"" + std::string(form) + "\"\n");
        const PreparedEnvironment anew = fresh(scene);
        const auto film = render(scene).values;
        const Cached cold = cached(scene, folder.file("maps"));
        CHECK(cold.report.baked == 3);  // levels, irradiance, BRDF map
        CHECK(cold.report.why_not_kept.empty());
        CHECK(same_maps(cold.environment, anew));
        const Cached warm = cached(scene, folder.file("maps"));
        CHECK(warm.report.found == 3);
        CHECK(warm.report.baked == 0);
        CHECK(same_maps(warm.environment, anew));
        scene.environment.prepared = std::make_shared<PreparedEnvironment>(warm.environment);
        CHECK(render(scene).values == film);
    }
}

TEST_CASE("environment cache: a scene's prepared maps are drawn with and maps for another scene are not") {
    Scene scene = ball();
    const auto film = render(scene).values;
    PreparedEnvironment dark = fresh(scene);
    std::fill(dark.maps.prefiltered.texels.begin(), dark.maps.prefiltered.texels.end(), 0.0f);
    scene.environment.prepared = std::make_shared<PreparedEnvironment>(dark);
    CHECK(render(scene).values != film);
    scene.environment.samples = 64;
    Scene same = ball("");
    same.environment.samples = 64;
    same.environment.image = scene.environment.image;
    CHECK(render(scene).values == render(same).values);
}

TEST_CASE("environment cache: a file that is damaged or cut off is baked again and mended") {
    const TempFolder folder;
    const Scene scene = ball();
    const PreparedEnvironment anew = fresh(scene);
    static_cast<void>(cached(scene, folder.path.string()));
    const std::vector<std::string> files = map_files(folder.path.string());
    REQUIRE(files.size() == 3);
    std::vector<std::string> good;
    for (const std::string& file : files) good.push_back(bytes_of(file));
    const auto mended_after = [&](auto damage) {
        for (std::size_t i = 0; i < files.size(); ++i) overwrite(files[i], damage(good[i]));
        const Cached again = cached(scene, folder.path.string());
        CHECK(again.report.baked == 3);
        CHECK(same_maps(again.environment, anew));
        for (std::size_t i = 0; i < files.size(); ++i) CHECK(bytes_of(files[i]) == good[i]);
    };
    mended_after([](std::string bytes) {
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
        return bytes;
    });
    mended_after([](const std::string& bytes) { return bytes.substr(0, bytes.size() / 2); });
    CHECK(map_files(folder.path.string()) == files);
}

TEST_CASE("environment cache: another image or sky or number of samples is another key and turning is not") {
    const TempFolder folder;
    const auto baked = [&](const Scene& scene) { return cached(scene, folder.path.string()).report.baked; };
    CHECK(baked(ball()) == 3);
    CHECK(baked(ball("rotation = 40\nintensity = 3\n")) == 0);
    Scene changed = ball();
    changed.environment.samples = 64;
    CHECK(baked(changed) == 1);  // the levels alone
    changed = ball("irradiance = \"sh9\"\n");
    CHECK(baked(changed) == 1);
    changed = ball();
    raster::Image image = *changed.environment.image;
    image.at(2, 5, 1) += 1e-6f;
    changed.environment.image = std::make_shared<raster::Image>(image);
    CHECK(baked(changed) == 2);                                          // not the BRDF map: it knows no environment
    changed.environment.image = std::make_shared<raster::Image>(image);  // another object, the same texels
    CHECK(baked(changed) == 0);
    changed.environment.image = nullptr;
    CHECK(baked(changed) == 2);
    changed.environment.sky = lighting::Sky::sunset;
    CHECK(baked(changed) == 2);
    changed.materials[0].cook_torrance.geometry = lighting::Geometry::smith;
    CHECK(baked(changed) == 1);
}

TEST_CASE("environment cache: a folder that cannot be made costs the cache and not the picture") {
    const TempFolder folder;
    folder.write("file", "");
    const Scene scene = ball();
    const Cached result = cached(scene, folder.file("file/maps"));
    CHECK(result.report.baked == 3);
    CHECK(result.report.why_not_kept.find("cannot be made") != std::string::npos);
    CHECK(same_maps(result.environment, fresh(scene)));
}

TEST_CASE("environment cache: it lies beside the scene file and tells git to ignore it") {
    CHECK(cache_folder_of("lesson/scene.toml") == "lesson/.kreda-cache");
    CHECK(cache_folder_of("scene.toml") == ".kreda-cache");
    CHECK(cache_folder_of("").empty());
    const TempFolder folder;
    static_cast<void>(cached(ball(), folder.file("maps")));
    CHECK(bytes_of(folder.file("maps/.gitignore")) == "*\n");
    CHECK(bytes_of(folder.file("maps/CACHEDIR.TAG")).starts_with("Signature: 8a477f597d28d172789f06886806bc55"));
}

TEST_CASE("environment cache: a folder with work of its own is not hidden from git") {
    const TempFolder folder;
    folder.write("homework.txt", "done");
    CHECK(cached(ball(), folder.path.string()).report.why_not_kept.empty());
    CHECK_FALSE(std::filesystem::exists(folder.path / ".gitignore"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "CACHEDIR.TAG"));
}

TEST_CASE("environment cache: the maps that were used longest ago are removed and nothing else") {
    namespace fs = std::filesystem;
    const TempFolder folder;
    const auto write_old = [&](const std::string& name, int hours) {
        folder.write(name, std::string(1000, 'x'));
        fs::last_write_time(folder.file(name), fs::file_time_type::clock::now() - std::chrono::hours(hours));
    };
    write_old("brdf-1.map", 50);
    write_old("brdf-2.map", 40);
    write_old("sh9-3.map", 30);
    write_old("sh9-4.map", 0);
    write_old(".sh9-5.map.123.tmp", 20);
    write_old("notes.txt", 90);
    const auto left = [&] {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder.path)) names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    };
    trim_maps(folder.path.string(), 2000);
    CHECK(left() == std::vector<std::string>{"notes.txt", "sh9-3.map", "sh9-4.map"});
    trim_maps(folder.path.string(), 0);  // the last hour's stays
    CHECK(left() == std::vector<std::string>{"notes.txt", "sh9-4.map"});
    mark_as_used(folder.file("notes.txt"));
    CHECK(fs::last_write_time(folder.file("notes.txt")) > fs::file_time_type::clock::now() - std::chrono::minutes(1));
}

TEST_CASE("remove oldest: what cannot be removed stays and counts, and more of the others goes") {
    namespace fs = std::filesystem;
    const TempFolder folder;
    const fs::file_time_type now = fs::file_time_type::clock::now();
    const fs::path stays = folder.path / std::string(300, 'x');  // no name is as long as that: removing it fails
    std::vector<KeptEntry> entries = {{stays, now - std::chrono::hours(9), 1000, false}};
    for (int i = 0; i < 3; ++i) {
        const std::string name = std::to_string(i) + ".map";
        folder.write(name, std::string(1000, 'x'));
        entries.push_back({folder.file(name), now - std::chrono::hours(8 - i), 1000, false});
    }
    remove_oldest(entries, 2000);
    CHECK_FALSE(fs::exists(folder.file("0.map")));
    CHECK_FALSE(fs::exists(folder.file("1.map")));
    CHECK(fs::exists(folder.file("2.map")));
}

TEST_CASE("map file: floats come back for their key alone") {
    const TempFolder folder;
    const std::vector<float> floats{1.0f, -0.0f, 3e-42f, 7.0f};
    write_map_file(folder.file("a.map"), "key", floats);
    std::vector<float> back(4);
    CHECK(read_map_file(folder.file("a.map"), "key", back));
    CHECK(back == floats);
    CHECK_FALSE(read_map_file(folder.file("a.map"), "kez", back));
    CHECK_FALSE(read_map_file(folder.file("b.map"), "key", back));
    CHECK_FALSE(read_map_file(folder.path.string(), "key", back));
    std::vector<float> more(5);
    CHECK_FALSE(read_map_file(folder.file("a.map"), "key", more));
}

TEST_CASE("map file: a flipped byte anywhere or a missing one is noticed") {
    const TempFolder folder;
    std::vector<float> floats{1.0f, 2.0f, 3.0f};
    const std::string file = folder.file("a.map");
    write_map_file(file, "key", floats);
    const std::string good = bytes_of(file);
    for (std::size_t i = 0; i < good.size(); ++i) {
        CAPTURE(i);
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 1);
        overwrite(file, bad);
        CHECK_FALSE(read_map_file(file, "key", floats));
        overwrite(file, good.substr(0, i));
        CHECK_FALSE(read_map_file(file, "key", floats));
    }
    overwrite(file, good);
    CHECK(read_map_file(file, "key", floats));
}
