// Means of four codes, compiled once for each SIMD target and chosen at run time; chains of levels; levels of detail.
#include "impl/attribute/mip.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/attribute/mip.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::attribute {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::ScalableTag<std::uint32_t>;
using WordVec = hn::Vec<Words>;

WordVec both(std::uint32_t in_each_half) { return hn::Set(Words(), in_each_half | in_each_half << 16); }

/// A quarter of each sum of four codes, half up.  A word has two sums, 16 bits each.
struct HalfUp {
  WordVec operator()(WordVec sums) const { return hn::ShiftRight<2>(hn::Add(sums, both(2))); }
};
struct HalfToEven {
  /// The sum 4q + 2 is the half between q and q + 1: one more than 1 is added only if q is odd, and carries it up.
  WordVec operator()(WordVec sums) const {
    const auto odd = hn::And(hn::ShiftRight<2>(sums), both(1));
    return hn::ShiftRight<2>(hn::Add(hn::Add(sums, both(1)), odd));
  }
};
struct Truncate {
  WordVec operator()(WordVec sums) const { return hn::ShiftRight<2>(sums); }
};

/// The mean of each lane's four children.  Even and odd bytes are summed apart, so that none overflows.
template <class Quarter>
struct MeanOfSum {
  WordVec operator()(WordVec a, WordVec b, WordVec c, WordVec d) const {
    const auto low = both(0xff);
    const auto even = [&](WordVec x) HWY_ATTR { return hn::And(x, low); };
    const auto odd = [&](WordVec x) HWY_ATTR { return hn::And(hn::ShiftRight<8>(x), low); };
    const Quarter quarter;
    const auto evens = quarter(hn::Add(hn::Add(even(a), even(b)), hn::Add(even(c), even(d))));
    const auto odds = quarter(hn::Add(hn::Add(odd(a), odd(b)), hn::Add(odd(c), odd(d))));
    return hn::Or(hn::And(evens, low), hn::ShiftLeft<8>(hn::And(odds, low)));
  }
};

struct MeanOfMeans {
  WordVec operator()(WordVec a, WordVec b, WordVec c, WordVec d) const {
    return mean(mean(a, b), mean(c, d));
  }

  /// mean_rgba8 of impl/attribute/decimation.hpp.
  static WordVec mean(WordVec x, WordVec y) {
    const auto half = hn::And(hn::ShiftRight<1>(hn::Xor(x, y)), hn::Set(Words(), 0x7f7f7f7f));
    return hn::Sub(hn::Or(x, y), half);
  }
};

template <class Mean>
void each_parent(const std::uint32_t* children, std::uint32_t* parents, std::size_t count, Mean mean) {
  const Words d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t k = 0;
  WordVec a, b, c, e;
  for (; count - k >= lanes; k += lanes) {
    hn::LoadInterleaved4(d, children + 4 * k, a, b, c, e);
    hn::StoreU(mean(a, b, c, e), d, parents + k);
  }
  if (k == count) return;
  HWY_ALIGN std::uint32_t left[4 * hn::MaxLanes(d)] = {};
  HWY_ALIGN std::uint32_t out[hn::MaxLanes(d)];
  std::memcpy(left, children + 4 * k, 4 * (count - k) * sizeof(std::uint32_t));
  hn::LoadInterleaved4(d, left, a, b, c, e);
  hn::Store(mean(a, b, c, e), d, out);
  std::memcpy(parents + k, out, (count - k) * sizeof(std::uint32_t));
}

