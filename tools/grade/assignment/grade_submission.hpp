// One submission from its folder to its points.
#pragma once

#include <filesystem>

#include "tools/grade/assignment/build_program.hpp"
#include "tools/grade/assignment/diagnose.hpp"
#include "tools/grade/result.hpp"

namespace kreda::tools {

/// Compile, run, compare, name. Never throws for what a submission does; throws UserError for a wrong rubric or hidden
/// folder, and where there is no box.
[[nodiscard]] GradeResult grade_submission(const Rubric& rubric, const std::filesystem::path& folder,
                                           const GradeOptions& options);

/// The same with all that is kept between submissions at hand.
[[nodiscard]] GradeResult grade_submission(const Rubric& rubric, const CaseSet& cases,
                                           const std::filesystem::path& folder, const GradeOptions& options,
                                           const CompileOptions& compile = {});

}  // namespace kreda::tools
