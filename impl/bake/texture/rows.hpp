// A region row by row, with repeating rows left out.  Internal to impl/bake.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace mmverify::impl::bake::detail {

/// Columns [first, last] of a row; none: first > last.
struct Columns {
  std::int64_t first = 1, last = 0;

  constexpr bool empty() const noexcept { return first > last; }
  friend constexpr bool operator==(const Columns&, const Columns&) noexcept = default;
};

/// Rows [from, to] at which a region's outline may have a corner.
struct Bend {
  std::int64_t from, to;
};

/// Calls take(columns(j), j) for the rows [first, last] in their order until that returns false.  With a period, rows
/// that say nothing new are left out: after a period of rows with the same columns, those up to the first row with
/// others.
/// Time: the rows of a period and rows whose columns differ from the row before; a search of 40 steps for each run.
/// Domain: between bends each of a row's two ends moves one way only.  period: in rows, or 0.
template <class Of, class Take>
void each_row(std::int64_t first, std::int64_t last, std::int64_t period, std::span<const Bend> bends,
              Of columns, Take take) {
  std::int64_t alike = 0;
  Columns before;
  for (std::int64_t j = first; j <= last; ++j) {
    const Columns here = columns(j);
    if (!take(here, j)) return;
    if (period == 0) continue;
    alike = j != first && here == before ? alike + 1 : 1;
    before = here;
    if (alike < period) continue;
    std::int64_t end = last + 1;
    for (const Bend& bend : bends)
      if (bend.to >= j) end = std::min(end, bend.from);
    // Both ends move one way from j to the row before `end`: the rows with the columns of j come first.
    while (end - j > 1) {
      const std::int64_t middle = j + (end - j) / 2;
      (columns(middle) == here ? j : end) = middle;
    }
  }
}

}  // namespace mmverify::impl::bake::detail
