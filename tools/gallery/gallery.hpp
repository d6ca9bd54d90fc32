// The gallery: what the examples drew, as pages for a browser.
#pragma once

#include <string>
#include <vector>

namespace kreda::tools {

struct GalleryPicture {
    std::string file;     ///< name within the example's folder
    std::string caption;  ///< the name without extension, underscores as spaces
    int width = 0;        ///< in pixels; 0: unknown
    int height = 0;
};

struct GalleryExample {
    std::string name;    ///< "22_phong_terms": its folder under OUT, its page docs/22_phong_terms.md
    std::string number;  ///< "22"
    std::string title;   ///< the page's first heading
    std::string goal;    ///< the first paragraph after "## Goal", Markdown
    std::string page;    ///< the page, Markdown; empty: there is none
    std::string output;  ///< what the program printed
    std::vector<GalleryPicture> pictures;
};

/// The examples with pictures in OUT/NN_name/, sorted by name. Throws UserError when OUT is no folder.
[[nodiscard]] std::vector<GalleryExample> find_examples(const std::string& out, const std::string& docs);

/// OUT/index.html and OUT/NN_name/index.html. Throws UserError when a file cannot be written.
void write_gallery(const std::vector<GalleryExample>& examples, const std::string& out, const std::string& docs);

}  // namespace kreda::tools
