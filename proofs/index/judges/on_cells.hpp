// Sweeping the cells of a grid in batches of points.
#pragma once

#include <concepts>
#include <functional>
#include <utility>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

using points::simplicity;

/// Who answers, one number a point: on points of any kind, and where it can, on rows of a grid as they are.
struct Answers {
  using OnPoints = std::function<void(Batch, std::span<std::uint32_t>)>;
  using OnRows = std::function<void(std::span<const Row>, std::span<std::uint32_t>)>;

  template <class F>
  requires std::invocable<F, Batch, std::span<std::uint32_t>> Answers(
      F points, OnRows rows = {})  // NOLINT: a function that answers on points is one that answers
      : on_points(std::move(points)), on_rows(std::move(rows)) {}

  OnPoints on_points;
  OnRows on_rows;
};

/// The number as a counterexample prints it.
using Say = std::function<std::string(std::uint32_t)>;
std::string say_number(std::uint32_t answer);

/// Compares two answers on every cell of `grid`, on the points as `subject` receives them.
/// The digest is taken over `got`.
Tally compare_on_cells(const IndexSubject& subject, Level grid, const Run& run, const Answers& expected,
                       const Answers& got, const Say& say_expected = say_number);

/// The counterexample for a grid point.
Counterexample at_point(const GridPoint& p, Level grid, std::string expected, std::string got);

/// log2 of the common denominator, then v, then u.
Simplicity simplicity(const GridPoint& p);

}  // namespace mmverify::proofs::index
