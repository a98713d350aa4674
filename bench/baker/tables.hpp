// The figures of a stranger's baker on real content, beside ours.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/result.hpp"

namespace mmverify::bench {

/// The figures of all triangles at one level.
struct BakerLevel {
  std::uint32_t level = 0;
  std::uint64_t triangles = 0, outside = 0,
                declined = 0;         ///< outside: beyond what the baker declares, so it gets no question
  std::uint64_t micro_triangles = 0;  ///< of the triangles that it baked
  std::uint64_t wrong = 0;            ///< O or T, but not on the whole micro-triangle
  std::uint64_t needless = 0;         ///< unknown, but one state on the whole micro-triangle
  double ns = 0;      ///< a micro-triangle: question, answer and the worker's isolation included
  double our_ns = 0;  ///< the time of our baker, without the preparation of its texture
};

struct BakerFigures {
  std::string baker, file;
  std::vector<BakerLevel> levels;
};

Result baker_tables(const BakerFigures& figures);

}  // namespace mmverify::bench
