// tree.all_levels.
#include "proofs/engine/interrupt.hpp"
#include "proofs/tree/checks.hpp"
#include "proofs/tree/induction/lemmas.hpp"
#include "proofs/tree/induction/provable.hpp"

namespace mmverify::proofs::tree::induction {
namespace {

constexpr Level search = 2;
constexpr char about[] = "tree-spec";

Finding as_specified(const TreeSubject& s, const Map& map) {
  const Finding found = lookups(s, map);
  return found.holds ? stream_is_specified(s, map) : found;
}

std::vector<Counterexample> counterexamples(const TreeSubject& subject, const Run& run) {
  std::vector<Counterexample> found;
  for (Level n = 0; n <= search && found.empty(); ++n)
    for (std::uint64_t k = 0; k < map_count(n) && found.size() < run.errors && !interrupted(); ++k) {
      const Map map = map_number(n, k);
      if (const Finding f = as_specified(subject, map); !f.holds)
        found.push_back({{n, k, 0}, n, text_of_states(map), {}, f.expected, f.got});
    }
  return found;
}

}  // namespace

Tally discharge(const std::vector<Statement>& statements, const TreeSubject& subject, const Run& run,
                const Effort& effort) {
  return proofs::induction::discharge(
      statements,
      {[&] { return counterexamples(subject, run); }, fmt::format("the maps of levels 0..{}", search)}, run,
      effort);
}

std::vector<Statement> shipped_all_levels() { return all_levels_statements<Specified>(); }

Law all_levels_law() {
  Law law = proofs::induction::on_statements(
      {.id = "tree.all_levels",
       .says =
           "at every level n >= 0, of every map: Algorithms 1 and 2 give it one encoding that no other map "
           "has, Algorithm 3 finds its every state there, and it is no larger than (4^(n+1)-1)/3 nodes",
       .source = "Succinct Opacity Micromaps, 4.1, 4.2 and 6.2.1",
       .method = Method::induction,
       .subjects = {about},
       .tiers = {.seconds = 2},
       .at_once = "all levels",
       .domain = "every map of every level n >= 0",
       .mutants = mutants_of_all_levels()},
      {{about, shipped_all_levels}},
      [](const std::vector<Statement>& statements, const Subject& s, const Run& run) {
        return discharge(statements, dynamic_cast<const TreeSubject&>(s), run);
      });
  law.replay = [](const Subject& s, Level n, const std::string& at) {
    return replayed(as_specified(dynamic_cast<const TreeSubject&>(s), map_from_text(n, at)));
  };
  return law;
}

}  // namespace mmverify::proofs::tree::induction
