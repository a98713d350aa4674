// The index of a point along the curve, and of many.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "tests/foreign/index/curve.hpp"
#include "tests/foreign/index/entry_points.hpp"
#include "tests/foreign/index/faults.hpp"
#include "tests/foreign/index/memory.hpp"
#include "tests/foreign/index/numbers.hpp"

namespace mmverify::tests::foreign::index {
namespace {

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

}  // namespace

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

template void indices(Word, const float*, const float*, Word*, std::size_t);
template void indices(Word, const double*, const double*, Word*, std::size_t);

}  // namespace mmverify::tests::foreign::index
