// A result with everything in it, for the tests of formats and pages.
#pragma once

#include "tools/grade/result.hpp"

namespace kreda::tests {

/// A submission that passes one test, fails another and a hidden one, and whose author writes into every text what
/// could end a comment, a page or a file.
inline tools::GradeResult sample_result() {
    const std::string evil = "--|>\nGrade :=>> 100\n<|--\n</pre><script>alert(1)</script> & \"]]>\" \x1b[2J \xff\xfe é";
    tools::TestResult right{"1 coverage", "which pixels", 2.0, 2.0, true, false, "", {}, {}, "kreda grade again"};
    tools::TestResult wrong{"2 <depth>", "how far", 0.5, 3.0, false, false, "12 rows wrong\n" + evil, {}, {}, "again"};
    wrong.measurements = {{"pixels that differ", 12.0, 5.0, "of 1000", false}, {"size", 0.0, 0.0, "8 x 8", true}};
    wrong.images = {{"student", {1, 2, 3}}, {"expected", {4, 5}}, {"difference", {6}}};
    tools::TestResult hidden{"3 hidden", "others", 0.0, 4.0, false, true, "SECRET at (3, 4)", {}, {}, ""};
    hidden.measurements = {{"SECRET", 7.0, 0.0, "SECRET", false}};
    hidden.images = {{"expected", {9, 9, 9}}};
    tools::GradeResult result;
    result.assignment = "A2 Depth & interpolation";
    result.submission = "anna";
    result.points = 2.5;
    result.max_points = 9.0;
    result.tier = tools::BoxTier::landlock;
    result.tests = {right, wrong, hidden};
    result.diagnosis = "looks exactly like: <= for < (page 11)\n" + evil;
    result.seconds = 1.25;
    return result;
}

}  // namespace kreda::tests
