// The cost of a sweep of index.equals_reference from level to level, beside the obvious loop.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bench/result.hpp"

namespace mmverify::bench {

/// One subject's sweep of a level.
struct Swept {
  double seconds = 0, per_second = 0;  ///< cells
  std::optional<double> ratio =
      {};  ///< per_second / the plain loop's, at the highest level where the plain loop was run
  std::optional<double> growth = {};  ///< seconds / those of the level below
};

struct SweepLevel {
  std::uint32_t level = 0;
  std::uint64_t cells = 0;
  std::optional<double> plain_per_second = {};  ///< of the plain loop, if it is short
  Swept step = {}, impl = {};
  double peak_megabytes = 0;  ///< of the process so far
};

struct SweepFigures {
  unsigned threads = 1;
  std::uint32_t last_plain = 0;  ///< the highest level where the plain loop is run
  std::vector<SweepLevel> levels;
};

Result sweep_tables(const SweepFigures& figures);

}  // namespace mmverify::bench
