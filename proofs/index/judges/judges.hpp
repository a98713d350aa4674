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

}  // namespace mmverify::proofs::index
