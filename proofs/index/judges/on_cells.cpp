#include "proofs/index/judges/on_cells.hpp"

#include <cmath>

#include "proofs/index/grid/reference_sweep.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/options.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::index {
namespace {

// Large enough to spread the cost of a call, small enough for the cache.
constexpr std::uint64_t cells_per_chunk = 1 << 16;

/// Cells of one row or, for a subject that likes many at once, of many; judged when full.
class Comparison {
 public:
  Comparison(const IndexSubject& subject, Level grid, const Answers& expected, const Answers& got,
             const Say& say_expected, std::uint32_t near, Tally& tally)
      : subject_(subject),
        grid_(grid),
        expected_(expected),
        got_(got),
        say_expected_(say_expected),
        near_(near),
        tally_(tally),
        as_they_are_(subject.functions.arithmetic != Arithmetic::binary16) {}

  void add(const Row& whole_row) {
    for (std::uint64_t from = 0; from < whole_row.count;) {
      const std::uint64_t room = std::min<std::uint64_t>(subject_.functions.batch - cells_, row_batch);
      const Row row = Cells::cut(whole_row, from, std::min(room, whole_row.count - from));
      rows_.push_back(row);
      cells_ += row.count;
      from += row.count;
      if (subject_.functions.batch == row_batch || cells_ == subject_.functions.batch) judge();
    }
  }

  void judge() {
    if (rows_.empty()) return;
    // Kept from chunk to chunk: fresh pages would cost more than the comparison.
    thread_local std::vector<std::uint32_t> answers;
    answers.resize(std::max<std::size_t>(answers.size(), cells_));
    const std::span<std::uint32_t> have(answers.data(), cells_);
    if (as_they_are_ && got_.on_rows)
      got_.on_rows(rows_, have);
    else
      got_.on_points(received(rows_), have);
    std::size_t first = 0;
    for (const Row& row : rows_) {
      want_.resize(row.count);
      if (as_they_are_ && expected_.on_rows)
        expected_.on_rows({&row, 1}, want_);
      else
        expected_.on_points(received({&row, 1}), want_);
      judge(row, have.subspan(first, row.count));
      first += row.count;
    }
    rows_.clear();
    cells_ = 0;
  }

 private:
  /// The rows' points as the subject receives them.
  Batch received(std::span<const Row> rows) {
    points_.clear();
    for (const Row& row : rows)
      for (std::uint64_t t = 0; t < row.count; ++t) points_.push_back(representative(row, t, grid_));
    subject_.functions.receive(points_);
    // A rounding subject may have received points that are no longer evenly spaced.
    return {points_, rows.size() == 1 && as_they_are_};
  }

  void judge(const Row& row, std::span<const std::uint32_t> have) {
    for (const Kind kind : {Kind::vertex, Kind::edge, Kind::interior})
      if (kind == row.even || kind == row.odd) tally_.count(kind, row.count_of(kind));
    const Agreement agreement = agreement_of<std::uint32_t>(row.first, want_, have);
    tally_.digest_sum(agreement.digest);
    if (agreement.all) return;
    for (std::uint64_t t = 0; t < row.count; ++t) {
      if (want_[t] == have[t]) continue;
      GridPoint p = representative(row, t, grid_);
      subject_.functions.receive({&p, 1});
      if (near_ != 0 && reaches(rational(p), grid_, have[t], subject_.functions.arithmetic, near_)) {
        tally_.allow(row.kind(t));
        continue;
      }
      tally_.mismatch(row.kind(t), simplicity(p),
                      [&] { return at_point(p, grid_, say_expected_(want_[t]), say_number(have[t])); });
    }
  }

  const IndexSubject& subject_;
  Level grid_;
  const Answers &expected_, &got_;
  const Say& say_expected_;
  const std::uint32_t near_;  ///< Run::near: of laws whose answers on `grid` are indices of its level
  Tally& tally_;
  const bool as_they_are_;  ///< whether the subject receives the representatives themselves
  std::vector<Row> rows_;
  std::uint64_t cells_ = 0;
  std::vector<GridPoint> points_;
  std::vector<std::uint32_t> want_;
};

/// The unit in the last place of the arithmetic's numbers at x.
Rational ulp(const Rational& x, Arithmetic arithmetic) {
  struct Format {
    int bits, least_exponent;
  };
  Format format{};
  switch (arithmetic) {
    case Arithmetic::exact: return Rational(spec::Integer(0));
    case Arithmetic::binary16: format = {11, -24}; break;
    case Arithmetic::binary32: format = {24, -149}; break;
    case Arithmetic::binary64: format = {53, -1074}; break;
  }
  int exponent = format.least_exponent;
  if (const double value = nearest(x); value != 0) std::frexp(value, &exponent);
  return rational(std::ldexp(1.0, std::max(exponent - format.bits, format.least_exponent)));
}

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
  const std::uint64_t chunk_size = std::max<std::uint64_t>(cells_per_chunk, subject.functions.batch);
  return sweep(
      run, cells.size(), chunk_size,
      [&](Chunk chunk, Tally& tally) {
        Comparison comparison(subject, grid, expected, got, say_expected, run.near, tally);
        cells.rows(chunk.begin, chunk.end, [&](const Row& row) {
          if (!has(run.options, interiors_only) || row.even == Kind::interior) comparison.add(row);
        });
        comparison.judge();
      },
      [&](std::uint64_t cell, Tally& tally) {
        cells.rows(cell, cell + 1, [&](const Row& row) {
          if (!has(run.options, interiors_only) || row.even == Kind::interior) tally.decline(row.even);
        });
      });
}

bool reaches(const RationalPoint& p, Level n, std::uint32_t index, Arithmetic arithmetic,
             std::uint32_t ulps) {
  if (index >= triangle_count(n)) return false;
  const auto number = [](std::uint64_t x) { return Rational(spec::Integer(x)); };
  const Rational N = number(side(n)), reach = number(ulps);
  const Rational du = reach * ulp(p.u, arithmetic) * N, dv = reach * ulp(p.v, arithmetic) * N, u = p.u * N,
                 v = p.v * N;
  const MicroTriangle m = triangle_of(spec::index::corners(index, n), n).value();
  const Rational left = number(m.i), right = number(std::uint64_t{m.i} + 1), low = number(m.j),
                 high = number(std::uint64_t{m.j} + 1), diagonal = number(std::uint64_t{m.i} + m.j + 1);
  // The box of all points in reach against the unit square, and its corner next to the diagonal against that.
  if (u + du < left || u - du > right || v + dv < low || v - dv > high) return false;
  return m.inverted ? std::min(right, u + du) + std::min(high, v + dv) >= diagonal
                    : std::max(left, u - du) + std::max(low, v - dv) <= diagonal;
}

}  // namespace mmverify::proofs::index
