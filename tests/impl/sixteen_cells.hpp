// Marks that the vector baker's parts give a node, for the target that is compiled for.
#pragma once

#include <hwy/highway.h>

#include "impl/bake/sixteen/few-inl.hpp"
#include "tests/impl/sixteen_nodes.hpp"

namespace mmverify::tests {

using namespace mmverify::impl::bake::detail::HWY_NAMESPACE;
using SixteenFloats = SixteenLanes::Floats;

/// All sixteen, of cells in these planes.
template <bool keeps>
CellMarks cells_of(const SixteenInput& in, const Words& words, MetCells& met) {
  CellMarks marks;
  for (std::size_t k = 0; k < 16; k += hn::Lanes(F())) ask_cells<true, keeps>(in, words, k, marks, met);
  return marks;
}
}  // namespace mmverify::tests
