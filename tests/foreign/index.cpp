// The index of a micro-triangle along Vulkan's curve and in rows, and back, written from the header, docs/INDEX.md
// and the papers alone: exact for all numbers that it is given.  Each fault of the table is one slip inside this
// code.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "sdk/mmverify_subject.h"
#include "tests/foreign/fault.hpp"

namespace {

using mmverify::tests::foreign::chosen_fault;

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/index_faults.def"
#undef MMVERIFY_FAULT
};

constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/index_faults.def"
#undef MMVERIFY_FAULT
};

const std::optional<int> fault = chosen_fault(fault_names);
const int active = fault.value_or(-1);  // one comparison in the loops
bool has(Fault f) { return active == f; }

using Word = std::uint32_t;

Word side_of(Word level) { return Word{1} << level; }
Word indices_of(Word level) { return level < 16 ? Word{1} << (2 * level) : 0; }  // 2^32 wraps to 0

// ---- numbers

/// The fault-free number is the one that came.
template <bool rows, typename Real>
Real received(Real x) {
  const auto cut = [&](Real scale) { return std::trunc(x * scale) / scale; };
  if (std::is_same_v<Real, double> && has(narrowed)) x = static_cast<Real>(static_cast<float>(x));
  if (has(rows ? rows_fixed_24 : fixed_24)) x = cut(Real(0x1p24));
  if (has(rows ? rows_fixed_32 : fixed_32)) x = cut(Real(0x1p32));
  if (has(rows ? rows_fixed_39 : fixed_39)) x = cut(Real(0x1p39));
  if (has(rows ? rows_flush_30 : flush_30) && x < Real(0x1p-30)) x = 0;
  if (has(rows ? rows_flush_39 : flush_39) && x < Real(0x1p-39)) x = 0;
  if (has(rows ? rows_subnormal_by_significand : subnormal_by_significand) && x < Real(0x1p-126))
    x *= Real(0x1p126);
  if (has(rows ? rows_minus_zero_is_one : minus_zero_is_one) && std::signbit(x)) x = 1;
  return std::clamp(x, Real(0), Real(1));
}

/// x N = whole + part, both exact: N is a power of two, and the part has a subset of the significand's bits.
template <typename Real>
struct Scaled {
  Word whole;
  Real part;
};

Word shifted(float x, Word level, Word bits) {
  const auto word = std::bit_cast<Word>(x);
  const Word exponent = word >> 23;
  const std::uint64_t significand = (word & 0x7fffff) | (exponent ? 0x800000 : 0);
  const Word by = (150 - level - std::max(exponent, Word{1})) & ((Word{1} << bits) - 1);
  return by < 64 ? static_cast<Word>(significand >> by) : 0;
}

template <bool rows, typename Real>
Scaled<Real> scaled(Word level, Real x) {
  Real xn = x * static_cast<Real>(side_of(level));
  if (!rows && has(rounded_16_16)) xn = std::round(xn * Real(0x1p16)) / Real(0x1p16);
  const auto whole = static_cast<Word>(xn);
  Scaled<Real> s{whole, xn - static_cast<Real>(whole)};
  if constexpr (std::is_same_v<Real, float>) {
    if (!rows && has(shift_in_5_bits)) s.whole = shifted(x, level, 5);
    if (has(rows ? rows_shift_in_6_bits : shift_in_6_bits)) s.whole = shifted(x, level, 6);
    if (!rows && has(shift_in_7_bits)) s.whole = shifted(x, level, 7);
  }
  return s;
}

/// a + b >= 1 for 0 <= a, b < 1.  From 1/2 on 1 - max is exact; below, the sum is less than 1 and 1 - max is 1/2
/// or more, rounded or not.
template <typename Real>
bool reach_one(Real a, Real b) {
  return std::min(a, b) >= 1 - std::max(a, b);
}

/// u + v > 1, by the same argument.
template <typename Real>
bool over_one(Real u, Real v) {
  return std::min(u, v) > 1 - std::max(u, v);
}

// ---- along the curve

