// Where compiled catalogues are kept: made once, found again, the oldest removed.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tools/grade/assignment/grade_cache.hpp"

using namespace kreda;
using namespace kreda::tests;
namespace fs = std::filesystem;

namespace {

/// A variable of the environment has another value (or none) while this lives.
struct Environment {
    std::string name, before;
    bool was_set = false;

    Environment(const char* variable, const char* value) : name(variable) {
        const char* const old = std::getenv(variable);
        was_set = old != nullptr;
        if (was_set) before = old;
        value != nullptr ? setenv(variable, value, 1) : unsetenv(variable);
    }
    ~Environment() {
        was_set ? setenv(name.c_str(), before.c_str(), 1) : unsetenv(name.c_str());
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
};

/// A folder of this many bytes that was used some hours ago.
void make_entry(const fs::path& folder, std::size_t bytes, int hours) {
    fs::create_directories(folder);
    std::ofstream(folder / "program") << std::string(bytes, 'x');
    fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::hours(hours));
}

}  // namespace

TEST_CASE("cache: what was used longest ago is removed down to the limit, and nothing of the last hour") {
    const TempFolder folder;
    make_entry(folder.path / "old", 400, 30);
    make_entry(folder.path / "older", 400, 50);
    make_entry(folder.path / "recent", 400, 2);
    make_entry(folder.path / "now", 400, 0);
    kreda::tools::trim_cache(folder.path, 1600);
    CHECK(fs::exists(folder.path / "older"));  // 4 x 400 bytes fit
    kreda::tools::trim_cache(folder.path, 1599);
    CHECK_FALSE(fs::exists(folder.path / "older"));
    CHECK(fs::exists(folder.path / "old"));
    kreda::tools::trim_cache(folder.path, 0);
    CHECK_FALSE(fs::exists(folder.path / "old"));
    CHECK_FALSE(fs::exists(folder.path / "recent"));
    CHECK(fs::exists(folder.path / "now"));
}

TEST_CASE("cache: what killed processes left half made goes first, though there is room") {
    const TempFolder folder;
    make_entry(folder.path / "variants-1.4711", 400, 2);
    make_entry(folder.path / "variants-2.4712", 400, 0);  // somebody may be at work in it
    make_entry(folder.path / "old", 400, 30);
    kreda::tools::trim_cache(folder.path, 1600);
    CHECK_FALSE(fs::exists(folder.path / "variants-1.4711"));
    CHECK(fs::exists(folder.path / "variants-2.4712"));
    CHECK(fs::exists(folder.path / "old"));
}

TEST_CASE("cache: a folder is filled once, used again, and not there when that fails") {
    const TempFolder folder;
    const Environment chosen("KREDA_GRADE_CACHE", (folder.path / "kept").c_str());
    int filled = 0;
    const auto fill = [&](const fs::path& place) {
        ++filled;
        std::ofstream(place / "program") << "made";
    };
    const fs::path made = kreda::tools::cached_folder("variants-1", fill);
    CHECK(made == folder.path / "kept" / "variants-1");
    CHECK(fs::file_size(made / "program") == 4);
    fs::last_write_time(made, fs::file_time_type::clock::now() - std::chrono::hours(9));
    CHECK(kreda::tools::cached_folder("variants-1", fill) == made);
    CHECK(filled == 1);
    CHECK(fs::last_write_time(made) > fs::file_time_type::clock::now() - std::chrono::hours(1));
    const auto fail = [](const fs::path& place) {
        std::ofstream(place / "half") << "made";
        throw scene::UserError("the compiler failed");
    };
    CHECK_THROWS_AS((void)kreda::tools::cached_folder("variants-2", fail), scene::UserError);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path / "kept")) {
        const std::string name = entry.path().filename().string();
        CHECK((name == "variants-1" || name.ends_with(".lock")));
    }
}

TEST_CASE("cache: it lies where the environment says, never in the assignment's folder") {
    const TempFolder folder;
    const Environment no_choice("KREDA_GRADE_CACHE", nullptr), home("HOME", folder.path.c_str());
    {
        const Environment shared("XDG_CACHE_HOME", (folder.path / "cache").c_str());
        CHECK(kreda::tools::grade_cache() == folder.path / "cache" / "kreda" / "grade");
    }
    const Environment not_shared("XDG_CACHE_HOME", nullptr);
    CHECK(kreda::tools::grade_cache() == folder.path / ".cache" / "kreda" / "grade");
    CHECK(fs::is_directory(kreda::tools::grade_cache()));
    CHECK(kreda::tools::grade_cache_limit() == std::uintmax_t{1024} * 1024 * 1024);
    const Environment limit("KREDA_GRADE_CACHE_MB", "3");
    CHECK(kreda::tools::grade_cache_limit() == 3 * 1024 * 1024);
    const Environment wrong("KREDA_GRADE_CACHE_MB", "3 GB");
    CHECK_THROWS_WITH((void)kreda::tools::grade_cache_limit(),
                      "KREDA_GRADE_CACHE_MB=3 GB: expected a whole number of megabytes");
}
