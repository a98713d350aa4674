// Our graph beside Common Subtree Merging, on the same maps: sizes, the worst case, times of lookups.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "bench/dag/csm.hpp"
#include "impl/dag/dag.hpp"

namespace mmverify::bench {

/// One level and format.  Sizes are of all maps, with 8 bytes a map for its place.
struct CsmFigures {
  std::uint32_t level = 0, bits = 0;
  std::uint64_t maps = 0;
  std::uint64_t flat_bytes = 0, once_bytes = 0, dag_bytes = 0, csm_bytes = 0;
  std::uint64_t csm_plain_bytes = 0;            ///< without mean opacity
  double dag_worst = 0, csm_worst = 0;          ///< bytes of a map of noise over flat, without its 8 bytes
  double once_ns = 0, dag_ns = 0, csm_ns = 0;   ///< a lookup
  double dag_over_once = 0, csm_over_once = 0;  ///< ns a lookup, the median of the rounds' ratios
  double dag_over_csm = 0;
  double csm_build_rate = 0;  ///< millions of micro-triangles a second
};

/// The maps of one level and format, and where lookups go.
struct CsmInput {
  std::uint32_t level = 0, bits = 0;
  std::uint64_t flat_bytes = 0;  ///< of a map for each triangle, with 8 bytes for its place
  std::span<const std::vector<std::uint8_t>> maps;
  std::uint64_t seed = 1, lookups = 1;
  std::function<void()> stop = {};  ///< called before each step; may throw
};

/// Domain: maps and lookups not empty; dag holds these maps.  Throws std::runtime_error if a state of a map comes back
/// otherwise, from the decoder or from a lookup.
CsmFigures csm_figures(const CsmInput& in, const impl::dag::Dag& dag);

/// The bytes of several levels and formats together: of our graphs, one a format, and of one structure of theirs.
struct MergedBytes {
  std::uint64_t dag = 0, csm = 0;
};

/// The maps of several levels and formats, merged.
class MergedLevels {
 public:
  void add(std::uint32_t level, std::uint32_t bits, std::span<const std::vector<std::uint8_t>> maps);
  MergedBytes bytes() const { return {(dag_[0].bits() + dag_[1].bits()) / 8, csm_.bits() / 8}; }

 private:
  impl::dag::Dag dag_[2] = {impl::dag::Dag(impl::dag::Format::two_state),
                            impl::dag::Dag(impl::dag::Format::four_state)};
  CommonSubtrees csm_{true};
};

}  // namespace mmverify::bench
