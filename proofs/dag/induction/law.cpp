// dag.all_levels.
#include <fmt/format.h>

#include "proofs/dag/induction/provable.hpp"
#include "proofs/dag/law_parts.hpp"
#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs::dag::induction {
namespace {

constexpr Levels search{3, 4};
constexpr char about[] = "dag-spec";

Finding as_specified(const DagSubject& s, const Scene& scene) {
  const Finding found = lookups(s, scene, ~std::uint64_t{0});
  return found.holds ? is_specified(s, scene) : found;
}

std::vector<Counterexample> counterexamples(const DagSubject& subject, const Run& run) {
  std::vector<Counterexample> found;
  for (Level n = search.first; n <= search.last && found.empty(); ++n)
    for (std::uint64_t k = 0; k < small_scenes(n) && found.size() < run.errors && !interrupted(); ++k)
      if (const Finding f = as_specified(subject, small_scene(n, k)); !f.holds)
        found.push_back({{n, k, 0}, n, text_of_number(k), {}, f.expected, f.got});
  return found;
}

std::optional<std::vector<Statement>> statements_about(const Subject& subject) {
  if (const auto* own = dynamic_cast<const Provable*>(&subject)) return own->statements();
  if (subject.name() == about) return shipped_all_levels();
  return std::nullopt;
}

}  // namespace

Tally discharge(const std::vector<Statement>& statements, const DagSubject& subject, const Run& run,
                const Effort& effort) {
  return proofs::induction::discharge(
      statements,
      {[&] { return counterexamples(subject, run); },
       fmt::format("the small scenes of levels {} and {}", search.first, search.last)},
      run, effort);
}

Law all_levels_law() {
  Law law{.id = "dag.all_levels",
          .topic = "dag",
          .says =
              "of every map of every level n >= 3: the graph means the map, equal subtrees are one part, a "
              "lookup finds each "
              "state, what is added changes nothing that was meant, and the whole takes no more than flat",
          .source = form,
          .method = Method::induction,
          .subjects = {about},
          .at_once = "all levels",
          .fast_seconds = 2.7};
  law.cases = [count = shipped_all_levels().size()](Level, const Run&) { return count; };
  law.domain = [](const Subject&, Level) { return "every map of every level n >= 3"; };
  law.how = [](const Subject&, Level) { return "induction, " + proofs::induction::prover_name(); };
  law.unfit = [](const Subject& s, Level) -> std::optional<std::string> {
    if (dynamic_cast<const Provable*>(&s) != nullptr || s.name() == about) return std::nullopt;
    return fmt::format("no statements about {}: there are some about {}", s.name(), about);
  };
  law.judge = [](const Subject& s, Level, const Run& run) {
    return discharge(statements_about(s).value(), dynamic_cast<const DagSubject&>(s), run);
  };
  law.replay = [](const Subject& s, Level n, const std::string& at) {
    if (n > 4) throw BadCase("its scenes are those of levels 0..4");
    return replayed(as_specified(dynamic_cast<const DagSubject&>(s),
                                 small_scene(n, number_from_text(at, small_scenes(n)))));
  };
  law.mutants = mutants_of_all_levels();
  return law;
}

}  // namespace mmverify::proofs::dag::induction
