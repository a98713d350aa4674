// Orders that differ from the curve only inside some child: the children there are permuted.
#pragma once

#include <span>
#include <string>

#include "proofs/points/cells.hpp"

namespace mmverify::proofs::index {

/// A micro-triangle's index on the curve, and the subject's.
struct Renumbered {
  std::uint32_t right = 0, got = 0;
};

/// "children 0 and 2 change places inside each child 1": the one permutation of the children of all nodes that lie at any
/// depth inside a child c, directly inside one, or inside an odd number of them, if all other nodes keep their children's
/// order.  Empty if there is none, or if several differ.
/// Domain: all micro-triangles of level n, at most 7.
/// Test: ChildrenInside (index_dialect_test).
std::string name_children_inside(Level n, std::span<const Renumbered> all);

}  // namespace mmverify::proofs::index
