// Every combination that a decision depends on, by number and by text.
#pragma once

#include <string>
#include <vector>

#include "spec/traverse/decision.hpp"

namespace mmverify::proofs::traverse {

/// The number of combinations: 11 ways to trace (six APIs, five with a switch) x 11 kinds of micromap data (nothing,
/// 4 special indices, 2 + 4 states) x 2 geometries x 2^4 flags of an instance x 2^5 of a ray.
inline constexpr std::uint64_t all_combinations = 11 * 11 * 2 * 16 * 32;
/// The number of defined combinations: 6 ways that are set up for micromaps, with all kinds of data, and 5 that are
/// not, with none; 2 geometries; 3 x 4 flags of an instance, 5 x 2 of a ray.
inline constexpr std::uint64_t defined_combinations = (6 * 11 + 5) * 2 * 12 * 10;

/// Domain: k below all_combinations.
spec::traverse::Combination combination(std::uint64_t k);

/// The defined combinations, in the order of their numbers.
const std::vector<spec::traverse::Combination>& defined();

/// A combination as text, such as `khr-query,on,4-state:UT,not-opaque,instance=force-opaque+2-state,ray=none`.
std::string text_of(const spec::traverse::Combination& c);
/// Throws BadCase if the text is no combination.
spec::traverse::Combination combination_of(const std::string& text);

/// The flags that are set, joined by `+`, or `none`.
std::string flags_of(const spec::traverse::Instance& i);
std::string flags_of(const spec::traverse::Ray& r);
/// The micromap data as text: `nothing`, `special:T`, `2-state:O`, `4-state:UT`.
std::string text_of_held(const spec::traverse::Candidate& c);
/// The name of an API, such as `khr-query`.
const char* name_of(spec::traverse::Api api);

}  // namespace mmverify::proofs::traverse
