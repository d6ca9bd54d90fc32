// All variants of a solution as one C++ program that holds each different function once.
#pragma once

#include <string>
#include <vector>

namespace kreda::tools {

/// A function that students write, as assignment.hpp declares it: one line, "glm::vec3 mirror_vector(const glm::vec3&
/// n, const glm::vec3& l);", the arguments with their names.
struct Prototype {
    std::string declaration;  ///< without the semicolon
    std::string name;
    std::string arguments;  ///< "n, l"
};

/// Those of a header: its lines that begin in the first column and end with ");".
[[nodiscard]] std::vector<Prototype> prototypes_of(const std::string& header);

/// A solution taken apart: the text of each prototype's function, and what stands around them.
struct SolutionParts {
    std::string helpers;
    std::vector<std::string> functions;  ///< one a prototype; all empty: `helpers` is the whole solution
};

/// The variable that variants with a free number read.
inline constexpr const char* kFreeNumber = "free_number";

/// Functions begin in the first column and end with "}" there. Where one of them cannot be found, nothing is split.
[[nodiscard]] SolutionParts split_solution(const std::string& solution, const std::vector<Prototype>& prototypes);

/// The program's one file. Variants share the functions whose text they share; the stages, and the functions among
/// themselves, call through functions that hand each call to the variant whose turn it is. The program takes
/// INPUTS, a FOLDER, and how many of the first variants to run. FOLDER/answers.bin: for each table of inputs the
/// different answers to it, as tables. FOLDER/index.txt: for each table of inputs how many they are, and the number of
/// every variant's. With further arguments, "variant number variant number ...", it writes what each of these variants
/// answers while kFreeNumber, a variable that any solution may read, has that number. A variant is run on a table only
/// if no other had the same functions where the table's rows called any.
[[nodiscard]] std::string variant_source(const std::string& assignment_header, const std::string& stages,
                                         const std::vector<std::string>& solutions);

}  // namespace kreda::tools