void run_face_mip(const std::uint32_t* children, std::uint32_t* parents, std::size_t count,
                  Rounding rounding) {
  switch (rounding) {
    case Rounding::half_up: return each_parent(children, parents, count, MeanOfSum<HalfUp>());
    case Rounding::half_to_even: return each_parent(children, parents, count, MeanOfSum<HalfToEven>());
    case Rounding::truncate: return each_parent(children, parents, count, MeanOfSum<Truncate>());
    case Rounding::halves_up: return each_parent(children, parents, count, MeanOfMeans());
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::attribute
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::attribute {
namespace {

HWY_EXPORT(run_face_mip);

bool known(Rounding rounding) { return rounding <= Rounding::halves_up; }

/// The sums of each of the four codes under a micro-triangle.
using Sums = std::array<std::uint32_t, 4>;
/// The last level at which sums fit 32 bits: 255 * 4^12 < 2^32.
constexpr Level highest_of_sums = 12;

/// sum / 2^shift as a code, rounded.  Domain: shift in 1..31.
std::uint32_t rounded(std::uint32_t sum, unsigned shift, Rounding rounding) {
  const std::uint32_t down = sum >> shift, half = std::uint32_t{1} << (shift - 1),
                      left = sum & (2 * half - 1);
  if (rounding == Rounding::truncate || left < half) return down;
  return rounding == Rounding::half_to_even && left == half ? down + down % 2 : down + 1;
}

/// The sums of four words' codes, code by code.
Sums sums_of(const std::uint32_t* four) {
  Sums sum{};
  for (std::size_t child = 0; child < 4; ++child)
    for (unsigned code = 0; code < 4; ++code) sum[code] += four[child] >> 8 * code & 255;
  return sum;
}
Sums sums_of(const Sums* four) {
  Sums sum{};
  for (std::size_t child = 0; child < 4; ++child)
    for (unsigned code = 0; code < 4; ++code) sum[code] += four[child][code];
  return sum;
}

void chain_of_sums(Level level, std::span<const std::uint32_t> base, Rounding rounding,
                   std::span<std::uint32_t> chain) {
  std::vector<Sums> sums(base.size() / 4);
  for (Level m = level; m-- > 0;) {
    const auto out = chain.subspan(face_chain_size(m), std::size_t{1} << (2 * m));
    for (std::size_t k = 0; k < out.size(); ++k) {
      sums[k] = m + 1 == level ? sums_of(base.data() + 4 * k) : sums_of(sums.data() + 4 * k);
      std::uint32_t word = 0;
      for (unsigned code = 0; code < 4; ++code)
        word |= rounded(sums[k][code], 2 * (level - m), rounding) << 8 * code;
      out[k] = word;
    }
  }
}

/// 1/2 log2(r) for r in [1, 4), within 2^-29: log2 r = 2/ln 2 (s + s^3/3 + s^5/5 + ...), s = (r-1)/(r+1), with r
/// brought to [1/sqrt 2, sqrt 2].  There |s| < 0.172, and the terms left out are below 2^-28.
double half_log2(double r) {
  double whole = 0;
  if (r >= 2) whole = 1, r /= 2;
  if (r >= 1.4142135623730951) whole += 1, r /= 2;
  const double s = (r - 1) / (r + 1), s2 = s * s;
  const double series = s * (1 + s2 * (1.0 / 3 + s2 * (1.0 / 5 + s2 * (1.0 / 7 + s2 * (1.0 / 9)))));
  constexpr double one_over_ln2 = 1.4426950408889634;
  return whole / 2 + one_over_ln2 * series;
}

}  // namespace

void face_mip(std::span<const std::uint32_t> children, Rounding rounding, std::span<std::uint32_t> parents) {
  if (children.size() / 4 != parents.size() || children.size() % 4 != 0)
    throw std::invalid_argument("attribute::face_mip: children are four times as many as parents");
  if (!known(rounding)) throw std::invalid_argument("attribute::face_mip: no such rounding");
  HWY_DYNAMIC_DISPATCH(run_face_mip)(children.data(), parents.data(), parents.size(), rounding);
}

void face_chain(Level level, std::span<const std::uint32_t> base, Rounding rounding, ChainOf of,
                std::span<std::uint32_t> chain) {
  if (level > highest_of_sums || base.size() != std::size_t{1} << (2 * level) ||
      chain.size() != face_chain_size(level))
    throw std::invalid_argument(
        "attribute::face_chain: 4^level values make (4^level - 1) / 3, level at most 12");
  if (!known(rounding) || of > ChainOf::exact_sums ||
      (of == ChainOf::exact_sums && rounding == Rounding::halves_up))
    throw std::invalid_argument("attribute::face_chain: no such rounding");
  if (of == ChainOf::exact_sums) return chain_of_sums(level, base, rounding, chain);
  std::span<const std::uint32_t> above = base;
  for (Level m = level; m-- > 0;) {
    const auto out = chain.subspan(face_chain_size(m), std::size_t{1} << (2 * m));
    face_mip(above, rounding, out);
    above = out;
  }
}

Lod lod(float cone, float triangle, Level level) noexcept {
  const Level n = std::min(level, max_level), m = lod_level(cone, triangle, n);
  const double c = detail::area(cone), t = detail::area(triangle);
  if (m == n || !(c < t)) return {m, 0};
  // Here c > 0, or m would be n.  The powers of two are exact; the quotient rounds once.
  const double r = t / (c * static_cast<double>(std::uint64_t{1} << (2 * m)));
  return {m, std::min(static_cast<float>(half_log2(r)), 0x1.fffffep-1f)};
}

void lod_level(std::span<const float> cone, std::span<const float> triangle, Level level,
               std::span<Level> out) {
  if (cone.size() != out.size() || triangle.size() != out.size())
    throw std::invalid_argument("attribute::lod_level: cone, triangle and out differ in length");
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = lod_level(cone[k], triangle[k], level);
}

}  // namespace mmverify::impl::attribute
#endif  // HWY_ONCE
