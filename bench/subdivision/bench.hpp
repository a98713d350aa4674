// The times of the cells of shapes that are cut again and again, and the sizes of trees for maps of displacements.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mmverify::bench {

struct SubdivisionBenchOptions {
  std::uint32_t first = 2, last = 8;  ///< levels; the bisection's are twice as high
  std::uint64_t seed = 1;
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// The times of one scheme at one level; the specification, child by child, in binary64.
struct SubdivisionTimes {
  std::string scheme;
  std::uint32_t level = 0;
  double index_ns = 0, index_ratio = 0;      ///< of the library; the specification's time / the library's
  double corners_ns = 0, corners_ratio = 0;  ///< likewise
};

/// Throws std::runtime_error if the two give different cells.
std::vector<SubdivisionTimes> subdivision_times(const SubdivisionBenchOptions& options);

/// A map of the least and the greatest displacement in each micro-triangle, in bytes.
struct DisplacementSizes {
  std::string field;
  std::uint32_t bits = 0, level = 0;  ///< bits of each of the two codes
  std::uint64_t flat = 0;
  std::uint64_t tree = 0;  ///< the tree of opacity maps: a leaf where four siblings have one pair
  std::uint64_t narrowing =
      0;  ///< the tree of ranges: a node's pair in as many bits as its parent's range takes
};

/// Made height fields: a fractal terrain, smooth bumps, and a plain with a mound.
/// Throws std::runtime_error if a tree does not give its map back.
std::vector<DisplacementSizes> displacement_sizes(const SubdivisionBenchOptions& options);

}  // namespace mmverify::bench
