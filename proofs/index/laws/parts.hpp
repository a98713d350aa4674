// Common parts of the laws of topic index: closed forms, domains and methods in words, conditions on subjects.
#pragma once

#include "proofs/index/judges/judges.hpp"

namespace mmverify::proofs::index {

inline constexpr char vulkan[] = "VK_EXT_opacity_micromap, appendix \"Reference Code\"";
inline constexpr char succinct_4_2[] = "Succinct Opacity Micromaps, 4.2, Algorithm 3";
inline constexpr char succinct_4_3[] = "Succinct Opacity Micromaps, 4.3, Algorithm 4";
inline constexpr char succinct_a[] = "Succinct Opacity Micromaps, Appendix A";
inline constexpr char attribute_4[] = "Color and Attribute Micromaps, 4.1, figure 4";

using Judge = Tally (*)(const IndexSubject&, Level, const Run&);
using Replay = Replayed (*)(const IndexSubject&, Level, const std::string&);
using SampleJudge = Tally (*)(const IndexSubject&, Level, const Run&, std::uint64_t samples);
std::function<Tally(const Subject&, Level, const Run&)> judged_by(Judge judge);
std::function<Replayed(const Subject&, Level, const std::string&)> replayed_by(Replay replay);

/// The laws on all points of a level, by the cells that hold them, on all its indices, and on samples: where a law
/// says nothing else, of a subject with that entry point, in fixed point, one by one, against exact arithmetic.
Law over_points(Law law, const Entry& asked, Judge judge, Replay replay = nullptr);
Law over_indices(Law law, Judge judge, Replay replay);
Law over_samples(Law law, const CaseCount& samples, SampleJudge judge, Replay replay = nullptr);

// Closed forms.
std::uint64_t all_cells(Level n, const Run& run);
std::uint64_t next_cells(Level n, const Run& run);
std::uint64_t all_triangles(Level n, const Run& run);

// Domains in words.
std::string points(const Subject& subject, Level n);
std::string next_points(const Subject& subject, Level n);
std::string triangles(const Subject& subject, Level n);

// Methods in words.
std::string in_fixed_point(const Subject& subject, Level n);
std::string in_rationals_then_fixed_point(const Subject& subject, Level n);
std::string against_rationals(const Subject& subject, Level n);
inline constexpr char by_sample[] = "sample, against exact arithmetic";
inline constexpr char by_witness[] = "witness, against exact arithmetic";

/// The subject must have the entry points and be defined `above` levels further.
Unfit needing(std::vector<Entry> entries, Level above = 0);

/// The subject must also compute in exact arithmetic.
Unfit needing_exact(std::vector<Entry> entries);

}  // namespace mmverify::proofs::index
