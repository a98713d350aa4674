// Runs a judge over a domain in fixed chunks on all threads; the outcome does not depend on their number.
#pragma once

#include <oneapi/tbb/task_arena.h>

#include <functional>

#include "proofs/engine/breaks.hpp"
#include "proofs/engine/option.hpp"
#include "proofs/engine/progress.hpp"
#include "proofs/engine/share.hpp"
#include "proofs/engine/tally.hpp"

namespace mmverify::proofs {

/// The extent of a run.  fast: minutes at most, for CI; long: as far as the machine allows.
enum class Tier { fast, long_run };

/// The settings that every law runs with.
struct Run {
  oneapi::tbb::task_arena* arena = nullptr;
  Progress* progress = nullptr;
  std::size_t errors = 1;  ///< counterexamples kept
  std::uint64_t seed = 1;  ///< of all samples
  Tier tier = Tier::fast;  ///< decides the size of samples
  std::uint64_t cases =
      0;  ///< the least number of cases of each law that draws them, if its topic can; 0: the tier's
  Options options = {};  ///< the options that the law heeds
  /// The distance from an edge, in ulps of the subject's numbers, up to which a point may have the index of the
  /// neighbour behind the edge.  Laws that know it count such answers as allowed.
  std::uint32_t near = 0;
  Division* division = nullptr;  ///< null: the whole domain, and no journal
  /// One counterexample is enough, as for a mutant: a sweep ends with the first chunk that has one, on one thread, so
  /// that it is the same on every machine.  Not for laws that need a whole sweep.
  bool until_refuted = false;
  Breaks* breaks = nullptr;  ///< null: the first case that the subject does not answer ends the law
  Level level = 0;           ///< the level that `breaks` are noted at
};

/// Counts the cases of a unit that the subject broke on as declined; the sweep turns them into unjudged ones.
using DeclineUnit = std::function<void(std::uint64_t unit, Tally&)>;
inline DeclineUnit as_one_case(Kind kind) {
  return [kind](std::uint64_t, Tally& tally) { tally.decline(kind); };
}

/// Judges [0, units) in chunks of `units_per_chunk`; the judge counts its cases in the tally.  An interrupted run
/// skips the remaining chunks, and the tally lacks their cases.
/// A Division limits the sweep to its shard's chunks.  Chunks that its journal has are added from there, and finished
/// runs of chunks are appended to it.
/// The judge leaves a chunk by CaseBroken if the subject breaks on a case.  The chunk is then judged in halves, and
/// at last without the unit that has the case.  The break is noted in Run::breaks, and `decline` counts the unit as
/// not judged. Without `decline` the first such case ends the law.
/// Domain: units_per_chunk > 0; a divided judge calls sweep once; a judge that is left has changed nothing but its
/// tally. Throws BadJournal.
Tally sweep(const Run& run, std::uint64_t units, std::uint64_t units_per_chunk,
            const std::function<void(Chunk, Tally&)>& judge, const DeclineUnit& decline = {});

}  // namespace mmverify::proofs
