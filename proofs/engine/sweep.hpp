// Runs a judge over a domain in fixed chunks, on all threads, with the same outcome for any number of them.
#pragma once

#include <oneapi/tbb/task_arena.h>

#include <functional>

#include "proofs/engine/breaks.hpp"
#include "proofs/engine/chunk.hpp"
#include "proofs/engine/option.hpp"
#include "proofs/engine/progress.hpp"
#include "proofs/engine/share.hpp"
#include "proofs/engine/tally.hpp"

namespace mmverify::proofs {

/// fast: minutes at most, what CI runs; long: as far as the machine goes.
enum class Tier { fast, long_run };

/// What every law is given to run with.
struct Run {
  oneapi::tbb::task_arena* arena = nullptr;
  Progress* progress = nullptr;
  std::size_t errors = 1;  ///< counterexamples kept
  std::uint64_t seed = 1;  ///< of every sample
  Tier tier = Tier::fast;  ///< decides the size of samples
  std::uint64_t cases =
      0;                 ///< of each law that draws them at least so many, where its topic can; 0: the tier's
  Options options = {};  ///< those that the law heeds
  /// Units in the last place of the subject's numbers by which a point may miss an edge and have the index of the
  /// neighbour behind it; in laws that know it, and counted as allowed.
  std::uint32_t near = 0;
  Division* division = nullptr;  ///< null: the whole domain, and no journal
  /// Of a subject that must be wrong, one counterexample is enough: a sweep ends with the first chunk that has
  /// one, on one thread, so that it is the same on every machine.  Not for laws that look at a whole sweep.
  bool until_refuted = false;
  Breaks* breaks = nullptr;  ///< null: the first case on which a subject does not answer ends the law
  Level level = 0;           ///< that `breaks` are noted at
};

/// Counts the cases of one unit of a sweep, on which the subject broke, as declined; the sweep takes them for not judged.
using DeclineUnit = std::function<void(std::uint64_t unit, Tally&)>;
inline DeclineUnit as_one_case(Kind kind) {
  return [kind](std::uint64_t, Tally& tally) { tally.decline(kind); };
}

/// Judges [0, units) in chunks of `units_per_chunk`; the judge counts its cases in the tally.
/// Chunks are skipped once the run is interrupted; the missing cases show in the tally.  Under a Division
/// only its shard's chunks are judged, those that its journal has are added from there, and finished runs of
/// chunks are appended to it.
/// A chunk in which the subject breaks on a case, which the judge leaves by CaseBroken, is judged in halves, and at last
/// without the unit that has the case: it is noted in Run::breaks, and counted by `decline` as not judged.  Without `decline` the first
/// such case ends the law.
/// Domain: units_per_chunk > 0; a judge that is divided calls sweep once; a judge that is left has changed nothing but
/// its tally.  Throws BadJournal.
Tally sweep(const Run& run, std::uint64_t units, std::uint64_t units_per_chunk,
            const std::function<void(Chunk, Tally&)>& judge, const DeclineUnit& decline = {});

}  // namespace mmverify::proofs
