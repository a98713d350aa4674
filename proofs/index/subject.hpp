// A subject of topic index: an implementation as functions, built in or in the dock.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "proofs/engine/topic.hpp"
#include "proofs/index/points.hpp"

namespace mmverify::proofs::index {

using spec::index::Corners;

/// The numbers that a subject computes in.  The answers of an exact one on the cells decide all points.
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

/// The most points of a row in one batch.
inline constexpr std::size_t row_batch = 4096;

/// The order of corners: as the children 0, 2 and 3 touch them, or the base, then a step from there along u and one
/// along v.
enum class CornerOrder { undeclared, of_children, base_u_v };

/// The entry points of a subject; an empty function is a missing entry point, unless a comment names its replacement.
/// Several threads may call at once.  Answers go to `out`, which is as long as the input.
struct Functions {
  static constexpr char topic[] = "index";
  Arithmetic arithmetic = Arithmetic::exact;
  Level max_level = 16;
  /// The preferred number of points in a batch: one row, cut at row_batch, or more, gathered from many rows.
  std::size_t batch = row_batch;

  // Points as the subject's arithmetic receives them: rounded to its numbers, once.  Empty: unchanged.
  std::function<void(std::span<GridPoint>)> receive = {};
  std::function<void(std::span<float> u, std::span<float> v)> receive_floats = {};
  std::function<RationalPoint(const RationalPoint& p)> receive_at = {};

  /// Barycentrics -> index.  Empty: index_at, point by point.
  std::function<void(Level n, Batch batch, std::span<std::uint32_t> out)> index = {};
  std::function<void(Level n, FloatBatch batch, std::span<std::uint32_t> out)> index_floats = {};
  /// Domain: takes_doubles().  Empty: index_at.
  std::function<void(Level n, DoubleBatch batch, std::span<std::uint32_t> out)> index_doubles = {};
  /// The indices of the representatives of rows of `grid`, one row after the other.  Domain: receive leaves them
  /// unchanged.  Empty: index, row by row.
  std::function<void(Level n, Level grid, std::span<const Row> rows, std::span<std::uint32_t> out)>
      index_rows = {};
  /// The index of one point; an exact subject takes any rational, any other one a point that it can receive.
  std::function<std::uint32_t(Level n, const RationalPoint& p)> index_at = {};
  /// The index on Boost.Rational only, while index_at runs on our own rationals of 63 bits.  Empty: index_at.
  std::function<std::uint32_t(Level n, const RationalPoint& p)> index_on_boost = {};

  CornerOrder corner_order = CornerOrder::undeclared;
  /// Index -> corners.
  std::function<void(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out)> corners = {};

  // Index and corners in row order.
  std::function<void(Level n, Batch batch, std::span<std::uint32_t> out)> row_index = {};
  std::function<void(Level n, FloatBatch batch, std::span<std::uint32_t> out)> row_index_floats = {};
  std::function<std::uint32_t(Level n, const RationalPoint& p)> row_index_at = {};
  std::function<void(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out)> row_corners =
      {};

  /// Barycentrics -> index in 64-bit words, for levels beyond 16: on the representatives of a row of level n, and on
  /// one point that the subject can receive.
  Level max_wide_level = 0;
  std::function<void(Level n, const Row& row, std::span<std::uint64_t> out)> wide_index = {};
  std::function<std::uint64_t(Level n, const RationalPoint& p)> wide_index_at = {};

  bool exact_answers() const { return arithmetic == Arithmetic::exact; }
};

using Entry = EntryOf<Functions>;
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

class IndexSubject : public SubjectOf<Functions> {
 public:
  /// Each empty function that has a replacement gets it.
  IndexSubject(std::string name, std::string about, Functions functions, std::string fingerprint = {});
  /// Whether binary64 numbers reach it unrounded.
  bool takes_doubles() const { return exact() || functions.arithmetic == Arithmetic::binary64; }
};
using IndexSubjectPtr = std::shared_ptr<const IndexSubject>;

/// The built-in subjects: name, description, arithmetic.
const std::vector<IndexSubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;

/// The subjects that a library offers, none where it has no entry point of this topic: one that takes
/// binary32 numbers, named as the file, and where it has an entry point for binary64 another, named FILE:f64.
/// Each runs in worker processes; what goes wrong there comes out of the calls as SubjectBroken.
std::vector<IndexSubjectPtr> plugin_subjects(const dock::LibraryPtr& library);

IndexSubjectPtr impl_subject();
std::vector<IndexSubjectPtr> row_subjects();

/// A subject that gives one answer to every question, an index or three corners "(I,J) (I,J) (I,J)".  It judges and
/// draws again an answer of a program on a pipe.  Throws BadCase.
IndexSubjectPtr given_answer(const std::string& answer);

}  // namespace mmverify::proofs::index
