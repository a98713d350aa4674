#include "proofs/index/step_sweep.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace mmverify::proofs::index {
namespace {

using spec::index::next_step;
using spec::index::Reading;
using Step = spec::index::Step<Fixed64>;

// Four levels in the table: 4^4 digits fit a byte and its 66 KB stay in the cache.
constexpr Level tail_levels = 4;
// A point of the finest grid asked for, g = n+1, is a multiple of 1/(4 2^(tail_levels+1)) on the triangle
// that is reached with tail_levels to go.
constexpr unsigned local_bits = tail_levels + 3;
constexpr std::int64_t local_side = std::int64_t{1} << local_bits;
constexpr unsigned local_shift = Fixed64::fraction_bits - local_bits;

/// The digits of the last `levels` steps for every local point and both flips.
class Tail {
 public:
  explicit Tail(Level levels) : digits_(4 * (local_side + 1) * (local_side + 1)) {
    for (int flips = 0; flips < 4; ++flips)
      for (std::int64_t v = 0; v <= local_side; ++v)
        for (std::int64_t u = 0; u + v <= local_side; ++u) {
          const auto at = [](std::int64_t k) { return Fixed64::dyadic(k, local_bits); };
          Step s{at(u), at(v), at(local_side - u - v), 0, (flips & 1) != 0, (flips & 2) != 0};
          for (Level depth = 0; depth < levels; ++depth) s = next_step<Reading::printed>(s);
          digits_[offset(static_cast<std::size_t>(flips), v) + static_cast<std::size_t>(u)] =
              static_cast<std::uint8_t>(s.index);
        }
  }

  /// The table's line for these flips and this v; its entries go by local u.
  static std::size_t offset(std::size_t flips, std::int64_t v) {
    return (flips * (local_side + 1) + static_cast<std::size_t>(v)) * (local_side + 1);
  }
  static std::size_t flips_of(bool mid, bool top) { return (mid ? 1u : 0u) + (top ? 2u : 0u); }
  std::uint32_t at(std::size_t flips, std::int64_t u, std::int64_t v) const {
    return digits_[offset(flips, v) + static_cast<std::size_t>(u)];
  }

 private:
  std::vector<std::uint8_t> digits_;
};

const Tail& tail(Level levels) {
  static const std::array<Tail, tail_levels + 1> tails{Tail(0), Tail(1), Tail(2), Tail(3), Tail(4)};
  return tails[levels];
}

/// The arguments of `step` at a point a whole number of spacings along the segment.
Step between(const Step& a, const Step& b, std::int64_t t, std::int64_t last) {
  const auto along = [&](const Fixed64& from, const Fixed64& to) {
    return Fixed64::from_raw(from.raw() + (to.raw() - from.raw()) / last * t);
  };
  return {along(a.u, b.u), along(a.v, b.v), along(a.w, b.w), a.index, a.mid_flip, a.top_flip};
}

void finish(const Step& a, const Step& b, Level levels, std::span<std::uint32_t> out) {
  const Tail& digits = tail(levels);
  const std::size_t flips = Tail::flips_of(a.mid_flip, a.top_flip);
  const std::uint32_t prefix = a.index << (2 * levels);
  const auto last = static_cast<std::int64_t>(out.size()) - 1;
  std::int64_t u = a.u.raw() >> local_shift, v = a.v.raw() >> local_shift;
  const std::int64_t du = last == 0 ? 0 : (b.u.raw() - a.u.raw()) / last >> local_shift;
  const std::int64_t dv = last == 0 ? 0 : (b.v.raw() - a.v.raw()) / last >> local_shift;
  for (std::uint32_t& index : out) {
    index = prefix | digits.at(flips, u, v);
    u += du;
    v += dv;
  }
}

/// The last spacing before a coordinate crosses 1/2, the only places where next_step changes its mind.
/// Domain: the ends take different branches, so one coordinate reaches or leaves 1/2 between them; last > 0.
std::int64_t crossing(const Step& a, const Step& b, std::int64_t last) {
  constexpr std::int64_t half = std::int64_t{1} << (Fixed64::fraction_bits - 1);
  for (const auto& [from, to] :
       {std::pair{a.w.raw(), b.w.raw()}, {a.v.raw(), b.v.raw()}, {a.u.raw(), b.u.raw()}}) {
    if ((from < half) == (to < half) && (from > half) == (to > half)) continue;
    const std::int64_t t = (half - from) / ((to - from) / last);
    return std::clamp<std::int64_t>(from < half && from + t * ((to - from) / last) == half ? t - 1 : t, 0,
                                    last - 1);
  }
  return (last - 1) / 2;
}

void descend(Step a, Step b, Level depth, Level n, std::span<std::uint32_t> out) {
  const Level stop = n < tail_levels ? 0 : n - tail_levels;
  for (; depth < stop; ++depth) {
    const Step to_a = next_step<Reading::printed>(a), to_b = next_step<Reading::printed>(b);
    if (to_a.index != to_b.index) {
      const auto last = static_cast<std::int64_t>(out.size()) - 1, split = crossing(a, b, last);
      const auto left = static_cast<std::size_t>(split) + 1;
      descend(a, between(a, b, split, last), depth, n, out.first(left));
      descend(between(a, b, split + 1, last), b, depth, n, out.subspan(left));
      return;
    }
    a = to_a;
    b = to_b;
  }
  finish(a, b, n - depth, out);
}

}  // namespace

void step_row(Level n, const GridPoint& first, const GridPoint& last, std::span<std::uint32_t> out) {
  descend(spec::index::first_step(first), spec::index::first_step(last), 0, n, out);
}

}  // namespace mmverify::proofs::index