/// Algorithm 4, for its faults alone.
template <typename Real>
Word step(Word level, Real u, Real v) {
  Real w = 1 - u - v;
  Word index = 0;
  bool mid = false, top = false;
  const bool exceptions = !has(step_without_exceptions);
  const Real half = Real(0.5);
  for (Word depth = 0; depth < level; ++depth) {
    const bool except = exceptions && mid && v == half;
    const Real un = u, vn = v, wn = w;
    if (w > half) {
      index = 4 * index + (top ? 2 : 0);
      u = 2 * un, v = 2 * vn, w = wn - un - vn;
    } else if (v >= half && !except) {
      index = 4 * index + 3;
      u = 2 * un, v = vn - un - wn, w = 2 * wn;
      top = !top;
    } else if (u >= half && !except) {
      index = 4 * index + (top ? 0 : 2);
      u = un - vn - wn, v = 2 * vn, w = 2 * wn;
    } else {
      index = 4 * index + 1;
      u = un + vn - wn, v = wn + un - vn, w = vn + wn - un;
      if (has(step_appendix_middle)) std::swap(v, w);
      mid = !mid;
    }
  }
  return index;
}

/// 0 a 0 b 0 c ... of the low 16 bits.
Word spread(Word x) {
  x = (x | (x << 8)) & 0x00ff00ff;
  x = (x | (x << 4)) & 0x0f0f0f0f;
  x = (x | (x << 2)) & 0x33333333;
  return (x | (x << 1)) & 0x55555555;
}

std::atomic<Word> first_level{~Word{0}};

/// The bits of the index from the grid square and its half.
Word curve(Word level, Word iu, Word iv, Word iw, bool cold) {
  Word mask = side_of(level) - 1;
  if (has(mask_short_from_10) && level >= 10) mask >>= 1;
  if (has(first_level_sticks)) {
    Word none = ~Word{0};
    first_level.compare_exchange_strong(none, level);
    mask = side_of(first_level) - 1;
  }
  Word b0 = ~(iu ^ iw) & mask;
  const Word t = (iu ^ iv) & b0;
  Word f = t;
  if (!cold) {
    f ^= f >> 1;
    f ^= f >> 2;
    f ^= f >> 4;
    if (!has(prefix_over_8) && !(has(prefix_over_8_from_13) && level >= 13)) f ^= f >> 8;
  }
  if (has(prefix_over_15)) f ^= t >> 15;
  Word b1 = ((f ^ iu) & ~b0) | t;
  if (has(spread_15)) b1 &= 0x7fff;
  if (has(spread_b0_9)) b0 &= ~(Word{1} << 9);
  Word index = spread(b0) | (spread(b1) << 1);

  if (has(index_in_float)) index = static_cast<Word>(std::min(static_cast<float>(index), 0x1.fffffep31f));
  if (has(index_saturates)) index = std::min(index, Word{0x7fffffff});
  if (has(one_index_at_9) && level == 9 && index == 0x1a2b3) index ^= 1;
  if (has(one_index_at_12) && level == 12 && index == 0x5a2b3c) index ^= 1;
  if (has(one_index_at_16) && level == 16 && index == 0xb5a2b3c4) index ^= 1;
  if (has(pair_exchanged_at_9) && level == 9) {
    if (index == 0x1a2b3 || index == 0x1a2b7) index ^= 4;
  }
  if (has(last_digit_at_odd_levels) && level >= 9 && level % 2 == 1 && index % 2 == 0) index ^= 2;
  if (has(first_digit_at_9) && level == 9 && (index >> 16) % 2 == 0) index ^= 2u << 16;
  if (has(turned_round_at_7) && level == 7) index = indices_of(level) - 1 - index;
  return index;
}

template <typename Real>
struct Kept {
  Real u = -1, v = -1;
  Word level = ~Word{0};
  Word index = 0;
};

constexpr std::size_t scratch_size = 4096;
template <typename Real>
std::array<std::atomic<Real>, scratch_size> scratch;  // one for all threads, of the faults that share it

/// How an element is asked for: of the faults that look at it.
struct Asked {
  bool plain_sum = false, cold = false;
};

