// Mistakes that the catalogue does not hold as they are: other constants, other places, another style, pairs of them,
// and mistakes of another kind, of which nothing may be said.
#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "tests/grading/lab.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tools/grade/assignment/table_reader.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

struct Tally {
    int right = 0, all = 0;
    [[nodiscard]] double percent() const {
        return 100.0 * right / all;
    }
};

std::string expected_name(const tools::Diagnosis& diagnosis, const Lab& l) {
    if (diagnosis.mistakes.empty()) return "unknown";
    std::vector<std::string> found;
    for (const std::size_t m : diagnosis.mistakes) found.push_back(l.catalogue.mistakes[m].name);
    return found.size() == 1 ? found[0] : found[0] + " + " + found[1];
}

/// "a + b" and "b + a" are the same.
bool same_names(const std::string& a, const std::string& b) {
    const std::size_t plus = b.find(" + ");
    return a == b || (plus != std::string::npos && a == b.substr(plus + 3) + " + " + b.substr(0, plus));
}

const std::string kTests = std::string(KREDA_SOURCE_DIR) + "/tests/grading/";

/// Mistakes of one kind each, and how many of them are named right.
struct Tallies {
    Tally single, pair, other;
    Tally& of(const std::string& expected) {
        return expected == "unknown" ? other : (expected.find(" + ") != std::string::npos ? pair : single);
    }
};

/// The solution scores all points; each of the mistakes made in it is caught, and counted where it is named right.
void diagnose_all(const Lab& l, const std::string& solution, const std::string& file, Tallies& tallies) {
    const std::vector<tools::Mistake> unseen = tools::read_mistakes(file, solution);
    const std::vector<tools::Variant> variants = tools::make_variants(solution, unseen, false);
    REQUIRE(variants.size() == unseen.size() + 1);
    const auto answers = tools::answers_of_variants(l.rubric, l.cases, variants);
    const std::vector<tools::StageTable> solved = answers.all_of(0);
    CHECK(points_of(marking(l, solved)) == points_of(marking(l, l.cases.expected)));
    for (std::size_t i = 0; i < unseen.size(); ++i) {
        const std::vector<tools::StageTable> tables = answers.all_of(i + 1);
        const tools::Diagnosis d = tools::diagnose(marking(l, tables), l.catalogue);
        const std::string& expected = unseen[i].name;
        CHECK_MESSAGE(d.kind != tools::Diagnosis::Kind::right, file << ": " << unseen[i].says << " is not caught");
        Tally& tally = tallies.of(expected);
        ++tally.all;
        const std::string found = expected_name(d, l);
        if (same_names(found, expected)) {
            ++tally.right;
        } else {
            MESSAGE(file << ": " << expected << " (" << unseen[i].says << ") looks like " << found << ", misfit "
                         << d.misfit << ", next " << d.next_misfit);
        }
    }
}

/// Good enough, and what docs/grading.md says.
void check_tallies(const Tallies& t) {
    MESSAGE("single " << t.single.right << " of " << t.single.all << ", pairs " << t.pair.right << " of " << t.pair.all
                      << ", others " << t.other.right << " of " << t.other.all);
    const std::string page = tools::read_text(std::string(KREDA_SOURCE_DIR) + "/docs/grading.md");
    for (const Tally& tally : {t.single, t.pair, t.other}) {
        const std::string cells = " | " + std::to_string(tally.all) + " | " + std::to_string(tally.right) + " |";
        CHECK_MESSAGE(page.find(cells) != std::string::npos, "docs/grading.md misses" << cells);
    }
    CHECK(t.single.percent() >= 95.0);
    CHECK(t.pair.percent() >= 80.0);
    CHECK(t.other.percent() >= 95.0);
}

/// A set in tests/grading: a file of mistakes for each assignment, made in the solutions of a folder there, or where
/// none is named in the catalogue's.
struct Set {
    const char* name;
    const char* solutions;
};
constexpr Set kSets[] = {{"unseen", ""},     {"fresh", "fresh"}, {"third", "third"},    {"fourth", "fourth"},
                         {"fifth", "fifth"}, {"sixth", "fresh"}, {"seventh", "seventh"}};

void diagnose_set(const Set& set, const std::string& folder, Tallies& tallies) {
    const Lab& l = lab(folder);
    const std::string number = "/" + folder.substr(0, 2), solutions = set.solutions;
    const std::string solution =
        solutions.empty() ? tools::read_solution(l.rubric) : tools::read_text(kTests + solutions + number + ".cpp");
    diagnose_all(l, solution, kTests + set.name + number + ".toml", tallies);
}

}  // namespace

TEST_CASE("mistakes that were never seen are named right or not at all" * doctest::skip()) {
    const std::vector<std::string> folders = assignment_folders();
    for (const Set& set : kSets) {
        CAPTURE(set.name);
        Tallies tallies;
        for (const std::string& folder : folders) diagnose_set(set, folder, tallies);
        check_tallies(tallies);
    }
}

