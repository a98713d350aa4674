// An implementation of topic index in the dock, and what it may be asked.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <span>

#include "proofs/engine/law.hpp"
#include "proofs/entries.hpp"
#include "proofs/index/cells.hpp"
#include "proofs/index/point.hpp"

namespace mmverify::proofs::index {

using spec::index::Corners;

/// The numbers a subject computes in.  An exact one is decided on all points by its answers on the cells.
enum class Arithmetic { exact, binary16, binary32, binary64 };

std::string to_string(Arithmetic a);

/// Entry points that a subject may have.
#define MMVERIFY_INDEX_ENTRIES(ROW)           \
  ROW(index, "barycentrics -> index")         \
  ROW(corners, "index -> corners")            \
  ROW(row_index, "barycentrics -> row order") \
  ROW(row_corners, "row order -> corners")    \
  ROW(wide_index, "barycentrics -> 64-bit index")
MMVERIFY_ENTRIES(MMVERIFY_INDEX_ENTRIES)

/// Points on one level's grid.  `row`: equally spaced in u, all with the same v.
struct Batch {
  std::span<const GridPoint> points;
  bool row = false;
};

/// Pairs of binary32 numbers.
struct FloatBatch {
  std::span<const float> u, v;
};

/// Pairs of binary64 numbers.
struct DoubleBatch {
  std::span<const double> u, v;
};

/// Every call is const and may come from several threads at once.  Answers go to `out`, as long as the input.
class IndexSubject : public Subject {
 public:
  IndexSubject(std::string name, std::string about, Arithmetic arithmetic, Level max_level)
      : Subject("index", std::move(name), std::move(about)), arithmetic_(arithmetic), max_level_(max_level) {}

  Arithmetic arithmetic() const { return arithmetic_; }
  bool exact() const override { return arithmetic_ == Arithmetic::exact; }
  /// Whether binary64 numbers reach it as they are.
  bool takes_doubles() const { return exact() || arithmetic_ == Arithmetic::binary64; }
  Level max_level() const { return max_level_; }

  virtual bool has(Entry e) const = 0;

  /// Points that it likes to be asked at once: one row, cut at row_batch, or more, gathered from many rows.
  virtual std::size_t batch() const { return row_batch; }
  static constexpr std::size_t row_batch = 4096;

  /// Points as the subject's arithmetic receives them: rounded to its numbers, once.
  virtual void receive(std::span<GridPoint>) const {}
  virtual void receive(std::span<float> /*u*/, std::span<float> /*v*/) const {}
  virtual RationalPoint receive(const RationalPoint& p) const { return p; }

  /// Barycentrics -> index.
  virtual void index(Level n, Batch batch, std::span<std::uint32_t> out) const;
  virtual void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const;
  /// Domain: takes_doubles().  Here each pair by itself, as a point.
  virtual void index(Level n, DoubleBatch batch, std::span<std::uint32_t> out) const;
  /// The representatives of rows of `grid`, one row after the other.  Domain: receive() leaves them alone.
  virtual void index_rows(Level n, Level grid, std::span<const Row> rows, std::span<std::uint32_t> out) const;
  /// One point; an exact subject takes any rational, another one a point it can receive.
  virtual std::uint32_t index(Level n, const RationalPoint& p) const;

  /// Index -> corners.
  virtual void corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const;

  /// The same two in row order.
  virtual void row_index(Level n, Batch batch, std::span<std::uint32_t> out) const;
  virtual void row_index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const;
  virtual std::uint32_t row_index(Level n, const RationalPoint& p) const;
  virtual void row_corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const;

  /// Barycentrics -> index in 64-bit words, for levels beyond 16: on the representatives of a row of level n,
  /// and on one point that the subject can receive.
  virtual Level max_wide_level() const { return 0; }
  virtual void wide_index(Level n, const Row& row, std::span<std::uint64_t> out) const;
  virtual std::uint64_t wide_index(Level n, const RationalPoint& p) const;

 private:
  Arithmetic arithmetic_;
  Level max_level_;
};

/// The built-in subjects: name, what it is, its arithmetic.
const std::vector<std::shared_ptr<const IndexSubject>>& built_in_subjects();

/// Null where there is no built-in subject of this name.
std::shared_ptr<const IndexSubject> built_in_subject(const std::string& name);

}  // namespace mmverify::proofs::index
