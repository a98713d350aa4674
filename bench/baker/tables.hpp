// Somebody's baker on real content, beside ours.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/result.hpp"

namespace mmverify::bench {

/// All triangles at one level.
struct BakerLevel {
  std::uint32_t level = 0;
  std::uint64_t triangles = 0, outside = 0,
                declined = 0;         ///< outside: beyond what the baker declares, not asked
  std::uint64_t micro_triangles = 0;  ///< of those that it baked
  std::uint64_t wrong = 0;            ///< O or T, and not so on all of it
  std::uint64_t needless = 0;         ///< unknown, and not so
  double ns = 0;      ///< a micro-triangle: question, answer and the worker's isolation included
  double our_ns = 0;  ///< the same of ours, its texture made ready
};

struct BakerFigures {
  std::string baker, file;
  std::vector<BakerLevel> levels;
};

Result baker_tables(const BakerFigures& figures);

}  // namespace mmverify::bench
