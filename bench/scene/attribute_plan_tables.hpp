// Plans of a scene's triangles beside all of one level, as tables.
#pragma once

#include <vector>

#include "bench/table.hpp"
#include "scene/attribute/planned_maps.hpp"

namespace mmverify::bench {

/// "plans", a row a set and error, beside maps of vertices of one level, the plan's index counted in both; and
/// "plan_levels", how many triangles have which level.
/// Domain: figures and plans of one scene and the same options.
std::vector<Table> attribute_plan_tables(const scene::AttributeFigures& figures,
                                         const std::vector<scene::PlannedMaps>& plans);

}  // namespace mmverify::bench