template <typename Real>
bool upper_half(Word level, Real u, Real v, Scaled<Real> su, Scaled<Real> sv, const Asked& asked) {
  const Word n = side_of(level), sum = su.whole + sv.whole;
  Real a = su.part, b = sv.part;
  const Real side = static_cast<Real>(n);
  bool plain = asked.plain_sum;
  if (has(plain_sum_from_13)) plain = level >= 13;
  if (has(plain_sum_in_first_square)) plain = sum == 0;
  if (has(plain_sum_in_first_row)) plain = sv.whole == 0 && level >= 1;
  if (plain) return a + b >= 1;
  if (has(sum_then_scale)) return (u + v) * side >= static_cast<Real>(sum + 1);
  if (has(w_in_own_type)) return (1 - u - v) * side <= side - static_cast<Real>(sum + 1);
  if (has(w_in_double))
    return (1 - static_cast<double>(u) - static_cast<double>(v)) * n <= static_cast<double>(n) - (sum + 1);
  if (has(epsilon_sum)) return static_cast<double>(a) + static_cast<double>(b) >= 1 - 0x1p-22;
  if (has(drops_small)) {
    if (a < Real(0x1p-12)) a = 0;
    if (b < Real(0x1p-12)) b = 0;
  }
  const bool tie = std::min(a, b) == 1 - std::max(a, b);
  if (has(tie_off_centre) && tie && a != b) return false;
  if (has(tie_strict) && tie) return false;
  if (has(tie_strict_at_half) && tie && sum + 1 == n / 2) return false;
  if (has(tie_strict_one_edge) && tie && level == 9 && su.whole == 77 && sv.whole == 200) return false;
  return reach_one(a, b);
}

template <typename Real>
Word index_of(Word level, Real u, Real v, const Asked& asked) {
  u = received<false>(u), v = received<false>(v);
  if (has(step_in_own_type)) return step(level, u, v);
  if (has(step_appendix_middle) || has(step_without_exceptions))
    return step(level, static_cast<double>(u), static_cast<double>(v));
  if (has(exchanged_uv_from_8) && level >= 8) std::swap(u, v);

  const Word n = side_of(level);
  Real u_floor = u, v_floor = v;
  if (has(ulp_up)) u_floor = std::nextafter(u, Real(1));
  if (has(ulp_up_at_half) && std::nextafter(v, Real(1)) == Real(0.5)) v_floor = Real(0.5);
  if (has(epsilon_floor)) u_floor = std::min(Real(1), u + Real(0x1p-20) / static_cast<Real>(n));
  const Scaled<Real> su = scaled<false>(level, u_floor);
  const Scaled<Real> sv = scaled<false>(level, v_floor);
  const bool upper = upper_half(level, u, v, su, sv, asked);
  const bool vertex = su.part == 0 && sv.part == 0;
  const bool over = over_one(u, v);

  if (has(over_is_a_miss) && over) return ~Word{0};
  if (has(over_at_the_u_corner) && u == 1 && v > 0) return indices_of(level);
  if (has(level_0_u_corner) && level == 0 && u == 1) return 1;
  if (has(level_0_hypotenuse) && level == 0 && u + v == 1 && u == v) return 1;
  if (has(u_corner_from_6) && level >= 6 && u == 1) return indices_of(level);

  Word iu = std::min(su.whole, n - 1), iv = std::min(sv.whole, n - 1);
  if (has(v_not_limited)) iv = sv.whole;
  if (has(u_tie_down_at_half) && level >= 7 && u == Real(0.5)) --iu;
  if (has(vertex_tie_down) && vertex && v == Real(0.25)) --iv;
  if (has(one_vertex_at_9) && level == 9 && vertex && iu == 100 && iv == 301) --iu;
  if (has(vertices_of_8) && level == 8 && vertex && iu > 0 && iv > 0 && iu + iv < n) --iu;

  const Word sum = iu + iv;
  if (sum >= n) {
    Word& lowered = has(over_lowers_v) && over ? iv : iu;
    lowered -= sum - n + 1;
  }
  Word iw = ~(iu + iv);
  bool inside = sum < n - 1;
  if (has(hypotenuse_decrements_from_8) && level >= 8 && sum == n - 1) inside = true;
  if (has(over_decrements) && over) inside = true;
  if (upper && inside) --iw;

  Word index = curve(level, iu, iv, iw, asked.cold);
  const bool interior = su.part != 0 && sv.part != 0 && su.part + sv.part != 1;
  if (has(pair_exchanged_inside_at_9) && level == 9 && interior && (index == 0x1a2b3 || index == 0x1a2b7))
    index ^= 4;
  if (has(middle_edge_at_9) && level == 9 && su.part == 0 && iv == 311 && iu == 99) index -= 1;
  if (has(out_of_range_at_8) && level == 8 && interior && index == 0x4321) index += indices_of(level);
  if (has(vertex_out_of_range_at_9) && level == 9 && vertex && iu == 200 && iv == 100)
    index += indices_of(level);
  return index;
}

