// All variants of a solution as one C++ file: compiled once, run once, in a second or two for hundreds of them.
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

/// The file. Every solution stands in a namespace of its own; the stages call functions that hand each call on to the
/// variant whose turn it is. The program takes INPUTS and a FOLDER and writes FOLDER/0, FOLDER/1, ...
[[nodiscard]] std::string variant_source(const std::string& assignment_header, const std::string& stages,
                                         const std::vector<std::string>& solutions);

}  // namespace kreda::tools
