// The gallery: pages without a server, links that lead somewhere.
#include <filesystem>
#include <regex>
#include <string>

#include <doctest/doctest.h>

#include "raster/image.hpp"
#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/gallery/markdown.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

namespace fs = std::filesystem;

void write_examples(const TempFolder& folder) {
    fs::create_directories(folder.path / "out/10_triangle");
    fs::create_directories(folder.path / "out/11_z_buffer");
    fs::create_directories(folder.path / "out/22_phong_terms");
    scene::write_png(folder.file("out/10_triangle/edge_functions.png"), raster::make_image(20, 10, 3));
    scene::write_png(folder.file("out/11_z_buffer/depth.png"), raster::make_image(300, 200, 3));
    scene::write_png(folder.file("out/22_phong_terms/specular.png"), raster::make_image(30, 20, 3));
    folder.write("out/22_phong_terms/output.txt", "n.l = 0.5 < 1\n");
    folder.write("docs/10_triangle.md",
                 "# 10 A triangle & its edges\n\n## Goal\n\n![edges](../out/10_triangle/edge_functions.png)\n\nWhich "
                 "pixels are\n"
                 "inside, if `a < b`?\n\n## The idea\n\nThen [depth](11_z_buffer.md).\n");
    folder.write("docs/11_z_buffer.md", "# Depth\n\n## Goal\n\nSee [the triangle](10_triangle.md).\n");
}

/// Every address in href="..." and src="..." of a page.
std::vector<std::string> addresses(const std::string& html) {
    const std::regex pattern("(?:href|src)=\"([^\"]*)\"");
    std::vector<std::string> found;
    for (auto it = std::sregex_iterator(html.begin(), html.end(), pattern); it != std::sregex_iterator(); ++it) {
        found.push_back((*it)[1].str());
    }
    return found;
}

void check_links(const fs::path& page) {
    CAPTURE(page);
    for (const std::string& address : addresses(bytes_of(page.string()))) {
        CAPTURE(address);
        CHECK(address.find(':') == std::string::npos);  // nothing from the network
        CHECK(fs::path(address).is_relative());
        if (address[0] != '#') CHECK(fs::exists(page.parent_path() / address.substr(0, address.find('#'))));
    }
}

std::string html(const std::string& markdown) {
    return tools::html_from_markdown(markdown, [](const std::string& target) { return "to/" + target; });
}

}  // namespace

