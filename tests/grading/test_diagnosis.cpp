// Mistakes that the catalogue does not hold as they are: other constants, other places, another style, pairs of them,
// and mistakes of another kind, of which nothing may be said.
#include <doctest/doctest.h>

#include "tests/grading/lab.hpp"
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

}  // namespace

TEST_CASE("mistakes that were never seen are named right or not at all" * doctest::skip()) {
    Tally single, pair, other;
    for (const std::string& folder : assignment_folders()) {
        const Lab& l = lab(folder);
        const std::string file =
            std::string(KREDA_SOURCE_DIR) + "/tests/grading/unseen/" + folder.substr(0, 2) + ".toml";
        const std::vector<tools::Mistake> unseen = tools::read_mistakes(l.rubric, file);
        const std::vector<tools::Variant> variants =
            tools::make_variants(tools::read_solution(l.rubric), unseen, false);
        REQUIRE(variants.size() == unseen.size() + 1);
        const auto answers = tools::answers_of_variants(l.rubric, l.cases, variants);
        for (std::size_t i = 0; i < unseen.size(); ++i) {
            const tools::Diagnosis d = diagnosis(l, answers[i + 1]);
            const std::string& expected = unseen[i].name;
            CHECK_MESSAGE(d.kind != tools::Diagnosis::Kind::right,
                          folder << ": " << unseen[i].says << " is not caught");
            Tally& tally = expected == "unknown" ? other : (expected.find(" + ") != std::string::npos ? pair : single);
            ++tally.all;
            const std::string found = expected_name(d, l);
            tally.right += same_names(found, expected) ? 1 : 0;
            if (!same_names(found, expected)) {
                MESSAGE(folder << ": " << expected << " (" << unseen[i].says << ") looks like " << found << ", misfit "
                               << d.misfit << ", next " << d.next_misfit);
            }
        }
    }
    MESSAGE("single " << single.right << " of " << single.all << ", pairs " << pair.right << " of " << pair.all
                      << ", others " << other.right << " of " << other.all);
    const std::string page = tools::read_text(std::string(KREDA_SOURCE_DIR) + "/docs/grading.md");
    for (const Tally& tally : {single, pair, other}) {
        const std::string cells = " | " + std::to_string(tally.all) + " | " + std::to_string(tally.right) + " |";
        CHECK_MESSAGE(page.find(cells) != std::string::npos, "docs/grading.md misses" << cells);
    }
    CHECK(single.all + pair.all >= 60);
    CHECK(single.percent() >= 95.0);
    CHECK(pair.percent() >= 80.0);
    CHECK(other.percent() >= 95.0);
}
