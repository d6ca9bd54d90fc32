// The pages, cards and golden images of the course hold together.
#include <filesystem>
#include <regex>
#include <sstream>

#include <doctest/doctest.h>

#include "course.hpp"
#include "golden.hpp"

using namespace kreda::tests;

namespace {

const std::vector<std::string> kHeadings = {"Goal",     "The idea",  "In the code", "Step through it",
                                            "Break it", "Exercises", "Sources"};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

bool is_identifier_char(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Does the word occur in the text, not as a part of a longer word?
bool has_word(const std::string& text, const std::string& word) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const bool starts = at == 0 || !is_identifier_char(text[at - 1]);
        const std::size_t end = at + word.size();
        if (starts && (end == text.size() || !is_identifier_char(text[end]))) return true;
    }
    return false;
}

/// What stands between backticks in a cell of a table.
std::vector<std::string> quoted(const std::string& cell) {
    std::vector<std::string> words;
    const std::regex between("`([^`]+)`");
    for (std::sregex_iterator it(cell.begin(), cell.end(), between), end; it != end; ++it) words.push_back((*it)[1]);
    return words;
}

std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    std::istringstream stream(row.substr(1));
    for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
    return cells;
}

}  // namespace

TEST_CASE("course: every page has the same headings in the same order") {
    for (const std::string& name : example_names()) {
        CAPTURE(name);
        std::vector<std::string> headings;
        for (const std::string& line : lines_of(repository_text("docs/" + name + ".md"))) {
            if (line.starts_with("## ")) headings.push_back(line.substr(3));
        }
        CHECK(headings == kHeadings);
    }
}

TEST_CASE("course: every identifier of an In the code table is in the file named beside it") {
    for (const std::string& name : example_names()) {
        bool in_table = false;
        int rows = 0;
        for (const std::string& line : lines_of(repository_text("docs/" + name + ".md"))) {
            if (line.starts_with("## ")) in_table = line == "## In the code";
            if (!in_table || !line.starts_with("|") || line.find('`') == std::string::npos) continue;
            ++rows;
            const std::vector<std::string> cells = cells_of(line);
            REQUIRE_MESSAGE(cells.size() >= 3, name, ": ", line);
            for (const std::string& file : quoted(cells[2])) {
                const std::string source = repository_text(file);
                for (std::string identifier : quoted(cells[1])) {
                    CAPTURE(name);
                    CAPTURE(file);
                    CAPTURE(identifier);
                    CHECK(has_word(source, identifier.substr(0, identifier.find('('))));
                }
            }
        }
        CAPTURE(name);
        CHECK(rows > 0);
    }
}

TEST_CASE("course: every marked number stands in words on its own line and a test asks for it") {
    std::string tests;
    for (const auto& file : std::filesystem::directory_iterator(KREDA_SOURCE_DIR "/tests/examples")) {
        tests += repository_text("tests/examples/" + file.path().filename().string());
    }
    const std::regex mark("<!-- number: ([A-Za-z0-9_]+) = ([-0-9.e]+) -->");
    for (const std::string& name : example_names()) {
        for (const std::string& line : lines_of(repository_text("docs/" + name + ".md"))) {
            const std::string words = std::regex_replace(line, mark, "");
            for (std::sregex_iterator it(line.begin(), line.end(), mark), end; it != end; ++it) {
                CAPTURE(name);
                CAPTURE(line);
                CHECK(has_word(words, (*it)[2]));
                CHECK(tests.find('"' + (*it)[1].str() + '"') != std::string::npos);
            }
        }
    }
}

TEST_CASE("course: numbers of a page are read with their digits") {
    const std::vector<QuotedNumber> numbers = numbers_in("F82 12.10 %, -3 (1.8e-7) <!-- number: a = 7 -->, \u22120.5");
    REQUIRE(numbers.size() == 4);
    CHECK(numbers[0].value == doctest::Approx(12.1));
    CHECK(numbers[0].step == doctest::Approx(0.01));
    CHECK(numbers[1].value == -3.0);
    CHECK(numbers[2].value == doctest::Approx(1.8e-7));
    CHECK(numbers[2].step == doctest::Approx(0.1e-7));
    CHECK(numbers[3].value == -0.5);
    CHECK(rounds_to(12.104, numbers[0]));
    CHECK_FALSE(rounds_to(12.106, numbers[0]));
}

TEST_CASE("course: every example has its header card and fits a screen or two") {
    for (const std::string& name : example_names()) {
        CAPTURE(name);
        const std::vector<std::string> lines = lines_of(repository_text("examples/" + name + "/main.cpp"));
        REQUIRE(lines.size() > 3);
        CHECK(lines[0].starts_with("// " + name + ": "));
        CHECK(lines[1].starts_with("// Page docs/" + name + ".md | After "));
        CHECK(lines[1].find("| New: ") != std::string::npos);
        CHECK(lines[2].starts_with("// Break at: "));
        CHECK(lines[2].find("| Look at: ") != std::string::npos);
        CHECK(lines[2].find("| Try: ") != std::string::npos);
        CHECK(lines.size() <= 140);
    }
}

TEST_CASE("course: every page steps through the function that its header card names") {
    for (const std::string& name : example_names()) {
        CAPTURE(name);
        const std::string card = lines_of(repository_text("examples/" + name + "/main.cpp")).at(2);
        const std::string function = card.substr(13, card.find(' ', 13) - 13);  // behind "// Break at: "
        const std::string page = repository_text("docs/" + name + ".md");
        const std::size_t session = page.find("\n```gdb\n");
        REQUIRE(session != std::string::npos);
        CHECK(page.find("break " + function, session) != std::string::npos);  // CTest "debugger: NN_name" replays it
    }
}

TEST_CASE("course: every picture on a page exists and is small") {
    const std::regex picture(R"(\]\((images/\d\d_[^)]+)\))");
    for (const std::string& name : example_names()) {
        const std::string page = repository_text("docs/" + name + ".md");
        int pictures = 0;
        for (std::sregex_iterator it(page.begin(), page.end(), picture), end; it != end; ++it, ++pictures) {
            const std::string file = std::string(KREDA_SOURCE_DIR) + "/docs/" + (*it)[1].str();
            CAPTURE(file);
            REQUIRE(std::filesystem::exists(file));
            CHECK(std::filesystem::file_size(file) < 300 * 1024);
        }
        CAPTURE(name);
        CHECK(pictures > 0);
    }
}

TEST_CASE("golden: one byte changed in one channel is found where it is") {
    kreda::raster::Image image = kreda::raster::make_image(5, 4, 3);
    kreda::raster::Image other = image;
    CHECK(compare_bytes(image, other).passed);
    other.at(2, 3, 1) = 1.0f / 255.0f;
    const kreda::tools::Comparison difference = compare_bytes(image, other);
    CHECK_FALSE(difference.passed);
    CHECK(difference.differing == 1);
    CHECK(difference.worst.steps == 1.0);
    CHECK(difference.worst.x == 3);
    CHECK(difference.worst.y == 1);
    CHECK(amplified_difference(image, other).at(2, 3, 1) == doctest::Approx(16.0 / 255.0));
}

TEST_CASE("golden: another size or number of channels is never equal") {
    CHECK_FALSE(compare_bytes(kreda::raster::make_image(5, 4, 3), kreda::raster::make_image(4, 5, 3)).passed);
    CHECK_FALSE(compare_bytes(kreda::raster::make_image(5, 4, 3), kreda::raster::make_image(5, 4, 1)).passed);
}
