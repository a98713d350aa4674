#include "proofs/index/binary32/law.hpp"

#include <fmt/format.h>

#include "proofs/engine/interrupt.hpp"
#include "proofs/index/binary32/lemmas.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/induction/discharge.hpp"

namespace mmverify::proofs::index::binary32 {
namespace {

using proofs::induction::Provable;

constexpr Level highest = 16;
constexpr std::uint64_t pairs_searched = 1 << 14;  // a level

/// The simplest pairs of the lowest level on which the subject is not the exact reference.
std::vector<Counterexample> counterexamples(const IndexSubject& subject, const Run& run) {
  Run quick = run;
  quick.options = {};
  quick.near = 0;
  quick.progress = nullptr;
  for (Level n = 0; n <= highest && !interrupted(); ++n) {
    std::vector<Counterexample> found = exact_on_floats(subject, n, quick, pairs_searched).found();
    for (Counterexample& c : found) c.level = n;
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace

std::vector<proofs::induction::Statement> shipped() {
  return statements_of(scalar_steps<Implemented>(), lane_steps());
}

Law law() {
  return {.id = "index.floats",
          .topic = "index",
          .says =
              "for every pair of binary32 numbers, at every level 0..16, the library's index, one value at a "
              "time and "
              "in vectors, is that of the exact reference; in 64-bit words at every level 0..30",
          .source = vulkan,
          .method = Method::bit_vectors,
          .subjects = {"impl"},
          .at_once = "levels 0..30",
          .fast_seconds = 8,
          .cases = [count = shipped().size()](Level, const Run&) -> std::uint64_t { return count; },
          .domain =
              [](const Subject&, Level) {
                return "every pair of binary32 bit patterns, levels 0..16 together, 64-bit words 0..30";
              },
          .how = [](const Subject&, Level) { return "bit vectors, " + proofs::induction::prover_name(); },
          .unfit = [](const Subject& s, Level) -> std::optional<std::string> {
            if (dynamic_cast<const Provable*>(&s) != nullptr || s.name() == "impl") return std::nullopt;
            return fmt::format("no statements about {}: there are some about impl", s.name());
          },
          .judge =
              [](const Subject& s, Level, const Run& run) {
                const auto* own = dynamic_cast<const Provable*>(&s);
                return proofs::induction::discharge(
                    own != nullptr ? own->statements() : shipped(),
                    {[&] { return counterexamples(of_index(s), run); },
                     fmt::format("{} hard pairs of each level 0..{}", pairs_searched, highest)},
                    run);
              },
          .replay = replayed_by(replay_equals_reference),
          .mutants = mutants()};
}

}  // namespace mmverify::proofs::index::binary32
