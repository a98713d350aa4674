// Every pair of binary16 numbers in the triangle: a float format small enough to be run whole.
#include "proofs/index/grid/reference_sweep.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/index/subjects/rounded_subject.hpp"

namespace mmverify::proofs::index {
namespace {

// 0x3C00 encodes 1: there are 0x3C01 encodings from +0 to 1, in the order of their values.
constexpr std::uint32_t one = 0x3C00;
constexpr std::uint64_t rows_per_chunk = 16;

float value(std::uint32_t bits) {
  return static_cast<float>(impl::Binary16::from_bits(static_cast<std::uint16_t>(bits)));
}

Fixed64 fixed(float x) {
  return Fixed64::from_raw(
      static_cast<std::int64_t>(std::ldexp(x, static_cast<int>(Fixed64::fraction_bits))));
}

/// Encodings of the v that lie in the triangle beside this u: 0 to the greatest with u+v <= 1.
std::uint32_t partners(std::uint32_t u_bits) {
  const double room = 1.0 - static_cast<double>(value(u_bits));  // exact: both are multiples of 2^-24
  std::uint32_t low = 0, high = one + 1;
  while (high - low > 1) {
    const std::uint32_t middle = (low + high) / 2;
    (static_cast<double>(value(middle)) <= room ? low : high) = middle;
  }
  return low + 1;
}

Kind kind_at(const GridPoint& p, Level n) {
  const Fixed64 u = times(side(n), p.u), v = times(side(n), p.v), zero(0);
  const Fixed64 uf = u - Fixed64(whole(u)), vf = v - Fixed64(whole(v));
  if (uf == zero || vf == zero) return uf == zero && vf == zero ? Kind::vertex : Kind::edge;
  return uf + vf == Fixed64(1) ? Kind::edge : Kind::interior;
}

}  // namespace

Tally exact_on_binary16(const IndexSubject& s, Level n, const Run& run) {
  return sweep(
      run, one + 1, rows_per_chunk,
      [&](Chunk chunk, Tally& tally) {
        std::vector<float> u, v;
        std::vector<GridPoint> points;
        std::vector<std::uint32_t> want, got;
        for (auto row = static_cast<std::uint32_t>(chunk.begin); row < chunk.end; ++row) {
          const std::uint32_t count = partners(row);
          u.assign(count, value(row));
          v.resize(count);
          points.resize(count);
          want.resize(count);
          got.resize(count);
          for (std::uint32_t t = 0; t < count; ++t) {
            v[t] = value(t);
            points[t] = {fixed(u[t]), fixed(v[t])};
          }
          reference_batch(n, points, want);
          s.functions.index_floats(n, FloatBatch{u, v}, got);
          std::array<std::uint64_t, kinds> of_kind{};
          for (std::uint32_t t = 0; t < count; ++t) {
            const Kind kind = kind_at(points[t], n);
            ++of_kind[static_cast<std::size_t>(kind)];
            tally.digest(std::uint64_t{row} << 16 | t, got[t]);
            if (want[t] != got[t])
              tally.mismatch(kind, simplicity(points[t]),
                             [&] { return at_point(points[t], n, say_number(want[t]), say_number(got[t])); });
          }
          for (const Kind kind : {Kind::vertex, Kind::edge, Kind::interior})
            tally.count(kind, of_kind[static_cast<std::size_t>(kind)]);
        }
      },
      [n](std::uint64_t row, Tally& tally) {
        const auto u = static_cast<std::uint32_t>(row);
        for (std::uint32_t v = 0; v < partners(u); ++v)
          tally.decline(kind_at({fixed(value(u)), fixed(value(v))}, n));
      });
}

}  // namespace mmverify::proofs::index
