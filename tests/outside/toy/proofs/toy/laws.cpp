#include "proofs/toy/laws.hpp"

#include "proofs/toy/subject.hpp"
#include "spec/toy/twice.hpp"

namespace mmverify::proofs::toy {
namespace {

Finding doubles(const ToySubject& s, std::uint64_t k) {
  const std::uint32_t right = spec::toy::twice(static_cast<std::uint32_t>(k)),
                      got = s.functions.twice(static_cast<std::uint32_t>(k));
  return right == got ? Finding{} : wrong(std::to_string(right), std::to_string(got));
}

Law doubles_law() {
  return on_cases_of<ToySubject>(
      {.id = "toy.doubles",
       .says = "the answer is twice the number",
       .source = "arithmetic",
       .subjects = {"toy"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 8}, .seconds = 0.01},
       .domain = [](const Subject&, Level n) { return fmt::format("numbers below 2^{}", n); },
       .unfit = unless_of_topic<ToySubject>({}),
       .mutants = {changed(
           *built_in_subjects()[0], "7 is doubled wrongly", {3, 3},
           [](Functions& f) { f.twice = [](std::uint32_t k) { return k == 7 ? 15 : 2 * k; }; })}},
      {[](Level n) { return std::uint64_t{1} << n; },
       [](const ToySubject& s, Level, std::uint64_t k, const Run&) { return doubles(s, k); },
       [](Level, std::uint64_t k, const Run&) { return fmt::format("k={}", k); },
       [](const ToySubject& s, Level, const std::string& at) {
         return doubles(s, std::stoull(at.substr(2)));
       }});
}

}  // namespace

std::vector<Law> laws() { return {doubles_law()}; }

}  // namespace mmverify::proofs::toy
