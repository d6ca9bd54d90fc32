// Keys of scene files and views that the pages name are there.
#include <algorithm>
#include <filesystem>
#include <regex>

#include <doctest/doctest.h>

#include "course.hpp"
#include "scene/files/scene_keys.hpp"
#include "scene/plan/views.hpp"
#include "scene/render/light_depth.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

std::vector<std::string> all_pages() {
    std::vector<std::string> pages = {"README.md"};
    for (const auto& entry : std::filesystem::directory_iterator(KREDA_SOURCE_DIR "/docs")) {
        if (entry.path().extension() == ".md") pages.push_back("docs/" + entry.path().filename().string());
    }
    return pages;
}

/// Calls visit(match) for every match in a page.
template <class Visit>
int for_each_match(const std::string& page, const std::regex& words, Visit visit) {
    const std::string text = repository_text(page);
    int count = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), words), end; it != end; ++it, ++count) visit(*it);
    return count;
}

}  // namespace

TEST_CASE("pages: every key of a scene file that a page names is there") {
    const std::vector<std::string> tables = scene::table_names();
    const auto check = [&](const std::string& table, const std::string& key) {
        const bool is_table = std::find(tables.begin(), tables.end(), table) != tables.end();
        if (!is_table || key == "hpp" || key == "exr") return;  // `environment.exr` is a file
        CAPTURE(table);
        CAPTURE(key);
        CHECK(scene::find_key(table, key) != nullptr);
    };
    int found = 0;
    for (const std::string& page : all_pages()) {
        CAPTURE(page);
        const std::regex written(R"(`([a-z]+)\.([a-z_0-9]+)( = [^`]*)?`)"), set(R"(--set ([a-z]+)\.([\w.]+)=)");
        found += for_each_match(page, written, [&](const std::smatch& match) {
            if (!scene::is_repeated(match[1].str())) check(match[1], match[2]);  // light.axis is no key
        });
        found += for_each_match(page, set, [&](const std::smatch& match) {
            const std::string path = match[2];  // "interpolation", "gold.roughness", "0.intensity"
            check(match[1], path.substr(path.rfind('.') + 1));
        });
    }
    CHECK(found > 40);
}

TEST_CASE("pages: every view that a page names is there") {
    int found = 0;
    for (const std::string& page : all_pages()) {
        CAPTURE(page);
        found += for_each_match(page, std::regex(R"(--view ([A-Za-z_0-9]+))"), [&](const std::smatch& match) {
            const std::string name = match[1];
            CAPTURE(name);
            CHECK((name == "NAME" || name == scene::light_depth_view().name || scene::find_view(name) != nullptr));
        });
    }
    CHECK(found > 15);
}
