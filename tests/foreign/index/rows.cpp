// The index in row order: of one point, and of many.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tests/foreign/index/entry_points.hpp"
#include "tests/foreign/index/faults.hpp"
#include "tests/foreign/index/memory.hpp"
#include "tests/foreign/index/numbers.hpp"

namespace mmverify::tests::foreign::index {
namespace {

/// Figure 4 in a number's own type, for its faults alone.
template <typename Real>
Word figure_4(Word level, Real u, Real v) {
  const Real n = static_cast<Real>(side_of(level)), w = 1 - (u + v);
  const Word top = side_of(level) - 1;
  const Word row = std::min(top, static_cast<Word>((1 - w) * n));
  const Word column = std::min(row, static_cast<Word>(v * n));
  const Word diagonal = std::min(top, static_cast<Word>((1 - u) * n));
  return row * row + column + (diagonal - (top - row));
}

Word row_index_of(Word level, float u, float v, bool figure) {
  u = received<true>(u), v = received<true>(v);
  if (has(rows_mirrored)) std::swap(u, v);
  const Word n = side_of(level), top = n - 1;
  const float quarters_u = u * static_cast<float>(n) * 4, quarters_v = v * static_cast<float>(n) * 4;
  const bool off_quarters = std::floor(quarters_u) != quarters_u || std::floor(quarters_v) != quarters_v;
  if (figure || has(rows_figure_4) || (has(rows_figure_4_off_quarters) && off_quarters) ||
      (has(rows_figure_4_from_13) && level >= 13))
    return figure_4(level, u, v);
  if (has(rows_figure_4_in_double)) return figure_4(level, static_cast<double>(u), static_cast<double>(v));

  float u_floor = u, v_floor = v;
  if (has(rows_ulp_up)) u_floor = std::nextafter(u, 1.0f);
  if (has(rows_ulp_up_at_half) && std::nextafter(v, 1.0f) == 0.5f) v_floor = 0.5f;
  const auto su = scaled<true>(level, u_floor), sv = scaled<true>(level, v_floor);
  const bool tie = std::min(su.part, sv.part) == 1 - std::max(su.part, sv.part);
  const bool over = over_one(u, v);
  if (has(rows_over_is_a_miss) && over) return ~Word{0};
  if (has(rows_level_0) && level == 0 && u + v == 1 && u > 0 && v > 0) return 1;

  // floor((u + v) N) is the sum of the floors, and one more where the fractions reach 1.
  bool carry = reach_one(su.part, sv.part);
  if (has(rows_plain_sum)) carry = su.part + sv.part >= 1;
  if (has(rows_epsilon_sum))
    carry = static_cast<double>(su.part) + static_cast<double>(sv.part) >= 1 - 0x1p-22;
  if (has(rows_tie_off_centre) && tie && su.part != sv.part) carry = false;
  Word row = su.whole + sv.whole + carry;
  if (has(rows_sum_then_scale)) row = static_cast<Word>((u + v) * static_cast<float>(n));
  if (has(rows_tie_strict_at_half) && level >= 7 && u + v == 0.5f && row == n / 2 && (tie || su.part == 0))
    --row;
  if (!(has(rows_row_not_limited_over) && over)) row = std::min(row, top);

  Word column = std::min(sv.whole, row);
  if (has(rows_column_not_limited) || (has(rows_column_not_limited_at_16) && level == 16)) column = sv.whole;

  // floor((1 - u) N) = N - ceil(uN)
  Word ceiling = su.whole + (su.part > 0);
  if (has(rows_ceil_by_a_constant)) ceiling = su.whole + (su.part > 0.001f);
  if (has(rows_u_tie)) ceiling = su.whole + 1;
  if (has(rows_u_tie_at_half) && level >= 8 && u == 0.5f) ++ceiling;
  Word diagonal = n - std::min(ceiling, n);
  if (has(rows_one_less_u)) diagonal = static_cast<Word>((1 - u) * static_cast<float>(n));
  if (!(has(rows_diagonal_not_limited) && level >= 6)) diagonal = std::min(diagonal, top);
  if (has(rows_one_vertex_at_9) && level == 9 && su.part == 0 && sv.part == 0 && su.whole == 100 &&
      sv.whole == 301)
    ++column;

  Word index = row * row + column + (diagonal - (top - row));
  if (has(rows_index_in_float)) {
    const auto r = static_cast<float>(row);
    index = static_cast<Word>(r * r + static_cast<float>(column + (diagonal - (top - row))));
  }
  if (has(rows_one_index_at_9) && level == 9 && index == 0x1a2b3) index ^= 1;
  if (has(rows_one_index_at_16) && level == 16 && index == 0xb5a2b3c4) index ^= 1;
  if (has(rows_pair_exchanged_at_9) && level == 9 && (index == 0x1a2b3 || index == 0x1a2b5)) index ^= 6;
  return index;
}

}  // namespace

void row_indices(Word level, const float* u, const float* v, Word* index, std::size_t count) {
  thread_local std::uint64_t asked_before = 0;
  const bool figure = has(rows_tire) && asked_before > (1u << 26);
  const bool one_row = has(rows_batch_taken_for_a_row) && v[0] == v[count - 1];
  float v_before = 0;
  if (has(rows_shared_scratch))
    for (std::size_t k = 0; k < std::min(count, scratch_size); ++k)
      scratch<float>[k].store(v[k], std::memory_order_relaxed);
  for (std::size_t k = 0; k < count; ++k) {
    float vk = one_row ? v[0] : v[k];
    if (has(rows_shared_scratch) && k < scratch_size) vk = scratch<float>[k].load(std::memory_order_relaxed);
    if (has(rows_keep_a_larger_v)) vk = v_before = k == 0 || vk > v_before ? vk : v_before;
    if (has(rows_cache_without_level)) {
      thread_local std::array<Kept<float>, 4096> kept;
      auto& place = kept[place_of(high_bits(u[k]), high_bits(vk))];
      if (place.u != u[k] || place.v != vk) place = {u[k], vk, level, row_index_of(level, u[k], vk, false)};
      index[k] = place.index;
      continue;
    }
    index[k] = row_index_of(level, u[k], vk, figure || (has(rows_tail) && k >= count / 8 * 8));
    if (has(rows_tail_exact) && count % 2 == 1 && k + 1 == count && level > 0) {
      const auto row = static_cast<Word>(std::sqrt(static_cast<double>(index[k])));
      if (index[k] - row * row < 2 * row) ++index[k];
    }
  }
  asked_before += count;
}

}  // namespace mmverify::tests::foreign::index
