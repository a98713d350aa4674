#include "proofs/index/binary32/law.hpp"

#include <fmt/format.h>

#include "proofs/index/binary32/lemmas.hpp"
#include "proofs/index/binary32/search.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/induction/discharge.hpp"

namespace mmverify::proofs::index::binary32 {

using proofs::induction::Provable;

std::vector<proofs::induction::Statement> shipped() {
  return statements_of(scalar_steps<Implemented>(), lane_steps());
}

Law law() {
  return {.id = "index.floats",
          .says =
              "for every pair of binary32 numbers, at every level 0..16, the library's index, one value at a "
              "time and in vectors, is that of the exact reference; in 64-bit words at every level 0..30",
          .source = vulkan,
          .method = Method::bit_vectors,
          .subjects = {"impl"},
          .tiers = {.seconds = 8},
          .at_once = "levels 0..30",
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
                    {[&] { return counterexamples(exact_on_floats, subject_as<IndexSubject>(s), run); },
                     where_searched()},
                    run);
              },
          .replay = replayed_by(replay_equals_reference),
          .mutants = mutants()};
}

}  // namespace mmverify::proofs::index::binary32
