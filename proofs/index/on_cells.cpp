#include "proofs/index/on_cells.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>

namespace mmverify::proofs::index {
namespace {

// Large enough to spread the cost of a call, small enough for the cache.
constexpr std::uint64_t cells_per_chunk = 1 << 16;
constexpr std::uint64_t points_per_batch = 4096;

}  // namespace

std::string say_number(std::uint32_t answer) { return fmt::format("{}", answer); }

Simplicity simplicity(const GridPoint& p) {
  const auto u = static_cast<std::uint64_t>(p.u.raw()), v = static_cast<std::uint64_t>(p.v.raw());
  const int zeros = std::min<int>(std::countr_zero(u | v), Fixed64::fraction_bits);
  return {static_cast<std::uint64_t>(static_cast<int>(Fixed64::fraction_bits) - zeros), v, u};
}

Counterexample at_point(const GridPoint& p, Level grid, std::string expected, std::string got) {
  const RationalPoint q = rational(p);
  return {simplicity(p), grid, case_text(q, grid), hex_text(q), std::move(expected), std::move(got)};
}

Tally compare_on_cells(const IndexSubject& subject, Level grid, const Run& run, const Answers& expected,
                       const Answers& got, const Say& say_expected) {
  const Cells cells(grid);
  // A rounding subject may receive points that are no longer evenly spaced.
  const bool rows = subject.arithmetic() != Arithmetic::binary16;
  return sweep(run, cells.size(), cells_per_chunk, [&](Chunk chunk, Tally& tally) {
    std::array<GridPoint, points_per_batch> points;
    std::array<std::uint32_t, points_per_batch> want, have;
    cells.rows(chunk.begin, chunk.end, [&](const Row& whole_row) {
      for (std::uint64_t from = 0; from < whole_row.count; from += points_per_batch) {
        const Row row = Cells::cut(whole_row, from, std::min(points_per_batch, whole_row.count - from));
        for (std::uint64_t t = 0; t < row.count; ++t) points[t] = representative(row, t, grid);
        const std::span<GridPoint> batch(points.data(), row.count);
        subject.receive(batch);
        expected({batch, rows}, {want.data(), row.count});
        got({batch, rows}, {have.data(), row.count});

        for (const Kind kind : {Kind::vertex, Kind::edge, Kind::interior})
          if (kind == row.even || kind == row.odd) tally.count(kind, row.count_of(kind));
        Tally sum;
        std::uint32_t different = 0;
        for (std::uint64_t t = 0; t < row.count; ++t) {
          sum.digest(row.first + t, have[t]);
          different |= want[t] ^ have[t];
        }
        tally.digest_sum(sum.digest());
        if (different == 0) continue;
        for (std::uint64_t t = 0; t < row.count; ++t)
          if (want[t] != have[t])
            tally.mismatch(row.kind(t), simplicity(points[t]), [&] {
              return at_point(points[t], grid, say_expected(want[t]), say_number(have[t]));
            });
      }
    });
  });
}

}  // namespace mmverify::proofs::index
