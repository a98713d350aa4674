// dag.all_levels.
#include "proofs/dag/induction/provable.hpp"
#include "proofs/dag/law_parts.hpp"
#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs::dag::induction {
namespace {

/// The small scenes of levels 3 and 4, whose nodes have 64 and 4 children, and beyond them the two scenes of a level of
/// which every child of the root is mixed and another one: 16 of them at levels 5 and 7, 4 at level 6.
constexpr Levels search{3, 7}, small{3, 4};
std::uint64_t first_scene(Level n) { return n <= small.last ? 0 : mask_scenes(n) - 2; }
std::uint64_t scenes(Level n) { return n <= small.last ? small_scenes(n) : mask_scenes(n); }
/// Level 4 ends with its scenes of one map, which are searched before its pairs.
std::uint64_t searched(Level n, std::uint64_t k) {
  constexpr std::uint64_t pairs = 2 * 81 * 81;
  return n == small.last ? (k + pairs) % scenes(n) : k;
}
Scene scene(Level n, std::uint64_t k) { return n <= small.last ? small_scene(n, k) : mask_scene(n, k); }
constexpr char about[] = "dag-spec";

Finding as_specified(const DagSubject& s, const Scene& scene) {
  const Finding found = lookups(s, scene, ~std::uint64_t{0});
  return found.holds ? is_specified(s, scene) : found;
}

std::vector<Counterexample> counterexamples(const DagSubject& subject, const Run& run) {
  std::vector<Counterexample> found;
  for (Level n = search.first; n <= search.last && found.empty(); ++n)
    for (std::uint64_t j = first_scene(n); j < scenes(n) && found.size() < run.errors && !interrupted();
         ++j) {
      const std::uint64_t k = searched(n, j);
      if (const Finding f = as_specified(subject, scene(n, k)); !f.holds)
        found.push_back({{n, k, 0}, n, text_of_number(k), {}, f.expected, f.got});
    }
  return found;
}

}  // namespace

Tally discharge(const std::vector<Statement>& statements, const DagSubject& subject, const Run& run,
                const Effort& effort) {
  return proofs::induction::discharge(
      statements,
      {[&] { return counterexamples(subject, run); },
       fmt::format("the small scenes of levels {} and {}, and maps of 16 different children", small.first,
                   small.last)},
      run, effort);
}

Law all_levels_law() {
  Law law = proofs::induction::on_statements(
      {.id = "dag.all_levels",
       .says =
           "of every map of every level n >= 3: the graph means the map, equal subtrees are one part, a "
           "lookup finds each state, what is added changes nothing that was meant, and the whole takes no "
           "more than flat",
       .source = form,
       .method = Method::induction,
       .subjects = {about},
       .tiers = {.seconds = 2.7},
       .at_once = "all levels",
       .domain = "every map of every level n >= 3",
       .mutants = mutants_of_all_levels()},
      {{about, shipped_all_levels}},
      [](const std::vector<Statement>& statements, const Subject& s, const Run& run) {
        return discharge(statements, dynamic_cast<const DagSubject&>(s), run);
      });
  law.replay = [](const Subject& s, Level n, const std::string& at) {
    if (n > search.last) throw BadCase("its scenes are those of levels 0..7");
    return replayed(
        as_specified(dynamic_cast<const DagSubject&>(s), scene(n, number_from_text(at, scenes(n)))));
  };
  return law;
}

}  // namespace mmverify::proofs::dag::induction
