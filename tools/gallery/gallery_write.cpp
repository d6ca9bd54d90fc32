#include <array>
#include <filesystem>

#include "tools/gallery/gallery.hpp"
#include "tools/gallery/gallery_style.hpp"
#include "tools/gallery/markdown.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

/// Each family of numbers is a lecture of the course.
const char* family_title(char digit) {
    static constexpr std::array<const char*, 10> kTitles = {
        "First steps", "Raster", "Local illumination", "Fog", "Reflection, physically", "Light from images", "Shadows",
        "Film",        "More",   "Speed and accuracy"};
    return kTitles.at(static_cast<std::size_t>(digit - '0'));
}

/// Where an example's links lead, seen from `page_folder`: its own pictures, other examples' pages, files of the
/// project.
LinkMap link_map(const GalleryExample& example, const fs::path& out, const fs::path& docs,
                 const fs::path& page_folder) {
    return [name = example.name, out, docs, page_folder](const std::string& target) -> std::string {
        if (target.empty() || target[0] == '#' || target.find(':') != std::string::npos) return target;
        const std::size_t hash = target.find('#');
        const fs::path path = target.substr(0, hash);
        const std::string fragment = hash == std::string::npos ? "" : target.substr(hash);
        fs::path found = docs / path;
        if (fs::exists(out / name / path.filename())) found = out / name / path.filename();
        if (path.extension() == ".md" && fs::is_directory(out / path.stem())) found = out / path.stem() / "index.html";
        return fs::absolute(found)
                   .lexically_normal()
                   .lexically_relative(fs::absolute(page_folder).lexically_normal())
                   .generic_string() +
               fragment;
    };
}

std::string page_start(const std::string& title) {
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           escape_html(title) + "</title>\n<style>" + kGalleryStyle + "</style>\n</head>\n<body>\n";
}

std::string page_end() {
    return "<footer>Drawn on the CPU by Kreda. Every picture is the same to the last bit on every machine.</footer>\n"
           "</body>\n</html>\n";
}

std::string figure_html(const GalleryPicture& picture, const std::string& folder) {
    constexpr int kSmall = 200;  // pictures of a few pixels are looked at pixel by pixel
    const std::string address = escape_html(folder + picture.file);
    std::string image = "<img src=\"" + address + "\" alt=\"" + escape_html(picture.caption) + "\" loading=\"lazy\"";
    if (picture.width > 0) {
        image += " width=\"" + std::to_string(picture.width) + "\" height=\"" + std::to_string(picture.height) + "\"";
    }
    if (picture.width > 0 && picture.width < kSmall) image += " class=\"small\"";
    return "<figure><a href=\"" + address + "\">" + image + "></a><figcaption>" + escape_html(picture.caption) +
           "</figcaption></figure>\n";
}

std::string pictures_html(const GalleryExample& example, const std::string& folder) {
    if (example.pictures.empty()) return "<p class=\"none\">No picture.</p>\n";
    std::string html = "<div class=\"pictures\">\n";
    for (const GalleryPicture& picture : example.pictures) html += figure_html(picture, folder);
    return html + "</div>\n";
}

std::string example_html(const GalleryExample& example, const LinkMap& link) {
    const std::string folder = example.name + "/";
    return "<article id=\"" + escape_html(example.name) + "\">\n<h3><a href=\"" + escape_html(folder) +
           "index.html\"><span>" + example.number + "</span>" + escape_html(example.title) + "</a></h3>\n" +
           html_from_markdown(example.goal, link) + pictures_html(example, folder) + "</article>\n";
}

std::string family_links(const std::vector<GalleryExample>& examples) {
    std::string html = "<nav><div>\n";
    char last = 0;
    for (const GalleryExample& example : examples) {
        const char family = example.number[0];
        if (family == last) continue;
        last = family;
        html +=
            std::string("<a href=\"#family-") + family + "\"><b>" + family + "x</b>" + family_title(family) + "</a>\n";
    }
    return html + "</div></nav>\n";
}

std::string index_html(const std::vector<GalleryExample>& examples, const fs::path& out, const fs::path& docs) {
    std::string html = page_start("Kreda: the gallery") +
                       "<header><h1>Kreda</h1>\n<p>Computer graphics lighting, one step at a time: what the course's "
                       "examples draw. A picture opens in full size; a title opens the example's page.</p></header>\n" +
                       family_links(examples) + "<main>\n";
    if (examples.empty()) html += "<p class=\"none\">There are no pictures yet.</p>\n";
    char last = 0;
    for (const GalleryExample& example : examples) {
        const char family = example.number[0];
        if (family != last) {
            html += last == 0 ? "" : "</section>\n";
            html += std::string("<section id=\"family-") + family + "\">\n<h2><b>" + family + "x</b>" +
                    family_title(family) + "</h2>\n";
        }
        last = family;
        html += example_html(example, link_map(example, out, docs, out));
    }
    return html + (examples.empty() ? "" : "</section>\n") + "</main>\n" + page_end();
}

std::string neighbour_html(const GalleryExample& example) {
    return "<a href=\"../" + escape_html(example.name) + "/index.html\"><b>" + example.number + "</b>" +
           escape_html(example.title) + "</a>\n";
}

std::string page_html(const std::vector<GalleryExample>& examples, std::size_t i, const fs::path& out,
                      const fs::path& docs) {
    const GalleryExample& example = examples[i];
    std::string html = page_start(example.number + " " + example.title) + "<nav><div>\n<a href=\"../index.html#" +
                       escape_html(example.name) + "\"><b>&larr;</b>Gallery</a>\n";
    if (i > 0) html += neighbour_html(examples[i - 1]);
    if (i + 1 < examples.size()) html += neighbour_html(examples[i + 1]);
    html += "</div></nav>\n<main>\n<div class=\"text\">\n";
    html += example.page.empty() ? "<h1>" + escape_html(example.title) + "</h1>\n"
                                 : html_from_markdown(example.page, link_map(example, out, docs, out / example.name));
    html += "<h2>Pictures</h2>\n</div>\n" + pictures_html(example, "");
    if (!example.output.empty()) {
        html += "<div class=\"text\"><h2>What it prints</h2>\n<pre><code>" + escape_html(example.output) +
                "</code></pre></div>\n";
    }
    return html + "</main>\n" + page_end();
}

}  // namespace

void write_gallery(const std::vector<GalleryExample>& examples, const std::string& out, const std::string& docs) {
    for (std::size_t i = 0; i < examples.size(); ++i) {
        write_file((fs::path(out) / examples[i].name / "index.html").string(), page_html(examples, i, out, docs));
    }
    write_file((fs::path(out) / "index.html").string(), index_html(examples, out, docs));
}

}  // namespace kreda::tools
