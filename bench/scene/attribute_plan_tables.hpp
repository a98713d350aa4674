// Tables of a scene's plans beside the same triangles all at one level.
#pragma once

#include <vector>

#include "bench/table.hpp"
#include "scene/attribute/planned_maps.hpp"

namespace mmverify::bench {

/// The tables of plans.  "plans" has a row for each set and error, beside maps of vertices of one level, with
/// the plan's index counted in both; "plan_levels" has the number of triangles at each level.
/// Domain: figures and plans of one scene and the same options.
std::vector<Table> attribute_plan_tables(const scene::AttributeFigures& figures,
                                         const std::vector<scene::PlannedMaps>& plans);

}  // namespace mmverify::bench
