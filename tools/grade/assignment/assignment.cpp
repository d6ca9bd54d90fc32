#include "tools/grade/assignment/assignment.hpp"

#include <array>

namespace kreda::tools {

const Assignment* find_assignment(const std::string& name) {
    static const std::array<Assignment, 1> kAssignments = {{
        {"A3", record_a3, reference_a3},
    }};
    for (const Assignment& a : kAssignments) {
        if (a.name == name) return &a;
    }
    return nullptr;
}

}  // namespace kreda::tools
