// Laws that say of a subject that it is wrong, and where: what a source claims and is not so, kept as a fact.
#pragma once

#include "proofs/index/judges/judges.hpp"

namespace mmverify::proofs::index {

/// The simplest point on which a wrong subject is wrong, from a level on.
struct Difference {
  Level from_level;
  std::int64_t ku, kv;          ///< the point (ku/4N, kv/4N) of from_level's grid
  std::uint32_t expected, got;  ///< the answers there at from_level
};

/// Holds at level n if the subject equals the reference on all cells where no stated difference has begun,
/// and else differs first, in the order of simplicity, at the point stated last; at its from_level with the
/// stated answers.
/// Domain: stated by ascending from_level.
Tally differs_first(const IndexSubject&, Level, const Run&, const std::vector<Difference>& stated);

/// Holds at level n if the subject differs from the reference at the N+1 vertices of the hypotenuse, at each of them, and
/// nowhere else; at level 0, where an index has no bits, at the u-corner alone.
Tally differs_on_hypotenuse(const IndexSubject&, Level, const Run&);

/// Holds at level n if one of two points, derived from the subject's precision p, gets a wrong index:
///   (1 - 2^-p, 2^-(p+1)) / N, whose fractions add up to 1 only by rounding, at level n >= 1;
///   (1/4, 1/4 - 2^-(p+2)), whose w = 1-u-v is above 1/2 but rounds to it.
Tally floats_err(const IndexSubject&, Level, const Run&);

/// Holds at level n if the subject's row corners are right for every index below 4097^2 - 2, and wrong there.
/// 4097^2 - 2 is odd and above 2^24: binary32 rounds it up to 4097^2 - 1, whose root rounds up to 4097.
Tally binary32_root_errs(const IndexSubject&, Level, const Run&);

}  // namespace mmverify::proofs::index