TEST_CASE("gallery: families as sections and titles and goals and captions") {
    const TempFolder folder;
    write_examples(folder);
    const Outcome outcome = run_kreda({"gallery", "out", "docs"}, folder.path.string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const std::string index = bytes_of(folder.file("out/index.html"));
    CHECK(index.find("<b>1x</b>Raster</h2>") < index.find("<b>2x</b>Local illumination</h2>"));
    CHECK(index.find("Fog") == std::string::npos);
    CHECK(index.find("<span>10</span>A triangle &amp; its edges</a>") != std::string::npos);
    CHECK(index.find("<p>Which pixels are inside, if <code>a &lt; b</code>?</p>") != std::string::npos);
    CHECK(index.find("<figcaption>edge functions</figcaption>") != std::string::npos);
    CHECK(index.find("<span>22</span>phong terms</a>") != std::string::npos);  // no page: its folder's name
    CHECK(index.find("width=\"300\" height=\"200\"") != std::string::npos);
    const std::string page = bytes_of(folder.file("out/22_phong_terms/index.html"));
    CHECK(page.find("n.l = 0.5 &lt; 1") != std::string::npos);
}

TEST_CASE("gallery: every link of every page leads to a file and none to the network") {
    const TempFolder folder;
    write_examples(folder);
    REQUIRE(run_kreda({"gallery", "out", "docs"}, folder.path.string()).exit_code == 0);
    check_links(folder.path / "out/index.html");
    for (const char* name : {"10_triangle", "11_z_buffer", "22_phong_terms"})
        check_links(folder.path / "out" / name / "index.html");
}

TEST_CASE("gallery of an empty folder says so") {
    const TempFolder folder;
    fs::create_directories(folder.path / "out");
    REQUIRE(run_kreda({"gallery", "out", "docs"}, folder.path.string()).exit_code == 0);
    CHECK(bytes_of(folder.file("out/index.html")).find("no pictures yet") != std::string::npos);
}

TEST_CASE("markdown: blocks") {
    CHECK(html("# A\ntext\nmore\n\nnext") == "<h1>A</h1>\n<p>text more</p>\n<p>next</p>\n");
    CHECK(html("- a\n  b\n- c") == "<ul>\n<li>a b</li>\n<li>c</li>\n</ul>\n");
    CHECK(html("1. a\n2. b") == "<ol>\n<li>a</li>\n<li>b</li>\n</ol>\n");
    CHECK(html("```cpp\nif (a < b) *p = 1;\n\n# no heading\n```") ==
          "<pre><code>if (a &lt; b) *p = 1;\n\n# no heading\n</code></pre>\n");
    CHECK(html("so\n\n    a  <\n      b\n\nend") == "<p>so</p>\n<pre><code>a  &lt;\n  b\n</code></pre>\n<p>end</p>\n");
    CHECK(html("| a | b |\n| --- | --- |\n| `x | y` | 2 |") ==
          "<div class=\"wide\"><table>\n<tr><th>a</th><th>b</th></tr>\n<tr><td><code>x | "
          "y</code></td><td>2</td></tr>\n</table></div>\n");
}

TEST_CASE("markdown: formulas and folded answers and lists that go on") {
    CHECK(html("so\n$$a < b_1 \\tag{1}$$\nend") ==
          "<p>so</p>\n<pre><code>a &lt; b_1 \\tag{1}</code></pre>\n<p>end</p>\n");
    CHECK(html("1. ask\n   <details><summary>Answer</summary>\n\n   say\n\n   </details>\n2. b") ==
          "<ol>\n<li>ask</li>\n</ol>\n<details><summary>Answer</summary>\n<p>say</p>\n</details>\n"
          "<ol start=\"2\">\n<li>b</li>\n</ol>\n");
    CHECK(html("<details open>") == "<p>&lt;details open&gt;</p>\n");
}

TEST_CASE("markdown: spans") {
    CHECK(html("**b** *i* `c*d*`") == "<p><strong>b</strong> <em>i</em> <code>c*d*</code></p>\n");
    CHECK(html("[t](u.md) ![p](q.png)") ==
          "<p><a href=\"to/u.md\">t</a> <img src=\"to/q.png\" alt=\"p\" loading=\"lazy\"></p>\n");
    CHECK(html("a * b * c and n_dot_l and a[i] (x)") == "<p>a * b * c and n_dot_l and a[i] (x)</p>\n");
}

TEST_CASE("markdown: HTML is shown and not obeyed") {
    CHECK(html("<script>&\"") == "<p>&lt;script&gt;&amp;&quot;</p>\n");
    CHECK(html("[x](\"onclick=\"a)") == "<p><a href=\"to/&quot;onclick=&quot;a\">x</a></p>\n");
}

TEST_CASE("markdown: comments are left out") {
    CHECK(html("0.75 <!-- number: F = 0.75 -->, no more") == "<p>0.75, no more</p>\n");
    CHECK(html("0.75 <!-- number: F = 0.75 --> of it") == "<p>0.75 of it</p>\n");
    CHECK(html("a\n\n<!-- alone -->\n\nb") == "<p>a</p>\n<p>b</p>\n");
    CHECK(html("a <!-- open") == "<p>a &lt;!-- open</p>\n");
}

TEST_CASE("markdown: open marks at the end are text") {
    for (const char* text : {"`", "**", "*", "[", "![", "[a](", "[a]", "![a](b"}) {
        CAPTURE(text);
        CHECK(html(text) == "<p>" + std::string(text) + "</p>\n");
    }
    CHECK(html("#") == "<h1></h1>\n");
    CHECK(html("```") == "<pre><code></code></pre>\n");
    CHECK(html("|") == "<div class=\"wide\"><table>\n</table></div>\n");
}
