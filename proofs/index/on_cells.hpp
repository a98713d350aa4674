// Sweeping the cells of a grid in batches of points.
#pragma once

#include <functional>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// Fills `out` with one answer a point of the batch.
using Answers = std::function<void(Batch, std::span<std::uint32_t>)>;

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
