// A free number that the catalogue does not list: solved for, not guessed.
#pragma once

#include "tools/grade/assignment/table_fits.hpp"

namespace kreda::tools {

/// Where a mistake has a free number: the number with which it comes nearest to the submission, between the catalogue's
/// and half a step beyond them, is looked for by running the changed solution. What fits nearly becomes a way of its
/// own.
void add_solved_numbers(Fits& fits);

}  // namespace kreda::tools
