// The time to build arrays of many triangles, and the savings of sharing and merging.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mmverify::bench {

struct ArrayBenchOptions {
  std::uint32_t first = 2, last = 6;  ///< levels, both included; last at most 8
  std::uint64_t seed = 1;             ///< of the maps
  std::size_t rounds = 3;             ///< of the timing; at least 1
  std::size_t triangles = 2048;       ///< a third of them equal to others, a third all but for a few states
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// The figures of one level, 4-state.
struct ArrayFigures {
  std::uint32_t level = 0;
  std::uint64_t triangles = 0;
  std::uint64_t records_all = 0, records_shared = 0,
                records_merged = 0;  ///< without sharing, with, and with merging
  double unknown_added = 0;          ///< the share of all micro-triangles that merging made unknown
  double shared_ns = 0, obvious_ns = 0, merged_ns = 0;  ///< ns a triangle, medians over the rounds
  double obvious_over_shared = 0;                       ///< the median of each round's ratio
};

/// The figures of generated maps; every answer is resolved on the way.  Throws std::invalid_argument unless
/// first <= last <= 8 and rounds and triangles are above 0, std::runtime_error if a triangle does not resolve
/// to its map.
std::vector<ArrayFigures> array_figures(const ArrayBenchOptions& options = {});

}  // namespace mmverify::bench
