#include "proofs/engine/sweep.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/journal.hpp"
#include "proofs/engine/processor_time.hpp"

namespace mmverify::proofs {
namespace {

using Judge = std::function<void(Chunk, Tally&)>;
using Range = oneapi::tbb::blocked_range<std::uint64_t>;

// The approximate number of a journal's lines for a sweep; a short sweep has several chunks a line.
constexpr std::uint64_t pieces_per_sweep = 1024, least_chunks_per_piece = 4;

struct Domain {
  std::uint64_t units, units_per_chunk;
  std::uint64_t chunks() const { return units / units_per_chunk + (units % units_per_chunk != 0 ? 1 : 0); }
  /// The units of a range of chunks.
  Chunk units_of(Chunk c) const {
    return {c.begin * units_per_chunk, std::min(c.end * units_per_chunk, units)};
  }
};

/// The judge of a sweep, which continues if the subject breaks.
struct Judging {
  const Judge& judge;
  const DeclineUnit& decline;

  /// Judges all units except those that the subject breaks on.
  void operator()(const Run& run, Chunk units, Tally& tally) const {
    if (run.breaks == nullptr || !decline) return judge(units, tally);
    try {
      Tally part(run.errors);
      judge(units, part);
      tally.merge(part);
      run.breaks->answered();
      return;
    } catch (const dock::CaseBroken& broken) {
      if (units.end - units.begin == 1) {
        run.breaks->note(run.level, units.begin, broken);
        Tally broken(run.errors);
        decline(units.begin, broken);
        broken.none_declined();
        tally.merge(broken);
        return;
      }
    }
    const std::uint64_t middle = units.begin + (units.end - units.begin) / 2;
    (*this)(run, {units.begin, middle}, tally);
    (*this)(run, {middle, units.end}, tally);
  }
};

/// Judges a range of chunks one by one.  False if an interrupt came before the last.
bool judge_chunks(const Run& run, const Domain& domain, Chunk chunks, const Judging& judge, Tally& tally) {
  for (std::uint64_t c = chunks.begin; c != chunks.end; ++c) {
    if (interrupted()) return false;
    const std::uint64_t before = tally.cases();
    judge(run, domain.units_of({c, c + 1}), tally);
    if (run.progress != nullptr) run.progress->add(tally.cases() - before);
  }
  return true;
}

void raise_to(std::atomic<std::int64_t>& most, std::int64_t value) {
  std::int64_t now = most;
  while (now < value && !most.compare_exchange_weak(now, value)) continue;
}

/// The sum of part(k, tally) over [0, parts), on all threads of the run.
template <class Part>
Tally sum(const Run& run, std::uint64_t parts, const Part& part) {
  const bool side_by_side = run.arena != nullptr && !run.until_refuted;
  ProcessorTime* const task = Counting::task();
  std::atomic<std::int64_t> longest = 0;
  const auto several = [&](const Range& range, Tally tally) {
    const Counting counting(task, !side_by_side);
    std::int64_t before = thread_nanoseconds();
    for (std::uint64_t k = range.begin(); k != range.end() && !interrupted(); ++k) {
      part(k, tally);
      if (run.until_refuted && tally.mismatches() != 0) break;
      const std::int64_t now = thread_nanoseconds();
      raise_to(longest, now - std::exchange(before, now));
    }
    return tally;
  };
  const auto merge = [](Tally a, const Tally& b) {
    a.merge(b);
    return a;
  };
  const auto all = [&] {
    return oneapi::tbb::parallel_reduce(Range(0, parts), Tally(run.errors), several, merge);
  };
  if (!side_by_side) return several(Range(0, parts), Tally(run.errors));
  Tally tally = run.arena->execute(all);
  if (task != nullptr) task->path += longest;
  return tally;
}

/// The chunks that no finished piece covers, in pieces.
std::vector<Chunk> unfinished(Chunk chunks, const std::vector<Journal::Piece>& finished,
                              const Domain& domain) {
  const std::uint64_t size = std::max(least_chunks_per_piece, domain.chunks() / pieces_per_sweep);
  std::vector<Chunk> left;
  const auto leave = [&](std::uint64_t begin, std::uint64_t end) {
    for (; begin < end; begin += size) left.push_back({begin, std::min(begin + size, end)});
  };
  for (const Journal::Piece& piece : finished) {
    leave(chunks.begin, piece.units.begin / domain.units_per_chunk);
    chunks.begin = (piece.units.end + domain.units_per_chunk - 1) / domain.units_per_chunk;
  }
  leave(chunks.begin, chunks.end);
  return left;
}

/// The pieces of the journal that are whole chunks of the range.
std::vector<Journal::Piece> usable(const Division& division, Chunk chunks, const Domain& domain) {
  std::vector<Journal::Piece> pieces = division.journal->finished(division.about, domain.units);
  const Chunk range = domain.units_of(chunks);
  std::erase_if(pieces, [&](const Journal::Piece& p) {
    const bool starts = p.units.begin % domain.units_per_chunk == 0;
    const bool ends = p.units.end % domain.units_per_chunk == 0 || p.units.end == domain.units;
    return !starts || !ends || p.units.begin < range.begin || p.units.end > range.end;
  });
  return pieces;
}

Tally journaled(const Run& run, const Domain& domain, Chunk chunks, const Judging& judge) {
  Division& division = *run.division;
  const std::vector<Journal::Piece> finished = usable(division, chunks, domain);
  const std::vector<Chunk> left = unfinished(chunks, finished, domain);
  Tally tally(run.errors);
  for (const Journal::Piece& piece : finished) tally.merge(piece.tally);
  division.resumed = tally.cases();
  if (run.progress != nullptr) run.progress->resume(division.resumed);
  tally.merge(sum(run, left.size(), [&](std::uint64_t k, Tally& part) {
    Tally piece(run.errors);
    if (judge_chunks(run, domain, left[k], judge, piece) && !piece.broke())
      division.journal->append({division.about, domain.units_of(left[k]), domain.units, piece});
    part.merge(piece);
  }));
  division.journal->flush();
  return tally;
}

}  // namespace

Tally sweep(const Run& run, std::uint64_t units, std::uint64_t units_per_chunk, const Judge& judge_units,
            const DeclineUnit& decline) {
  const Domain domain{units, units_per_chunk};
  const Judging judge{judge_units, decline};
  const Shard shard = run.division != nullptr ? run.division->shard.value_or(Shard{}) : Shard{};
  const Chunk chunks = shard.chunks(domain.chunks());
  Tally tally = run.division != nullptr && run.division->journal != nullptr
                    ? journaled(run, domain, chunks, judge)
                    : sum(run, chunks.end - chunks.begin, [&](std::uint64_t k, Tally& part) {
                        judge_chunks(run, domain, {chunks.begin + k, chunks.begin + k + 1}, judge, part);
                      });
  if (run.division != nullptr) {
    const Chunk share = domain.units_of(chunks);
    run.division->share = {std::min(share.begin, units), share.end, units};
    run.division->finished = !interrupted();
  }
  return tally;
}

}  // namespace mmverify::proofs
