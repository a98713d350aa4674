// The laws index.all_levels, index.wide_is_vulkan and index.impl_wide_is_wide.
#include <fmt/format.h>

#include <algorithm>

#include "proofs/index/induction/impl_lemmas.hpp"
#include "proofs/index/induction/lemmas.hpp"
#include "proofs/index/induction/mutants.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/index/induction/word_lemmas.hpp"
#include "proofs/index/laws/parts.hpp"

namespace mmverify::proofs::index::induction {
namespace {

using spec::index::Reading;

/// A built-in subject that a law has statements about.
struct About {
  const char* subject;
  std::vector<Statement> (*statements)();
};
using Subjects = std::vector<About>;

const Subjects& recursions() {
  static const Subjects all{
      {"step", all_levels_statements<Specified, Reading::printed>},
      {"step-appendix-middle", all_levels_statements<Specified, Reading::appendix_middle>},
      {"step-appendix-ties", all_levels_statements<Specified, Reading::appendix_ties>},
      {"step-appendix-names", all_levels_statements<Specified, Reading::appendix_names>}};
  return all;
}
const Subjects& wide_formulas() {
  static const Subjects all{{"reference-wide", wide_statements<Specified>}};
  return all;
}

const Subjects& libraries() {
  static const Subjects all{{"impl", impl_statements<Implemented>}};
  return all;
}

std::optional<std::vector<Statement>> statements_about(const Subjects& known, const Subject& subject) {
  if (const auto* own = dynamic_cast<const Provable*>(&subject)) return own->statements();
  for (const About& a : known)
    if (subject.name() == a.subject) return a.statements();
  return std::nullopt;
}

/// A law whose judge discharges statements; `search`: the highest level whose cells are searched for a
/// counterexample.
Law settled(const Subjects& (*known)(), Level search, std::uint64_t statements) {
  return {.id = {},
          .subjects = {},
          .cases = [statements](Level, const Run&) { return statements; },
          .unfit = [known](const Subject& s, Level) -> std::optional<std::string> {
            if (dynamic_cast<const Provable*>(&s) != nullptr) return std::nullopt;
            std::string names;
            for (const About& a : known()) {
              if (s.name() == a.subject) return std::nullopt;
              names += (names.empty() ? "" : ", ") + std::string(a.subject);
            }
            return fmt::format("no statements about {}: there are some about {}", s.name(), names);
          },
          .judge =
              [known, search](const Subject& s, Level, const Run& run) {
                return discharge(statements_about(known(), s).value(), subject_as<IndexSubject>(s), search,
                                 run);
              },
          .replay = replayed_by(replay_equals_reference)};
}

Law all_levels_law() {
  constexpr Level search = 6;
  Law law = settled(recursions, search, shipped_all_levels().size());
  law.id = "index.all_levels";
  law.says =
      "at every level n >= 0, for every rational point of the closed triangle, the recursion's index is that "
      "of the reference in words without bounds";
  law.source = succinct_4_3;
  law.method = Method::induction;
  law.at_once = "all levels";
  law.subjects = {"step"};
  law.tiers.seconds = 1;
  law.domain = [](const Subject&, Level) {
    return "every rational point of the triangle, every level n >= 0";
  };
  law.how = [](const Subject&, Level) { return "induction, " + proofs::induction::prover_name(); };
  law.mutants = mutants_of_all_levels(search);
  return law;
}

Law wide_is_vulkan_law() {
  constexpr Level search = 10;  // above the 8 levels at which half of a prefix XOR is right
  Law law = settled(wide_formulas, search, shipped_wide_is_vulkan().size());
  law.id = "index.wide_is_vulkan";
  law.says =
      "at levels 0..16 the reference in 64-bit words is that in 32-bit words; up to level 31 it is that in "
      "words without bounds";
  law.source = vulkan;
  law.method = Method::bit_vectors;
  law.at_once = "levels 0..16";
  law.subjects = {"reference-wide"};
  law.tiers.seconds = 3;
  law.domain = [](const Subject&, Level) { return "every rational point, levels 0..16 together"; };
  law.how = [](const Subject&, Level) { return "bit vectors, " + proofs::induction::prover_name(); };
  law.mutants = mutants_of_wide_is_vulkan(search);
  return law;
}

Law impl_wide_law() {
  constexpr Level search = 6;
  Law law = settled(libraries, search, shipped_impl_wide().size());
  law.id = "index.impl_wide_is_wide";
  law.says =
      "from floor(uN), floor(vN) and uf+vf >= 1 on, impl's index in 64-bit words is that of the reference in "
      "64-bit words";
  law.source = vulkan;
  law.method = Method::bit_vectors;
  law.at_once = "levels 0..30";
  law.subjects = {"impl"};
  law.tiers.seconds = 2;
  law.domain = [](const Subject&, Level) {
    return "every grid square and both its halves, levels 0..30 together";
  };
  law.how = [](const Subject&, Level) { return "bit vectors, " + proofs::induction::prover_name(); };
  law.mutants = mutants_of_impl_wide(search);
  return law;
}

}  // namespace

std::vector<Statement> shipped_all_levels() { return all_levels_statements<Specified, Reading::printed>(); }
std::vector<Statement> shipped_wide_is_vulkan() { return wide_statements<Specified>(); }

std::vector<Statement> shipped_impl_wide() { return impl_statements<Implemented>(); }

std::vector<Law> laws() { return {all_levels_law(), wide_is_vulkan_law(), impl_wide_law()}; }

}  // namespace mmverify::proofs::index::induction
