#include <algorithm>
#include <array>
#include <vector>

#include "proofs/index/grid/reference_sweep.hpp"

namespace mmverify::proofs::index {
namespace {

using spec::index::next_step;
using spec::index::Reading;
using Step = spec::index::Step<Fixed64>;

// Six levels in the table: 4^6 digits fit 16 bits, and its 2.1 MB are near enough. Measured at level 13, one
// thread: four levels 162 million cells a second, five 265, six 375.
constexpr Level tail_levels = 6;
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
              static_cast<std::uint16_t>(s.index);
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
  std::vector<std::uint16_t> digits_;
};

const Tail& tail(Level levels) {
  static const std::array<Tail, tail_levels + 1> tails{Tail(0), Tail(1), Tail(2), Tail(3),
                                                       Tail(4), Tail(5), Tail(6)};
  return tails[levels];
}

/// From one point of a segment to the next, in the coordinates of the triangle that both are on.
struct Spacing {
  std::int64_t u, v, w;
};

/// The arguments of `step` so many spacings on.
Step along(const Step& a, const Spacing& d, std::int64_t t) {
  return {Fixed64::from_raw(a.u.raw() + d.u * t),
          Fixed64::from_raw(a.v.raw() + d.v * t),
          Fixed64::from_raw(a.w.raw() + d.w * t),
          a.index,
          a.mid_flip,
          a.top_flip};
}

void finish(const Step& a, const Spacing& d, Level levels, std::span<std::uint32_t> out) {
  const Tail& digits = tail(levels);
  const std::size_t flips = Tail::flips_of(a.mid_flip, a.top_flip);
  const std::uint32_t prefix = a.index << (2 * levels);
  std::int64_t u = a.u.raw() >> local_shift, v = a.v.raw() >> local_shift;
  const std::int64_t du = d.u >> local_shift, dv = d.v >> local_shift;
  for (std::uint32_t& index : out) {
    index = prefix | digits.at(flips, u, v);
    u += du;
    v += dv;
  }
}

/// The last spacing before a coordinate crosses 1/2, the only places where next_step changes its mind.
/// Domain: the ends a and b take different branches, so one coordinate reaches or leaves 1/2 between them.
std::int64_t crossing(const Step& a, const Step& b, const Spacing& d, std::int64_t last) {
  constexpr std::int64_t half = std::int64_t{1} << (Fixed64::fraction_bits - 1);
  const std::int64_t from[] = {a.w.raw(), a.v.raw(), a.u.raw()}, to[] = {b.w.raw(), b.v.raw(), b.u.raw()},
                     by[] = {d.w, d.v, d.u};
  for (std::size_t k = 0; k < 3; ++k) {
    if ((from[k] < half) == (to[k] < half) && (from[k] > half) == (to[k] > half)) continue;
    const std::int64_t t = (half - from[k]) / by[k];
    return std::clamp<std::int64_t>(from[k] < half && from[k] + t * by[k] == half ? t - 1 : t, 0, last - 1);
  }
  return (last - 1) / 2;
}

void descend(Step a, Spacing d, Level depth, Level n, std::span<std::uint32_t> out) {
  const Level stop = n < tail_levels ? 0 : n - tail_levels;
  const auto last = static_cast<std::int64_t>(out.size()) - 1;
  for (; depth < stop; ++depth) {
    const Step b = along(a, d, last);
    const Step to_a = next_step<Reading::printed>(a);
    if (last > 0) {
      if (to_a.index != next_step<Reading::printed>(b).index) {
        const std::int64_t split = crossing(a, b, d, last);
        const auto left = static_cast<std::size_t>(split) + 1;
        descend(a, d, depth, n, out.first(left));
        descend(along(a, d, split + 1), d, depth, n, out.subspan(left));
        return;
      }
      // The branch is the same all along, so it is the next point's too: the images' spacing.
      const Step to_next = next_step<Reading::printed>(along(a, d, 1));
      d = {to_next.u.raw() - to_a.u.raw(), to_next.v.raw() - to_a.v.raw(), to_next.w.raw() - to_a.w.raw()};
    }
    a = to_a;
  }
  finish(a, d, n - depth, out);
}

}  // namespace

void step_row(Level n, const GridPoint& first, const GridPoint& last, std::span<std::uint32_t> out) {
  const Step a = spec::index::first_step(first), b = spec::index::first_step(last);
  const auto steps = static_cast<std::int64_t>(std::max<std::size_t>(out.size(), 2) - 1);
  descend(a,
          {(b.u.raw() - a.u.raw()) / steps, (b.v.raw() - a.v.raw()) / steps, (b.w.raw() - a.w.raw()) / steps},
          0, n, out);
}

}  // namespace mmverify::proofs::index
