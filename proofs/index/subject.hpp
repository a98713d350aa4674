// An implementation of topic index in the dock, and what it may be asked, a function each.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"
#include "proofs/points/cells.hpp"
#include "proofs/points/point.hpp"

namespace mmverify::proofs::index {

// Subjects are judged at points of a level's grid and at floats.
using namespace points;

using spec::index::Corners;

/// The numbers a subject computes in.  An exact one is decided on all points by its answers on the cells.
enum class Arithmetic { exact, binary16, binary32, binary64 };

std::string to_string(Arithmetic a);

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

/// A row is cut at so many points.
inline constexpr std::size_t row_batch = 4096;

/// In which order corners come: as the children 0, 2 and 3 touch them, or the base and a step from there along u and
/// along v.
enum class CornerOrder { undeclared, of_children, base_u_v };

/// What a subject has; an empty function is an entry point that is missing, unless it says what stands in for it.
/// Calls may come from several threads at once.  Answers go to `out`, as long as the input.
struct Functions {
  Arithmetic arithmetic = Arithmetic::exact;
  Level max_level = 16;
  /// Points that it likes to be asked at once: one row, cut at row_batch, or more, gathered from many rows.
  std::size_t batch = row_batch;

  // Points as the subject's arithmetic receives them: rounded to its numbers, once.  Empty: as they are.
  std::function<void(std::span<GridPoint>)> receive = {};
  std::function<void(std::span<float> u, std::span<float> v)> receive_floats = {};
  std::function<RationalPoint(const RationalPoint& p)> receive_at = {};

  /// Barycentrics -> index.  Empty: by index_at, point by point.
  std::function<void(Level n, Batch batch, std::span<std::uint32_t> out)> index = {};
  std::function<void(Level n, FloatBatch batch, std::span<std::uint32_t> out)> index_floats = {};
  /// Domain: takes_doubles().  Empty: by index_at.
  std::function<void(Level n, DoubleBatch batch, std::span<std::uint32_t> out)> index_doubles = {};
  /// The representatives of rows of `grid`, one row after the other.  Domain: receive leaves them alone.  Empty:
  /// by index, row by row.
  std::function<void(Level n, Level grid, std::span<const Row> rows, std::span<std::uint32_t> out)>
      index_rows = {};
  /// One point; an exact subject takes any rational, another one a point it can receive.
  std::function<std::uint32_t(Level n, const RationalPoint& p)> index_at = {};
  /// The same on Boost.Rational alone, where index_at runs on our own rationals of 63 bits.  Empty: by index_at.
  std::function<std::uint32_t(Level n, const RationalPoint& p)> index_on_boost = {};

  CornerOrder corner_order = CornerOrder::undeclared;
  /// Index -> corners.
  std::function<void(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out)> corners = {};

  // The same two in row order.
  std::function<void(Level n, Batch batch, std::span<std::uint32_t> out)> row_index = {};
  std::function<void(Level n, FloatBatch batch, std::span<std::uint32_t> out)> row_index_floats = {};
  std::function<std::uint32_t(Level n, const RationalPoint& p)> row_index_at = {};
  std::function<void(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out)> row_corners =
      {};

  /// Barycentrics -> index in 64-bit words, for levels beyond 16: on the representatives of a row of level n,
  /// and on one point that the subject can receive.
  Level max_wide_level = 0;
  std::function<void(Level n, const Row& row, std::span<std::uint64_t> out)> wide_index = {};
  std::function<std::uint64_t(Level n, const RationalPoint& p)> wide_index_at = {};
};

/// What a law may need of a subject, as messages call it.
struct Entry {
  const char* name;
  bool (*there)(const Functions&);
};
namespace entry {
inline constexpr Entry index{"barycentrics -> index", [](const Functions& f) { return bool{f.index}; }};
inline constexpr Entry corners{"index -> corners", [](const Functions& f) { return bool{f.corners}; }};
inline constexpr Entry row_index{"barycentrics -> row order",
                                 [](const Functions& f) { return bool{f.row_index}; }};
inline constexpr Entry row_corners{"row order -> corners",
                                   [](const Functions& f) { return bool{f.row_corners}; }};
inline constexpr Entry wide_index{"barycentrics -> 64-bit index",
                                  [](const Functions& f) { return f.wide_index && f.wide_index_at; }};
}  // namespace entry

class IndexSubject : public Subject {
 public:
  IndexSubject(std::string name, std::string about, Functions functions, std::string fingerprint = {});

  bool exact() const override { return functions.arithmetic == Arithmetic::exact; }
  std::string fingerprint() const override { return fingerprint_; }
  /// Whether binary64 numbers reach it as they are.
  bool takes_doubles() const { return exact() || functions.arithmetic == Arithmetic::binary64; }

  const Functions functions;  ///< with what stands in for empty ones

 private:
  std::string fingerprint_;
};
using IndexSubjectPtr = std::shared_ptr<const IndexSubject>;

/// The built-in subjects: name, what it is, its arithmetic.
const std::vector<IndexSubjectPtr>& built_in_subjects();

/// The built-in subject of that name.  Domain: there is one.
IndexSubjectPtr built_in(const std::string& name);

}  // namespace mmverify::proofs::index
