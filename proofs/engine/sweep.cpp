#include "proofs/engine/sweep.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>

#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs {

Tally sweep(const Run& run, std::uint64_t units, std::uint64_t units_per_chunk,
            const std::function<void(Chunk, Tally&)>& judge) {
  using Chunks = oneapi::tbb::blocked_range<std::uint64_t>;
  const std::uint64_t chunks = units / units_per_chunk + (units % units_per_chunk != 0 ? 1 : 0);
  const auto run_chunks = [&](const Chunks& range, Tally tally) {
    for (std::uint64_t c = range.begin(); c != range.end() && !interrupted(); ++c) {
      const std::uint64_t begin = c * units_per_chunk, before = tally.cases();
      judge({begin, std::min(begin + units_per_chunk, units)}, tally);
      if (run.progress != nullptr) run.progress->add(tally.cases() - before);
    }
    return tally;
  };
  const auto merge = [](Tally a, const Tally& b) {
    a.merge(b);
    return a;
  };
  const auto all = [&] {
    return oneapi::tbb::parallel_reduce(Chunks(0, chunks), Tally(run.errors), run_chunks, merge);
  };
  return run.arena != nullptr ? run.arena->execute(all) : run_chunks(Chunks(0, chunks), Tally(run.errors));
}

}  // namespace mmverify::proofs