/// A place in a cache of 4096.
Word place_of(Word a, Word b) { return ((a * 31 + b) * 0x9e3779b1) >> 20; }

/// The high bits of a number.
Word high_bits(float x) { return std::bit_cast<Word>(x) >> 12; }
Word high_bits(double x) { return high_bits(static_cast<float>(x)); }

template <typename Real>
Word cached_index(Word level, Real u, Real v, const Asked& asked) {
  if (has(cache_without_level)) {
    thread_local std::array<Kept<Real>, 4096> kept;
    auto& place = kept[place_of(high_bits(u), high_bits(v))];
    if (place.u != u || place.v != v) place = {u, v, level, index_of(level, u, v, asked)};
    return place.index;
  }
  if (has(cache_without_low_bits)) {
    thread_local std::array<Kept<Real>, 4096> kept;
    auto& place = kept[place_of(high_bits(u) + level, high_bits(v))];
    if (place.level != level || high_bits(place.u) != high_bits(u) || high_bits(place.v) != high_bits(v))
      place = {u, v, level, index_of(level, u, v, asked)};
    return place.index;
  }
  return index_of(level, u, v, asked);
}

template <typename Real>
void indices(Word level, const Real* u, const Real* v, Word* index, std::size_t count) {
  thread_local std::uint64_t asked_before = 0;
  if (has(count_in_16_bits)) count = static_cast<std::uint16_t>(count);
  const bool unaligned = reinterpret_cast<std::uintptr_t>(u) % 32 != 0;
  const bool f64 = std::is_same_v<Real, double>;
  const bool whole_call = has(plain_sum) || (has(plain_sum_of_f64) && f64) ||
                          (has(unaligned_plain_sum) && unaligned) ||
                          (has(tires) && asked_before > (1u << 26));
  const bool one_row = has(batch_taken_for_a_row) && v[0] == v[count - 1];
  Asked asked{whole_call, has(cold_first_call) && asked_before == 0};
  Real v_before = 0;
  if (has(shared_scratch))
    for (std::size_t k = 0; k < std::min(count, scratch_size); ++k)
      scratch<Real>[k].store(v[k], std::memory_order_relaxed);
  for (std::size_t k = 0; k < count; ++k) {
    const bool in_tail = k >= count / 8 * 8;
    asked.plain_sum = whole_call || (has(tail_plain_sum) && in_tail) || (has(body_plain_sum) && !in_tail) ||
                      (has(count_in_12_bits) && k >= 4096);
    Real vk = one_row ? v[0] : v[k];
    if (has(shared_scratch) && k < scratch_size) vk = scratch<Real>[k].load(std::memory_order_relaxed);
    if (has(keeps_a_larger_v)) vk = v_before = k == 0 || vk > v_before ? vk : v_before;
    index[k] = cached_index(level, u[k], vk, asked);
  }
  asked_before += count;
}

// ---- back from the curve

struct Vertex {
  Word i = 0, j = 0;
};
Vertex between(Vertex a, Vertex b) { return {(a.i + b.i) / 2, (a.j + b.j) / 2}; }

struct Path {
  Vertex w, u, v;
  bool turned = false;  // child 0 lies at u, child 2 at w
};

