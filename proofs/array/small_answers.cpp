#include "proofs/array/small_answers.hpp"

#include <array>

namespace mmverify::proofs::array {
namespace {

/// The checks of the laws on small arrays.
constexpr std::array<Check, 8> checks{resolves,       keeps_formats,       uses_special_indices,
                                      stays_in_range, counts_records,      counts_references,
                                      shares,         keeps_what_was_there};

}  // namespace

Finding small_array_finding(const ArraySubject& s, Level n, std::uint64_t k, Check check) {
  Passed* const kept = s.functions.small_arrays.at(n);
  if (kept != nullptr)
    if (const auto answer = kept->answer(k)) return {*answer};
  if (kept == nullptr || !kept->take(k)) return built(s, small_array(n, k), check);
  bool all = true;
  Finding found = built(s, small_array(n, k), [&](const Answer& answer, const BuildCase& c) {
    Finding one = check(answer, c);
    all = all && one.holds;
    for (const Check other : checks)
      if (all && other != check) {
        const Finding beside = other(answer, c);
        all = beside.holds && beside.answer == one.answer;
      }
    return one;
  });
  if (all && found.holds) kept->pass(k, found.answer);
  return found;
}

PassedOfSubject small_arrays_of_subject() { return PassedOfSubject({small_arrays(0), small_arrays(1)}); }

}  // namespace mmverify::proofs::array