TEST_CASE("a mistake's free number makes a family, whose ends make pairs; each choice of its parts is a way") {
    const TempFolder folder;
    const auto read = [&](const std::string& keys) {
        const std::string file = folder.write("m.toml", "[[mistake]]\nname = \"a\"\nsays = \"\"\npage = \"\"\n" + keys +
                                                            "\n[[mistake]]\nname = \"b\"\nsays = \"\"\npage = \"\"\n"
                                                            "from = \"one\"\nto = \"1\"\n");
        return tools::read_mistakes(file, "one two");
    };
    const auto complaint = [&](const std::string& keys) {
        try {
            (void)read(keys);
        } catch (const scene::UserError& error) { return std::string(error.what()); }
        return std::string("read");
    };
    const std::vector<tools::Mistake> mistakes = read("from = \"two\"\nto = \"$ + $\"\nvalues = [0.25, 3, 1e9]\n");
    std::vector<std::string> texts;
    for (const tools::Variant& v : tools::make_variants("one two", mistakes, true)) texts.push_back(v.text);
    CHECK(texts == std::vector<std::string>{"one two", "one 0.25f + 0.25f", "one 3.0f + 3.0f", "one 1e+09f + 1e+09f",
                                            "1 two", "1 0.25f + 0.25f", "1 1e+09f + 1e+09f"});
    const std::vector<tools::Mistake> parts = read("from = [\"one\", \"two\"]\nto = [\"1\", \"2\"]\nparts = true\n");
    texts.clear();
    for (const tools::Variant& v : tools::make_variants("one two", parts, true)) texts.push_back(v.text);
    CHECK(texts == std::vector<std::string>{"one two", "1 2", "one 2", "1 two", "1 two"});  // the last is b
    const std::vector<tools::Mistake> both =
        read("from = [\"one\", \"two\"]\nto = [\"$\", \"$\"]\nvalues = [3, 4]\nparts = true\n");
    texts.clear();
    for (const tools::Way& way : both[0].ways) {
        std::string text = "one two";
        CHECK(tools::apply(way.changes, text));
        texts.push_back(text + " " + std::to_string(way.family));
    }
    CHECK(texts == std::vector<std::string>{"3.0f 3.0f 0", "4.0f 4.0f 0", "one 3.0f 1", "one 4.0f 1", "3.0f two 2",
                                            "4.0f two 2"});
    CHECK(complaint("from = \"two\"\nto = \"2\"\nparts = true\n").find("two to four") != std::string::npos);
    CHECK(complaint("from = [\"one\", \"two\"]\nto = [\"1\", \"$\"]\nvalues = [1]\nparts = true\n")
              .find("for each of them") != std::string::npos);
    CHECK(complaint("from = \"two\"\nto = \"$\"\n").find("m.toml:6:6: 'to' in [[mistake]]: expected '$'") !=
          std::string::npos);
    CHECK(complaint("from = \"two\"\nto = \"2\"\nvalues = [1]\n").find("expected '$'") != std::string::npos);
    CHECK(complaint("from = \"two\"\nto = \"$\"\nvalues = [2, 1]\n").find("increasing") != std::string::npos);
    CHECK(complaint("from = \"two\"\nto = \"$\"\nvalues = [\"2\"]\n").find("expected numbers") != std::string::npos);
}

// What lies outside of the map is dark on one side or two: no other way has all these numbers and no more.
TEST_CASE("a mistake made in some of its places is named, though no way of the catalogue is that one") {
    const Lab& l = lab("A7_shadow_map");
    int tried = 0;
    for (std::size_t k = 0; k < l.catalogue.variants.size(); ++k) {
        const tools::Variant& v = l.catalogue.variants[k];
        if (names(l, v.mistakes) != "outside_dark") continue;
        CAPTURE(v.ways[0]);
        if (v.ways[0] == 0) continue;  // that is all sides
        const tools::Diagnosis d =
            tools::diagnose(marking(l, k), without(l.catalogue, [&](std::size_t mistake, std::size_t way) {
                                return mistake == v.mistakes[0] && way == v.ways[0];
                            }));
        CHECK(expected_name(d, l) == "outside_dark");
        CHECK((d.kind == tools::Diagnosis::Kind::nearly));
        ++tried;
    }
    CHECK(tried == 8);
}

// Of the powers that stand for sRGB's curve only the least and the greatest are left: what lies between them bends far
// too much to be named by those two.
TEST_CASE("a number that the catalogue does not list is solved for") {
    const Lab& l = lab("A5_fog", false);
    std::string changed = tools::read_solution(l.rubric);
    REQUIRE(tools::apply({{"1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f", "std::pow(x, 1.0f / 2.137f)"},
                          {"if (x <= 0.0031308f) return 12.92f * x;", ""}},
                         changed));
    const auto answers = tools::answers_of_variants(l.rubric, l.cases, {{{}, {}, changed}});
    const std::vector<tools::StageTable> tables = answers.all_of(0);
    const tools::Marking m = marking(l, tables);
    tools::Catalogue two = without(l.catalogue, [&](std::size_t mistake, std::size_t way) {
        const double number = l.catalogue.mistakes[mistake].ways[way].number;
        return l.catalogue.mistakes[mistake].name == "plain_power" && number != 1.4 && number != 3.0;
    });
    const tools::Diagnosis d = tools::diagnose(m, two);
    CHECK(expected_name(d, l) == "plain_power");
    CHECK((d.kind == tools::Diagnosis::Kind::exactly));
    two.program.clear();
    CHECK(expected_name(tools::diagnose(m, two), l) == "unknown");
}

// A part of them that costs seconds.
TEST_CASE("a sample of them is named right or not at all") {
    Tallies t;
    diagnose_set(kSets[2], "A4_shading", t);
    CHECK(t.single.percent() >= 95.0);
    CHECK(t.pair.percent() >= 80.0);
    CHECK(t.other.percent() >= 95.0);
}
