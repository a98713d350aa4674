// The search for a counterexample where statements fail, and beside them where they hold.
#pragma once

#include "proofs/engine/interrupt.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index::binary32 {

inline constexpr Level highest = 16;
inline constexpr std::uint64_t pairs_searched = 1 << 14;  // a level

/// The simplest pairs of the lowest level on which a judge of floats finds the subject wrong.
template <class Judge>
std::vector<Counterexample> counterexamples(Judge judge, const IndexSubject& subject, const Run& run) {
  Run quick = run;
  quick.options = {};
  quick.near = 0;
  quick.progress = nullptr;
  for (Level n = 0; n <= highest && !interrupted(); ++n) {
    std::vector<Counterexample> found = judge(subject, n, quick, pairs_searched).found();
    for (Counterexample& c : found) c.level = n;
    if (!found.empty()) return found;
  }
  return {};
}

inline std::string where_searched() {
  return fmt::format("{} stiff pairs of each level 0..{}", pairs_searched, highest);
}

}  // namespace mmverify::proofs::index::binary32
