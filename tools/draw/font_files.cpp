#include "tools/draw/font_files.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace kreda::tools {

namespace {

constexpr const char* kVariable = "KREDA_FONTS";

std::vector<std::string> font_folders() {
    if (const char* wish = std::getenv(kVariable)) return {wish};
    std::vector<std::string> folders = {
        "/usr/share/fonts/truetype/dejavu",   // Debian, Ubuntu
        "/usr/share/fonts/TTF",               // Arch
        "/usr/share/fonts/dejavu",            // Alpine
        "/usr/share/fonts/dejavu-sans-fonts"  // Fedora
    };
    for (const char* folder : {"/usr/local/share/fonts", "/opt/homebrew/share/fonts", "/Library/Fonts"}) {
        folders.emplace_back(folder);
    }
    if (const char* home = std::getenv("HOME")) {
        folders.push_back(std::string(home) + "/.local/share/fonts");
        folders.push_back(std::string(home) + "/.fonts");
    }
    return folders;
}

std::string find_font(const std::vector<std::string>& folders, const char* name) {
    for (const std::string& folder : folders) {
        std::error_code ignored;
        std::filesystem::path file = std::filesystem::path(folder) / name;
        if (std::filesystem::is_regular_file(file, ignored)) return file.string();
    }
    return "";
}

}  // namespace

FontFiles find_font_files() {
    const std::vector<std::string> folders = font_folders();
    return {find_font(folders, "DejaVuSans.ttf"), find_font(folders, "DejaVuSerif-Italic.ttf")};
}

std::string missing_font_message() {
    const char* wish = std::getenv(kVariable);
    const std::string where = wish ? std::string(" in ") + kVariable + "=" + wish : std::string();
    return "note: DejaVuSans.ttf is not" + (wish ? where : " installed") +
           ": pictures are drawn without captions (apt-get install fonts-dejavu-core, or set " + kVariable +
           " to the folder that has it)";
}

}  // namespace kreda::tools
