// The hash tables that find stored tiles, nodes and flat maps again.  Internal to impl/dag.
#pragma once

#include <array>
#include <vector>

#include "impl/dag/dag.hpp"
#include "impl/dag/table.hpp"

namespace mmverify::impl::dag {

struct Dag::HashTables {
  Table tiles;
  std::array<Table, max_level + 1> nodes, flat;  ///< by level
  std::vector<Level> added;                      ///< levels of the nodes that the current add() has added
};

}  // namespace mmverify::impl::dag
