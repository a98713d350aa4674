// The judges of topic index: each function sweeps one law's domain at one level.  All take (subject, level, run) and
// count every case of the closed form that the law names.
#pragma once

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The highest levels at which equals_reference runs in rationals on both sides.  Up to boost_levels these are
/// Boost.Rational, whose 16,771 points take a second; up to rational_levels they are our own rationals of 63 bits.
/// fixed_is_rational uses the same two levels, and compares ours with Boost's.
constexpr Level boost_levels = 6, rational_levels = 8;

// Judges on the cells of the level (nested: of the next level).
Tally equals_reference(const IndexSubject&, Level, const Run&);
Tally in_range(const IndexSubject&, Level, const Run&);
Tally nested(const IndexSubject&, Level, const Run&);
Tally rounding(const IndexSubject&, Level, const Run&);
Tally fixed_is_rational(const IndexSubject&, Level, const Run&);
Tally sweep_is_spec(const IndexSubject&, Level, const Run&);
Tally row_order(const IndexSubject&, Level, const Run&);
Tally row_holds_point(const IndexSubject&, Level, const Run&);

// Judges on the 4^n micro-triangles.
Tally bijective(const IndexSubject&, Level, const Run&);
Tally contiguous(const IndexSubject&, Level, const Run&);

// Judges on the 4^n indices.
Tally inverse(const IndexSubject&, Level, const Run&);
Tally corners_as_sets(const IndexSubject&, Level, const Run&);
Tally corners_in_order(const IndexSubject&, Level, const Run&);  // in the declared order
Tally row_corners(const IndexSubject&, Level, const Run&);       // as sets

// Judges on sampled indices: all entry points, corners in any order; and corners in the declared order.
Tally on_samples(const IndexSubject&, Level, const Run&, std::uint64_t samples);
Tally corners_on_samples(const IndexSubject&, Level, const Run&, std::uint64_t samples);

// The judge on all pairs of non-negative binary16 numbers of the triangle.
Tally exact_on_binary16(const IndexSubject&, Level, const Run&);

// Judges on samples.
Tally exact_on_floats(const IndexSubject&, Level, const Run&, std::uint64_t samples);
Tally equals_published(const IndexSubject&, Level, const Run&, std::uint64_t samples);
Tally exact_or_published(const IndexSubject&, Level, const Run&, std::uint64_t samples);
Tally exact_on_doubles(const IndexSubject&, Level, const Run&, std::uint64_t samples);
Tally row_exact_on_floats(const IndexSubject&, Level, const Run&, std::uint64_t samples);
Tally cells_decide(const IndexSubject&, Level, const Run&, std::uint64_t samples);

// The replays: the same laws on one case; each throws BadCase for a text that it cannot read.
Replayed replay_equals_reference(const IndexSubject&, Level, const std::string& at);
Replayed replay_equals_published(const IndexSubject&, Level, const std::string& at);
Replayed replay_exact_or_published(const IndexSubject&, Level, const std::string& at);
Replayed replay_in_range(const IndexSubject&, Level, const std::string& at);
Replayed replay_nested(const IndexSubject&, Level, const std::string& at);
Replayed replay_rounding(const IndexSubject&, Level, const std::string& at);
Replayed replay_row_order(const IndexSubject&, Level, const std::string& at);
Replayed replay_row_holds_point(const IndexSubject&, Level, const std::string& at);
Replayed replay_bijective(const IndexSubject&, Level, const std::string& at);
Replayed replay_contiguous(const IndexSubject&, Level, const std::string& at);
Replayed replay_inverse(const IndexSubject&, Level, const std::string& at);
Replayed replay_corners_as_sets(const IndexSubject&, Level, const std::string& at);
Replayed replay_corners_in_order(const IndexSubject&, Level, const std::string& at);
Replayed replay_row_corners(const IndexSubject&, Level, const std::string& at);
Replayed replay_on_samples(const IndexSubject&, Level, const std::string& at);
Replayed replay_corners_on_samples(const IndexSubject&, Level, const std::string& at);

/// An index as a case, "k=9"; parse_index() throws BadCase if the text is no index of the level.
std::string case_of(std::uint32_t index);
std::uint32_t parse_index(const std::string& at, Level n);
std::string text(const Corners& c);

/// The point of a case text as the subject receives it; BadCase if the subject's arithmetic has no such number.
RationalPoint received_point(const IndexSubject&, const std::string& at);

/// The specification's corners of an index in that order; for `undeclared` in the specification's own order.
/// Domain: index in [0, 4^n), n in 0..16.
Corners corners_in(CornerOrder order, std::uint32_t index, Level n);

/// The corners sorted by i, then j, so that two triples are equal if and only if they are equal as sets.
Corners sorted(Corners c);

/// The micro-triangle of level n with these corners, in any order; nothing if they do not form one.
/// Domain: any numbers, n in 0..16.
std::optional<MicroTriangle> triangle_of(const Corners& c, Level n);

// Judges that say of a subject that it is wrong, and where: what a source claims and is not so, kept as a fact.

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
