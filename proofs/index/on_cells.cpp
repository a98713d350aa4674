#include "proofs/index/on_cells.hpp"

#include <fmt/format.h>

#include <bit>
#include <vector>

namespace mmverify::proofs::index {
namespace {

// Large enough to spread the cost of a call, small enough for the cache.
constexpr std::uint64_t cells_per_chunk = 1 << 16;

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

namespace {

/// Points of one row or, for a subject that likes many at once, of many; judged when full.
class Comparison {
 public:
  Comparison(const IndexSubject& subject, Level grid, const Answers& expected, const Answers& got,
             const Say& say_expected, Tally& tally)
      : subject_(subject),
        grid_(grid),
        expected_(expected),
        got_(got),
        say_expected_(say_expected),
        tally_(tally) {
    points_.reserve(subject.batch());
  }

  void add(const Row& whole_row) {
    for (std::uint64_t from = 0; from < whole_row.count;) {
      const std::uint64_t room = subject_.batch() - points_.size();
      const Row row = Cells::cut(whole_row, from, std::min(room, whole_row.count - from));
      rows_.push_back(row);
      for (std::uint64_t t = 0; t < row.count; ++t) points_.push_back(representative(row, t, grid_));
      from += row.count;
      if (subject_.batch() == IndexSubject::row_batch || points_.size() == subject_.batch()) judge();
    }
  }

  void judge() {
    if (rows_.empty()) return;
    subject_.receive(points_);
    want_.resize(points_.size());
    have_.resize(points_.size());
    // A rounding subject may have received points that are no longer evenly spaced.
    const Batch batch{points_, rows_.size() == 1 && subject_.arithmetic() != Arithmetic::binary16};
    got_(batch, have_);
    expected_(batch, want_);
    std::size_t first = 0;
    for (const Row& row : rows_) {
      judge(row, first);
      first += row.count;
    }
    rows_.clear();
    points_.clear();
  }

 private:
  void judge(const Row& row, std::size_t first) {
    for (const Kind kind : {Kind::vertex, Kind::edge, Kind::interior})
      if (kind == row.even || kind == row.odd) tally_.count(kind, row.count_of(kind));
    const std::uint32_t *want = want_.data() + first, *have = have_.data() + first;
    std::uint64_t digest = 0;
    std::uint32_t different = 0;
    for (std::uint64_t t = 0; t < row.count; ++t) {
      digest += Tally::digest_of(row.first + t, have[t]);
      different |= want[t] ^ have[t];
    }
    tally_.digest_sum(digest);
    if (different == 0) return;
    for (std::uint64_t t = 0; t < row.count; ++t) {
      if (want[t] == have[t]) continue;
      const GridPoint& p = points_[first + t];
      tally_.mismatch(row.kind(t), simplicity(p),
                      [&] { return at_point(p, grid_, say_expected_(want[t]), say_number(have[t])); });
    }
  }

  const IndexSubject& subject_;
  Level grid_;
  const Answers &expected_, &got_;
  const Say& say_expected_;
  Tally& tally_;
  std::vector<Row> rows_;
  std::vector<GridPoint> points_;
  std::vector<std::uint32_t> want_, have_;
};

}  // namespace

Tally compare_on_cells(const IndexSubject& subject, Level grid, const Run& run, const Answers& expected,
                       const Answers& got, const Say& say_expected) {
  const Cells cells(grid);
  const std::uint64_t chunk_size = std::max<std::uint64_t>(cells_per_chunk, subject.batch());
  return sweep(run, cells.size(), chunk_size, [&](Chunk chunk, Tally& tally) {
    Comparison comparison(subject, grid, expected, got, say_expected, tally);
    cells.rows(chunk.begin, chunk.end, [&](const Row& row) {
      if (!run.interiors_only || row.even == Kind::interior) comparison.add(row);
    });
    comparison.judge();
  });
}

}  // namespace mmverify::proofs::index
