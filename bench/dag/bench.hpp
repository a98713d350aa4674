// The sizes of a scene's maps flat, each once, as trees, and in one graph, and the times of lookups there.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/dag/csm_figures.hpp"
#include "bench/timing.hpp"
#include "impl/dag/dag.hpp"

namespace mmverify::bench {

struct DagBenchOptions {
  std::uint32_t first = 3, last = 10;
  std::uint64_t seed = 1;
  std::uint64_t lookups = 1 << 20;                        ///< a level and format
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// The forms, in this order everywhere: flat; flat with equal maps once; the paper's sequences; impl/tree's
/// form; impl/dag's arrays.
enum class DagForm : std::uint8_t { flat, once, paper, ranked, dag };
inline constexpr std::size_t dag_forms = 5;
const char* to_string(DagForm form);

struct DagFormFigures {
  std::uint64_t bytes = 0;  ///< of all maps, with 8 bytes a map for its place
  double ns = 0;            ///< a lookup, over independent random ones on all maps; 0 if not measured
  double least_ns = 0, most_ns = 0;  ///< the same of the fastest round and of the slowest

  void take(const Spread& lookup) {
    ns = lookup.median;
    least_ns = lookup.least;
    most_ns = lookup.most;
  }
};

/// The figures of one level and format.
struct DagFigures {
  std::uint32_t level = 0, bits = 0;  ///< bits a state, 1 or 2
  std::size_t maps = 0;
  std::array<DagFormFigures, dag_forms> forms{};
  std::uint64_t tiles = 0, nodes = 0, flat = 0;  ///< bytes of the graph's arrays
  double once_over_dag = 0;                      ///< bytes
  double dag_over_flat = 0;                      ///< ns a lookup, the median of the rounds' ratios
  double build_rate = 0;  ///< millions of micro-triangles a second, while all maps are added
  CsmFigures csm;

  const DagFormFigures& form(DagForm f) const { return forms[static_cast<std::size_t>(f)]; }
};

/// The figures of generated leaves of a scene of several plants: a fifth of the maps are there twice, as
/// instances of one triangle.
/// Throws std::runtime_error if two forms disagree.
std::vector<DagFigures> dag_figures(const DagBenchOptions& options);

}  // namespace mmverify::bench
