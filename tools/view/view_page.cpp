#include "tools/view/view_page.hpp"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "scene/error.hpp"
#include "tools/base64.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPlaceOfScene = "/*SCENE*/";

std::string in_base64(const std::string& bytes) {
    return base64({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

/// Nothing in a name may end the script that holds it.
std::string without_tags(std::string json) {
    for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
    return json;
}

}  // namespace

std::vector<std::string> view_page_places() {
    std::error_code unknown;
    const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    if (unknown) return {KREDA_VIEW_PAGE_OF_BUILD};
    return {folder.parent_path() / "share" / "kreda" / "view.html", KREDA_VIEW_PAGE_OF_BUILD};
}

std::string read_view_page(const std::vector<std::string>& places) {
    for (const std::string& place : places) {
        std::string page = bytes_of_file(place);
        if (page.find(kPlaceOfScene) != std::string::npos) return page;
    }
    throw scene::UserError(
        "kreda view: the page was not built yet; ./course view builds it (with the packages emscripten and "
        "libstb-dev)");
}

std::string page_with_scene(std::string page, const CarriedScene& scene, const PageStart& start) {
    nlohmann::ordered_json json;
    json["path"] = scene.path;
    json["folder"] = scene.folder;
    json["overrides"] = start.overrides;
    json["controls"] = start.controls;
    json["files"] = nlohmann::ordered_json::object();
    for (const CarriedFile& file : scene.files) json["files"][file.name] = in_base64(bytes_of_file(file.path));
    const std::string text = without_tags(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    page.replace(page.find(kPlaceOfScene), kPlaceOfScene.size(), text);
    return page;
}

}  // namespace kreda::tools
