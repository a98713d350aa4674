// Back from rows: the corners of an index.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tests/foreign/index/corners.hpp"
#include "tests/foreign/index/entry_points.hpp"
#include "tests/foreign/index/faults.hpp"

namespace mmverify::tests::foreign::index {
namespace {

/// floor(sqrt(index)): the root of a 32-bit number is right in binary64 but for its rounding up, mended here.
Word row_of(Word index) {
  if (has(row_root_in_float)) return static_cast<Word>(std::sqrt(static_cast<float>(index)));
  if (has(row_root_limited_in_32_bits)) {
    const auto row = static_cast<Word>(std::sqrt(static_cast<float>(index)));
    return row * row > index ? row - 1 : row;
  }
  auto row = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(index)));
  if (has(row_root_signed)) {
    const auto as_signed = static_cast<std::int32_t>(index);
    row = as_signed < 0 ? 0 : row;
  }
  if (row * row > index) --row;
  if (has(row_root_square_overflows)) {
    const Word above = static_cast<Word>(row) + 1;
    if (above * above <= index) ++row;
  } else if ((row + 1) * (row + 1) <= index) {
    ++row;
  }
  return static_cast<Word>(row);
}

Corners row_corners_of(Word level, Word index, Word row, bool points_up) {
  Word column = index - row * row;
  if (has(row_corners_by_parity_of_index) && row >= 1024) column = (column & ~Word{1}) | (index & 1);
  const Word c = column / 2;
  const auto at = [](Word r, Word k) { return Vertex{r - k, k}; };
  if (has(row_corners_last_of_row) && level >= 9 && column == 2 * row) points_up = false, column ^= 1;
  Corners out;
  if (column % 2 == 0 || points_up)
    out.of = {at(row, c), at(row + 1, c), at(row + 1, c + 1)};
  else
    out.of = {at(row, c), at(row + 1, c + 1), at(row, c + 1)};
  if (has(row_corners_level_0) && level == 0) out.of = {at(0, 0), at(2, 0), at(2, 2)};
  if (has(row_corners_one_at_10) && level == 10 && index == 0x72b3c) ++out.of[2].i;
  if (has(row_corners_one_at_16) && level == 16 && index == 0xb5a2b3c4) ++out.of[2].i;
  for (Vertex& x : out.of) {
    if (has(row_corners_in_16_bits)) x = {static_cast<std::uint16_t>(x.i), static_cast<std::uint16_t>(x.j)};
    if (has(row_corners_exchanged)) std::swap(x.i, x.j);
  }
  return out;
}

}  // namespace

void row_corners(Word level, const Word* index, Word* out, std::size_t count) {
  Word row = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Word here = row_of(index[k]);
    row = has(row_corners_only_climb) ? std::max(row, here) : here;
    write(row_corners_of(level, index[k], row, has(row_corners_tail) && k >= count / 4 * 4), out + 6 * k);
  }
}

}  // namespace mmverify::tests::foreign::index
