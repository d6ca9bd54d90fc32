// A class: the results of all submissions, and what they say together.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/grade/result.hpp"

namespace kreda::tools {

/// How often something happened, the most frequent first; equals in the order of the alphabet.
using Counts = std::vector<std::pair<std::string, std::size_t>>;

/// How many submissions fail each test, in the order of the tests' frequency of failure.
[[nodiscard]] Counts failures_of_tests(const std::vector<GradeResult>& results);

/// The mistakes of those that did not pass everything, equal ones and alike ones counted together.
[[nodiscard]] Counts diagnoses(const std::vector<GradeResult>& results);

/// Ten bins of the share of points: [0, 10 %), ..., [90 %, 100 %].
[[nodiscard]] std::vector<std::size_t> histogram(const std::vector<GradeResult>& results);

/// Groups of submissions whose files are the same to the byte, each sorted; names of folders below `folder`.
[[nodiscard]] std::vector<std::vector<std::string>> identical_submissions(const std::filesystem::path& folder,
                                                                          const std::vector<std::string>& names);

/// One line a submission: name, points, one column a test, diagnosis, box, error.    RFC 4180
[[nodiscard]] std::string class_csv(const std::vector<GradeResult>& results);

/// The overview with links to NAME/report.html.
[[nodiscard]] std::string class_html(const std::vector<GradeResult>& results,
                                     const std::vector<std::vector<std::string>>& identical);

}  // namespace kreda::tools
