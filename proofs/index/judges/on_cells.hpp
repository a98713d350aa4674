// Sweeping the cells of a grid in batches of points.
#pragma once

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

/// Whether two lists of answers are the same, and the digest of the second.
struct Agreement {
  bool all = true;
  std::uint64_t digest = 0;
};

/// The cases are numbered from `first` on.  Domain: as many wanted as got.
template <class Word>
Agreement agreement_of(std::uint64_t first, std::span<const Word> want, std::span<const Word> got) {
  Agreement agreement;
  Word different = 0;
  for (std::size_t t = 0; t < got.size(); ++t) {
    agreement.digest += Tally::digest_of(first + t, got[t]);
    different |= want[t] ^ got[t];
  }
  agreement.all = different == 0;
  return agreement;
}

/// Whether a point of the closed micro-triangle with that index is at most `ulps` units in the last place from p along
/// u and along v, in the arithmetic's numbers; exact ones have no last place, and p itself is asked for.
/// Domain: n <= 16, coordinates that a double holds; an index of 4^n or more is no micro-triangle's: false.
bool reaches(const RationalPoint& p, Level n, std::uint32_t index, Arithmetic arithmetic, std::uint32_t ulps);

}  // namespace mmverify::proofs::index
