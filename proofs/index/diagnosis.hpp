// Diagnosis of a wrong index: ties, range, levels, or another order with a known name.
#pragma once

#include "proofs/index/picture.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The index of an open micro-triangle by a subject.
using TriangleIndex = std::function<std::uint32_t(const MicroTriangle&)>;

/// The name of the order of these indices at one level, if it is a known one other than the reference's:
///   row order; the reference's or row order with the vertices in another order; the curve's digits with the
///   children permuted, at which depths; the curve without its flips, or without turning the middle triangle.
/// Empty for any other order.  Calls `index` once for each of the 4^n micro-triangles.  Domain: n in 1..10.
std::string name_order(Level n, const TriangleIndex& index);

/// Lines that name a subject's mistake.  Domain: its results of index.equals_reference, from the lowest level on; one
/// of them is refuted.
std::vector<std::string> diagnose(const IndexSubject& subject, const std::vector<Result>& results);

/// A cell by its representative, (ku, kv) / 4N, with the right answer and the subject's.
struct WrongCell {
  std::int64_t ku, kv;
  std::uint32_t expected, got;
};

/// A window of representatives with ku in [ku0, ku1] and kv in [kv0, kv1].
struct CellWindow {
  std::int64_t ku0, ku1, kv0, kv1;
  bool holds(std::int64_t ku, std::int64_t kv) const {
    return ku0 <= ku && ku <= ku1 && kv0 <= kv && kv <= kv1;
  }
};

/// The window that holds all of level n.
constexpr CellWindow whole_level(Level n) {
  const std::int64_t all = 4 * std::int64_t{side(n)};
  return {0, all, 0, all};
}

struct WrongCells {
  std::uint64_t cells = 0, wrong = 0;  ///< of the level
  std::vector<WrongCell> listed;       ///< the wrong cells in the window, in the order of Cells
};

/// Compares the subject on all cells of level n with the Vulkan formula or, in row order, with figure 4, both on the
/// points as the subject receives them.  Lists the wrong cells of a window.
/// Domain: a subject that has the order's entry point, n up to its highest level.
WrongCells wrong_cells(const IndexSubject& subject, Level n, Order order, const CellWindow& window);

}  // namespace mmverify::proofs::index
