// Our graph beside Common Subtree Merging, as tables.
#pragma once

#include <vector>

#include "bench/dag/csm_figures.hpp"
#include "bench/table.hpp"

namespace mmverify::bench {

/// A row for each level and format.
Table csm_table(const std::vector<CsmFigures>& figures);

/// A row for each form: levels and formats apart and together.
Table merged_levels_table(const std::vector<CsmFigures>& figures, const MergedBytes& merged);

}  // namespace mmverify::bench
