#include "proofs/index/wrong_cells.hpp"

#include <algorithm>

namespace mmverify::proofs::index {

WrongCells wrong_cells(const IndexSubject& subject, Level n, Order order, const CellWindow& window) {
  WrongCells found;
  std::vector<GridPoint> points;
  std::vector<std::uint32_t> got;
  Cells(n).rows(0, cell_count(n), [&](const Row& whole_row) {
    for (std::uint64_t from = 0; from < whole_row.count; from += row_batch) {
      const Row row = Cells::cut(whole_row, from, std::min<std::uint64_t>(row_batch, whole_row.count - from));
      points.clear();
      for (std::uint64_t t = 0; t < row.count; ++t) points.push_back(representative(row, t, n));
      subject.functions.receive(points);
      got.resize(points.size());
      if (order == Order::curve)
        subject.functions.index(n, {points}, got);
      else
        subject.functions.row_index(n, {points}, got);
      for (std::uint64_t t = 0; t < row.count; ++t) {
        const std::uint32_t expected =
            order == Order::curve ? spec::index::reference(points[t], n) : spec::index::w_minor(points[t], n);
        if (got[t] == expected) continue;
        ++found.wrong;
        const std::int64_t ku = row.ku + static_cast<std::int64_t>(t) * row.stride;
        if (window.holds(ku, row.kv)) found.listed.push_back({ku, row.kv, expected, got[t]});
      }
      found.cells += row.count;
    }
  });
  return found;
}

}  // namespace mmverify::proofs::index
