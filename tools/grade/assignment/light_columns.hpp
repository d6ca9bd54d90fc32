// Lights and local materials as columns of numbers, for the assignments that have them.
#pragma once

#include <span>

#include "lighting/light.hpp"
#include "lighting/material.hpp"
#include "tools/grade/assignment/stage_table.hpp"

namespace kreda::tools {

/// One light a row.
void add_light(TableBuilder& builder, const lighting::LightSetup& light);
/// All lights of a scene, the same for every row.
void list_lights(TableBuilder& builder, std::span<const lighting::LightSetup> lights);
/// Light number i of either.
[[nodiscard]] lighting::LightSetup light_at(const StageRow& row, std::size_t i);

void add_material(TableBuilder& builder, const lighting::PhongMaterial& m);

/// Put the rows of `table` behind those of the same stage and scene; without any, add nothing.
void append_rows(std::vector<StageTable>& tables, const StageTable& table);

}  // namespace kreda::tools
