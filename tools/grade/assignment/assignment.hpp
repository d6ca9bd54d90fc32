// What an assignment is made of: which rows its functions are given, and what Kreda's own functions answer.
#pragma once

#include <string>
#include <vector>

#include "tools/grade/assignment/scene_record.hpp"
#include "tools/grade/assignment/stage_table.hpp"

namespace kreda::tools {

struct Assignment {
    std::string name;                                                            ///< "A3"
    void (*record)(const SceneRecord& record, std::vector<StageTable>& tables);  ///< the rows of one scene
    void (*reference)(StageRow row);                                             ///< Kreda's answer to one row
};

/// "A1" to "A8"; null: there is none of this name.
[[nodiscard]] const Assignment* find_assignment(const std::string& name);

void record_a1(const SceneRecord& record, std::vector<StageTable>& tables);
void reference_a1(StageRow row);
void record_a2(const SceneRecord& record, std::vector<StageTable>& tables);
void reference_a2(StageRow row);
void record_a3(const SceneRecord& record, std::vector<StageTable>& tables);
void reference_a3(StageRow row);
void record_a4(const SceneRecord& record, std::vector<StageTable>& tables);
void reference_a4(StageRow row);
void record_a5(const SceneRecord& record, std::vector<StageTable>& tables);
void reference_a5(StageRow row);
void record_a6(const SceneRecord& record, std::vector<StageTable>& tables);
void reference_a6(StageRow row);
void record_a7(const SceneRecord& record, std::vector<StageTable>& tables);
void reference_a7(StageRow row);
void record_a8(const SceneRecord& record, std::vector<StageTable>& tables);
void reference_a8(StageRow row);

}  // namespace kreda::tools
