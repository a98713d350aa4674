// Where a subject is wrong on a level: the cells themselves, for pictures.
#pragma once

#include <cstddef>
#include <vector>

#include "proofs/index/picture.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// A cell by its representative, (ku, kv) / 4N, the right answer and the subject's.
struct WrongCell {
  std::int64_t ku, kv;
  std::uint32_t expected, got;
};

struct WrongCells {
  std::uint64_t cells = 0, wrong = 0;
  std::vector<WrongCell> listed;  ///< the first of them, in the order of Cells
};

/// Asks the subject on all cells of level n, and compares with the Vulkan formula or, in row order, with
/// figure 4, both on the points as the subject receives them; lists `most` of the wrong cells. Domain: a
/// subject that has the order's entry point, n up to its highest level.
WrongCells wrong_cells(const IndexSubject& subject, Level n, Order order, std::size_t most);

}  // namespace mmverify::proofs::index
