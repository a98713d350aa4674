#include <fmt/format.h>

#include "proofs/engine/interrupt.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index::induction {
namespace {

/// The simplest points, on the lowest level that has any, on which the subject is not the reference.
std::vector<Counterexample> counterexamples(const IndexSubject& subject, Level search, const Run& run) {
  Run quick = run;
  quick.options = {&in_fixed_point_alone};
  quick.progress = nullptr;
  for (Level n = 0; n <= search && !interrupted(); ++n) {
    std::vector<Counterexample> found = equals_reference(subject, n, quick).found();
    for (Counterexample& c : found) c.level = n;
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace

Tally discharge(const std::vector<Statement>& statements, const IndexSubject& subject, Level search,
                const Run& run, const Effort& effort) {
  return proofs::induction::discharge(statements,
                                      {[&] { return counterexamples(subject, search, run); },
                                       fmt::format("the cells of levels 0..{}", search)},
                                      run, effort);
}

}  // namespace mmverify::proofs::index::induction