Path walk(Path at, Word level, Word index, Word from, Word to) {
  for (Word place = from; place-- > to;) {
    Word digit = (index >> (2 * place)) & 3;
    if (has(corners_of_30_bits) && place == 15) digit = 0;
    const Vertex wu = between(at.w, at.u), wv = between(at.w, at.v), uv = between(at.u, at.v);
    if (digit == 3) {
      at.w = wv, at.u = uv;
      if (!(has(corners_keep_their_turn_from_13) && level - place >= 13)) at.turned = !at.turned;
    } else if (digit == 1) {
      at.w = wv, at.u = uv, at.v = wu;
    } else if ((digit == 0) != at.turned) {
      at.u = wu, at.v = wv;
    } else {
      at.w = wu, at.v = uv;
    }
  }
  return at;
}

struct Corners {
  std::array<Vertex, 3> of{};
};

Corners corners_at(Word level, Word index, const Path& end) {
  Corners c{{end.turned ? end.u : end.w, end.turned ? end.w : end.u, end.v}};
  auto& at = c.of;
  const Word n = side_of(level), last = indices_of(level) - 1;
  for (Vertex& x : at) {
    if (has(corners_in_16_bits)) x = {static_cast<std::uint16_t>(x.i), static_cast<std::uint16_t>(x.j)};
    if (has(corners_short_of_the_u_corner) && level == 9) x.i = std::min(x.i, n - 1);
    if (has(corners_v_corner_from_8) && level >= 8) x.j = std::min(x.j, n - 1);
  }
  if (has(corners_one_at_10) && level == 10 && index == 0x72b3c) ++at[0].i;
  if (has(corners_one_at_12) && level == 12 && index == 0x5a2b3c) ++at[0].i;
  if (has(corners_one_at_16) && level == 16 && index == 0xb5a2b3c4) ++at[0].i;
  if (has(corners_second_half_from_9) && level >= 9 && index > last / 2) std::swap(at[0], at[1]);
  if (has(corners_middle_order) && index % 4 == 1 && end.turned) std::swap(at[1], at[2]);
  if (has(corners_last_order_at_10) && level == 10 && index == last) at = {at[1], at[2], at[0]};
  if (has(corners_of_level_0) && level == 0) at = {};
  return c;
}

Corners corners_of(Word level, Word index) {
  const Word n = side_of(level);
  if (has(corners_pair_exchanged_at_9) && level == 9 && (index == 0x1a2b3 || index == 0x1a2b7)) index ^= 4;
  return corners_at(level, index, walk({{0, 0}, {n, 0}, {0, n}, false}, level, index, level, 0));
}

void write(const Corners& c, Word* out) {
  for (const Vertex& x : c.of) *out++ = x.i, *out++ = x.j;
}

void corners(Word level, const Word* index, Word* out, std::size_t count) {
  const Word n = side_of(level), low = std::min(level, Word{3});
  Path to_prefix;
  Word prefix = 0;
  for (std::size_t k = 0; k < count; ++k) {
    Corners c = corners_of(level, index[k]);
    if (has(corners_keep_a_prefix)) {
      const Word here = index[k] >> (2 * low);
      if (k == 0 || here > prefix)
        prefix = here, to_prefix = walk({{0, 0}, {n, 0}, {0, n}, false}, level, index[k], level, low);
      c = corners_at(level, index[k], walk(to_prefix, level, index[k], low, 0));
    }
    if (has(corners_tail) && k >= count / 4 * 4) std::swap(c.of[0], c.of[1]);
    write(c, out + 6 * k);
  }
}

// ---- in rows

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

void row_corners(Word level, const Word* index, Word* out, std::size_t count) {
  Word row = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Word here = row_of(index[k]);
    row = has(row_corners_only_climb) ? std::max(row, here) : here;
    write(row_corners_of(level, index[k], row, has(row_corners_tail) && k >= count / 4 * 4), out + 6 * k);
  }
}

mmverify_subject_t make() {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "a stranger's index";
  s.max_level = 16;
  s.index_f32 = indices<float>;
  s.index_f64 = indices<double>;
  s.corners = corners;
  s.row_index_f32 = row_indices;
  s.row_corners = row_corners;
  return s;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  static const mmverify_subject_t subject = make();
  return fault ? &subject : nullptr;
}
