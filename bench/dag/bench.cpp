#include "bench/dag/bench.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

#include "bench/timing.hpp"
#include "bench/tree/maps.hpp"
#include "impl/tree/tree.hpp"

namespace mmverify::bench {
namespace {

using Map = std::vector<std::uint8_t>;
constexpr std::size_t rounds = 5;
constexpr std::uint64_t record_bytes = 8;

/// The number of maps of a level: 256, or as many 4-state maps as 64 MiB take.
std::size_t map_count(std::uint32_t level) {
  return std::min<std::size_t>(256, (std::size_t{64} << 20) * 4 >> (2 * level));
}

std::vector<Map> maps_of(std::uint32_t level, std::uint32_t bits, std::uint64_t seed) {
  std::vector<Map> maps;
  const std::size_t count = map_count(level);
  for (std::size_t k = 0; k < count; ++k)
    maps.push_back(k % 5 == 4 ? maps[k - 4]
                              : leaf_map(level, static_cast<impl::tree::Format>(bits), seed * 1000 + k));
  return maps;
}

class Measured {
 public:
  Measured(std::uint32_t level, std::uint32_t bits, const DagBenchOptions& options)
      : level_(level), bits_(bits), seed_(options.seed), maps_(maps_of(level, bits, options.seed)) {
    std::mt19937_64 random(options.seed * 64 + level * 2 + bits);
    for (std::uint64_t k = 0; k < options.lookups; ++k) {
      which_.push_back(static_cast<std::uint32_t>(random() % maps_.size()));
      index_.push_back(static_cast<std::uint32_t>(random() >> 32) &
                       static_cast<std::uint32_t>((std::uint64_t{1} << (2 * level)) - 1));
    }
  }

  DagFigures figures() {
    DagFigures f;
    f.level = level_;
    f.bits = bits_;
    f.maps = maps_.size();
    std::vector<double> build;
    impl::dag::Dag dag(impl::dag::Format{bits_});
    for (std::size_t round = 0; round < rounds; ++round) {
      dag = impl::dag::Dag(impl::dag::Format{bits_});
      build.push_back(once_ns([&] {
        for (const Map& map : maps_) dag.add(level_, map);
      }));
    }
    f.build_rate = 1e3 * static_cast<double>(maps_.size() << (2 * level_)) / median(build);
    std::vector<impl::tree::Tree> trees;
    std::vector<const impl::tree::Tree*> pointers;
    std::set<Map> once;
    DagFormFigures* const form = f.forms.data();
    for (std::size_t k = 0; k < dag_forms; ++k) form[k].bytes = record_bytes * maps_.size();
    const auto of = [&](DagForm which) -> DagFormFigures& { return form[static_cast<std::size_t>(which)]; };
    for (const Map& map : maps_) {
      trees.push_back(impl::tree::Tree::encode(level_, static_cast<impl::tree::Format>(bits_), map));
      const impl::tree::Stream stream =
          impl::tree::encode_stream(level_, static_cast<impl::tree::Format>(bits_), map);
      of(DagForm::flat).bytes += map.size();
      if (once.insert(map).second) of(DagForm::once).bytes += map.size();
      of(DagForm::paper).bytes += stream.tree.size() + stream.data.size();
      of(DagForm::ranked).bytes += trees.back().bits() / 8;
    }
    for (const impl::tree::Tree& tree : trees) pointers.push_back(&tree);
    of(DagForm::dag).bytes = dag.bits() / 8;
    f.tiles = dag.tiles().size_bytes();
    f.nodes = dag.nodes().size_bytes();
    f.flat = dag.flat().size_bytes();
    f.once_over_dag =
        static_cast<double>(of(DagForm::once).bytes) / static_cast<double>(of(DagForm::dag).bytes);

    std::vector<std::uint8_t> flat(which_.size()), ranked(which_.size()), graph(which_.size());
    std::vector<double> ns[3], ratio;
    for (std::size_t round = 0; round < rounds; ++round) {
      ns[0].push_back(once_ns([&] { look_up_flat(flat); }));
      ns[1].push_back(once_ns([&] { impl::tree::lookup(pointers, which_, index_, ranked); }));
      ns[2].push_back(once_ns([&] { dag.lookup(which_, index_, graph); }));
      ratio.push_back(ns[2].back() / ns[0].back());
    }
    if (flat != ranked || flat != graph) throw std::runtime_error("dag bench: two forms give other states");
    const auto each = static_cast<double>(which_.size());
    of(DagForm::flat).take(spread_of(ns[0], each));
    of(DagForm::ranked).take(spread_of(ns[1], each));
    of(DagForm::dag).take(spread_of(ns[2], each));
    f.dag_over_flat = median(ratio);
    f.csm = csm_figures({.level = level_,
                         .bits = bits_,
                         .flat_bytes = of(DagForm::flat).bytes,
                         .maps = maps_,
                         .seed = seed_,
                         .lookups = which_.size()},
                        dag);
    return f;
  }

 private:
  void look_up_flat(std::vector<std::uint8_t>& state) const {
    const std::uint32_t mask = (1u << bits_) - 1;
    for (std::size_t k = 0; k < state.size(); ++k) {
      const std::uint64_t bit = std::uint64_t{index_[k]} * bits_;
      state[k] = static_cast<std::uint8_t>(maps_[which_[k]][bit / 8] >> bit % 8 & mask);
    }
  }

  std::uint32_t level_, bits_;
  std::uint64_t seed_;
  std::vector<Map> maps_;
  std::vector<std::uint32_t> which_, index_;
};

}  // namespace

const char* to_string(DagForm form) {
  constexpr const char* names[] = {"flat", "once", "paper", "ranked", "dag"};
  return names[static_cast<std::size_t>(form)];
}

std::vector<DagFigures> dag_figures(const DagBenchOptions& options) {
  std::vector<DagFigures> all;
  for (const std::uint32_t bits : {1u, 2u})
    for (std::uint32_t level = options.first; level <= options.last; ++level) {
      if (options.progress)
        options.progress(std::to_string(2 * bits) + " states, level " + std::to_string(level));
      all.push_back(Measured(level, bits, options).figures());
    }
  return all;
}

}  // namespace mmverify::bench
