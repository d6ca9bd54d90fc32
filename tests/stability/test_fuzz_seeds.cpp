// What fuzzing starts from and what it found: every reader reads or refuses every one of these files, whatever kind it
// is.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "tests/fuzz/readers.hpp"
#include "tests/scene/damaged_text.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda::tests;

namespace {

struct Seed {
    std::string kind, name, bytes;
};

std::vector<Seed> fuzz_seeds() {
    std::vector<Seed> seeds;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(KREDA_SOURCE_DIR "/tests/fuzz/seeds")) {
        if (!entry.is_regular_file()) continue;
        std::ostringstream bytes;
        bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        seeds.push_back({entry.path().parent_path().filename().string(), entry.path().string(), bytes.str()});
    }
    return seeds;
}

}  // namespace

TEST_CASE("fuzz seeds: every reader reads or refuses each of them") {
    const TempFolder folder;
    const std::vector<Seed> seeds = fuzz_seeds();
    REQUIRE(seeds.size() > 20);
    for (const Seed& seed : seeds) {
        CAPTURE(seed.name);
        for (const FuzzedReader& reader : fuzzed_readers()) {
            const bool is_slow = reader.name == "image" && seed.kind != "image";  // a process for each
            if (!is_slow) CHECK_NOTHROW(reader.read(seed.bytes, folder.path.string()));
        }
    }
}

TEST_CASE("fuzz seeds: a few bytes changed in each of them are read or refused") {
    const TempFolder folder;
    DamagedText damage(19);
    for (const Seed& seed : fuzz_seeds()) {
        for (const FuzzedReader& reader : fuzzed_readers()) {
            if (reader.name != seed.kind || reader.name == "image") continue;
            for (int i = 0; i < 40; ++i) {
                const std::string damaged = damage.of(seed.bytes);
                CAPTURE(damaged);
                CHECK_NOTHROW(reader.read(damaged, folder.path.string()));
            }
        }
    }
}
