// The laws index.all_levels, index.wide_is_vulkan and index.impl_wide_is_wide.
#include "proofs/engine/interrupt.hpp"
#include "proofs/index/induction/lemmas.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/index/induction/word_lemmas.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index::induction {
namespace {

using spec::index::Reading;

/// A law whose judge discharges statements; `search`: the highest level whose cells are searched for a
/// counterexample.
Law settled(Law law, std::vector<proofs::induction::About> known, Level search) {
  law.replay = replayed_by(replay_equals_reference);
  return proofs::induction::on_statements(
      std::move(law), std::move(known),
      [search](const std::vector<Statement>& statements, const Subject& s, const Run& run) {
        return discharge(statements, subject_as<IndexSubject>(s), search, run);
      });
}

Law all_levels_law() {
  constexpr Level search = 6;
  return settled({.id = "index.all_levels",
                  .says = "at every level n >= 0, for every rational point of the closed triangle, the "
                          "recursion's index is that of the reference in words without bounds",
                  .source = succinct_4_3,
                  .method = Method::induction,
                  .subjects = {"step"},
                  .tiers = {.seconds = 1},
                  .at_once = "all levels",
                  .domain = "every rational point of the triangle, every level n >= 0",
                  .mutants = mutants_of_all_levels(search)},
                 {{"step", all_levels_statements<Specified, Reading::printed>},
                  {"step-appendix-middle", all_levels_statements<Specified, Reading::appendix_middle>},
                  {"step-appendix-ties", all_levels_statements<Specified, Reading::appendix_ties>},
                  {"step-appendix-names", all_levels_statements<Specified, Reading::appendix_names>}},
                 search);
}

Law wide_is_vulkan_law() {
  constexpr Level search = 10;  // above the 8 levels at which half of a prefix XOR is right
  return settled(
      {.id = "index.wide_is_vulkan",
       .says = "at levels 0..16 the reference in 64-bit words is that in 32-bit words; up to level "
               "31 it is that in words without bounds",
       .source = vulkan,
       .method = Method::bit_vectors,
       .subjects = {"reference-wide"},
       .tiers = {.seconds = 3},
       .at_once = "levels 0..16",
       .domain = "every rational point, levels 0..16 together",
       .mutants = mutants_of_wide_is_vulkan(search)},
      {{"reference-wide", wide_statements<Specified>}}, search);
}

Law impl_wide_law() {
  constexpr Level search = 6;
  return settled({.id = "index.impl_wide_is_wide",
                  .says = "from floor(uN), floor(vN) and uf+vf >= 1 on, impl's index in 64-bit words is that "
                          "of the reference in 64-bit words",
                  .source = vulkan,
                  .method = Method::bit_vectors,
                  .subjects = {"impl"},
                  .tiers = {.seconds = 2},
                  .at_once = "levels 0..30",
                  .domain = "every grid square and both its halves, levels 0..30 together",
                  .mutants = mutants_of_impl_wide(search)},
                 {{"impl", impl_statements<Implemented>}}, search);
}

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

std::vector<Statement> shipped_all_levels() { return all_levels_statements<Specified, Reading::printed>(); }
std::vector<Statement> shipped_wide_is_vulkan() { return wide_statements<Specified>(); }

std::vector<Statement> shipped_impl_wide() { return impl_statements<Implemented>(); }

std::vector<Law> laws() { return {all_levels_law(), wide_is_vulkan_law(), impl_wide_law()}; }

Tally discharge(const std::vector<Statement>& statements, const IndexSubject& subject, Level search,
                const Run& run, const Effort& effort) {
  return proofs::induction::discharge(statements,
                                      {[&] { return counterexamples(subject, search, run); },
                                       fmt::format("the cells of levels 0..{}", search)},
                                      run, effort);
}

}  // namespace mmverify::proofs::index::induction
