// Common parts of the laws of topic tree: the check of a map, and the maps that it runs on.
#pragma once

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {

using namespace micromap;

inline constexpr char succinct_4_1[] = "Succinct Opacity Micromaps, 4.1, Algorithms 1 and 2";
inline constexpr char succinct_4_2[] = "Succinct Opacity Micromaps, 4.2, Algorithm 3";
inline constexpr char succinct_6_2[] = "Succinct Opacity Micromaps, 6.2 and 6.2.1, figures 9 and 10";

using Check = std::function<Finding(const TreeSubject&, const Map&)>;

/// A failed finding: it expected "WHERE EXPECTED", and got `got`.
Finding wrong(const std::string& where, const std::string& expected, std::string got);

/// The reason why a law that needs these entries does not apply, if any.
Unfit needing(std::vector<Entry> entries);

using Cases = CasesOf<TreeSubject>;

/// The law on numbered cases.
Law on_cases(Law law, std::vector<Entry> entries, Cases cases);

/// The law on every map of levels 0, 1 and (2-state) 2; a case each.
Law on_all_maps(Law law, std::vector<Entry> entries, Check check);

/// The law on all 4-state maps of level 2.
Law on_four_state_maps_of_level_2(Law law, std::vector<Entry> entries, Check check);

/// The law on samples of each level.
Law on_samples(Law law, std::vector<Entry> entries, Check check);

/// The first difference of two maps, as a finding; `answer` is a hash of the second.
Finding same_map(const Map& expected, const Bytes& got);

}  // namespace mmverify::proofs::tree
