#include "bench/scene/dag.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <span>
#include <stdexcept>
#include <string_view>

#include "bench/scene/compressors.hpp"
#include "bench/scene/state_entropy.hpp"
#include "bench/timing.hpp"
#include "impl/dag/dag.hpp"
#include "impl/tree/tree.hpp"
#include "scene/read/load.hpp"

namespace mmverify::bench {
namespace {

using Map = std::vector<std::uint8_t>;
using impl::micromap::Format;

constexpr std::size_t rounds = 5, build_rounds = 3;
constexpr double long_build_ns = 1e9;  // one such round is enough
constexpr std::uint64_t record_bytes = 8;
constexpr std::size_t levels_of_growth = 5;

/// About a quarter of a second, for work in proportion to the map.
constexpr double paper_ns = 0.25e9;
constexpr std::size_t tried = 64;

/// An array in which equal maps are stored once, one after the other, and the place where each map begins.
struct FlatArray {
  Map bytes;
  std::vector<std::uint32_t> number;  ///< of the distinct map, by map
  std::vector<std::uint64_t> begins;  ///< by map
  std::vector<std::size_t> first;     ///< by distinct map, a map that is equal

  explicit FlatArray(const std::vector<Map>& maps) {
    std::map<std::string_view, std::uint32_t> known;
    for (std::size_t k = 0; k < maps.size(); ++k) {
      const std::string_view content(reinterpret_cast<const char*>(maps[k].data()), maps[k].size());
      const auto [found, is_new] = known.try_emplace(content, static_cast<std::uint32_t>(first.size()));
      if (is_new) {
        first.push_back(k);
        bytes.insert(bytes.end(), maps[k].begin(), maps[k].end());
      }
      number.push_back(found->second);
      begins.push_back(std::uint64_t{found->second} * maps[k].size());
    }
  }
};

class Comparison {
 public:
  Comparison(const MapsAtLevel& in, const SceneDagOptions& options)
      : in_(in),
        options_(options),
        format_(static_cast<Format>(in.bits)),
        flat_(in.maps),
        dag_(dag_format()) {
    f_.level = in.level;
    f_.bits = in.bits;
    f_.taken = in.taken;
    f_.uniform = in.uniform;
    f_.maps = in.maps.size();
    f_.distinct = flat_.first.size();
  }

  SceneDagFigures figures() {
    flat_sizes();
    trees();
    graph();
    compressors();
    entropy();
    lookups();
    stop();
    f_.csm = csm_figures({.level = in_.level,
                          .bits = in_.bits,
                          .flat_bytes = form(SceneForm::flat).bytes,
                          .maps = in_.maps,
                          .seed = options_.seed,
                          .lookups = options_.lookups,
                          .stop = options_.stop},
                         dag_);
    return f_;
  }

 private:
  impl::dag::Format dag_format() const { return impl::dag::Format{in_.bits}; }
  SceneFormFigures& form(SceneForm which) { return f_.forms[static_cast<std::size_t>(which)]; }
  void stop() const {
    if (options_.stop) options_.stop();
  }

  double rate(std::uint64_t maps, double ns) const {
    return 1e3 * static_cast<double>(maps << (2 * in_.level)) / ns;
  }

  /// The median time of some rounds.
  template <class Work>
  double built_in(const Work& work) const {
    std::vector<double> ns;
    do {
      stop();
      ns.push_back(once_ns(work));
    } while (ns.size() < build_rounds && ns.back() < long_build_ns);
    return median(ns);
  }

  void flat_sizes() {
    for (std::size_t k = 0; k < in_.maps.size(); ++k)
      form(SceneForm::flat).bytes += in_.triangles[k] * (in_.maps[k].size() + record_bytes);
    form(SceneForm::once).bytes = record_bytes * f_.maps + flat_.bytes.size();
  }

  void trees() {
    const auto level = in_.level;
    const auto encoded = [&](auto encode, auto& into) {
      return rate(f_.distinct, built_in([&] {
                    into.clear();
                    for (const std::size_t k : flat_.first) into.push_back(encode(in_.maps[k]));
                  }));
    };
    form(SceneForm::paper).build_rate =
        encoded([&](const Map& map) { return impl::tree::encode_stream(level, format_, map); }, streams_);
    form(SceneForm::ranked).build_rate =
        encoded([&](const Map& map) { return impl::tree::Tree::encode(level, format_, map); }, trees_);
    form(SceneForm::paper).bytes = form(SceneForm::ranked).bytes = record_bytes * f_.maps;
    for (const impl::tree::Stream& s : streams_)
      form(SceneForm::paper).bytes += s.tree.size() + s.data.size();
    for (const impl::tree::Tree& t : trees_) form(SceneForm::ranked).bytes += (t.bits() + 7) / 8;
  }

  void graph() {
    const double ns = built_in([&] {
      dag_ = impl::dag::Dag(dag_format());
      for (const Map& map : in_.maps) dag_.add(in_.level, map);
    });
    form(SceneForm::dag).build_rate = rate(f_.maps, ns);
    form(SceneForm::dag).bytes = dag_.bits() / 8;
    Map again(in_.maps[0].size());
    for (std::uint32_t k = 0; k < dag_.maps(); ++k) {
      dag_.decode(k, again);
      if (again != in_.maps[k]) throw std::runtime_error("dag bench: the graph does not give the map again");
    }
  }

  void compressors() {
    for (const auto& [which, how] :
         {std::pair{SceneForm::lz4, Compressor::lz4}, {SceneForm::zstd, Compressor::zstd}}) {
      stop();
      Map packed;
      const double ns = once_ns([&, coder = how] { packed = compressed(coder, flat_.bytes); });
      form(which).bytes = packed.size();
      form(which).build_rate = rate(f_.distinct, ns);
      if (decompressed(how, packed, flat_.bytes.size()) != flat_.bytes)
        throw std::runtime_error("dag bench: a compressor does not give the maps again");
    }
  }

  void entropy() {
    StateEntropy entropy(in_.bits);
    for (const std::size_t k : flat_.first) {
      stop();
      entropy.add(in_.maps[k], impl::micromap::micro_triangles(in_.level));
    }
    f_.order_0_bytes = entropy.order_0_bytes();
    f_.context_bytes = entropy.context_bytes();
  }

  void look_up_flat(std::span<std::uint8_t> state) const {
    const std::uint32_t mask = (1u << in_.bits) - 1;
    for (std::size_t k = 0; k < state.size(); ++k) {
      const std::uint64_t bit = std::uint64_t{index_[k]} * in_.bits;
      state[k] = static_cast<std::uint8_t>(flat_.bytes[flat_.begins[which_[k]] + bit / 8] >> bit % 8 & mask);
    }
  }

  void look_up_paper(std::span<std::uint8_t> state) const {
    for (std::size_t k = 0; k < state.size(); ++k)
      state[k] = impl::tree::lookup_stream(in_.level, format_, streams_[flat_.number[which_[k]]], index_[k]);
  }

  void lookups() {
    std::mt19937_64 random(options_.seed * 64 + in_.level * 2 + in_.bits);
    const auto count = static_cast<std::size_t>(options_.lookups);
    for (std::size_t k = 0; k < count; ++k) {
      which_.push_back(static_cast<std::uint32_t>(random() % f_.maps));
      index_.push_back(static_cast<std::uint32_t>(random() >> 32) &
                       static_cast<std::uint32_t>((std::uint64_t{1} << (2 * in_.level)) - 1));
    }
    std::vector<const impl::tree::Tree*> pointers;
    for (const std::uint32_t number : flat_.number) pointers.push_back(&trees_[number]);
    Map expected(count), state(count);
    look_up_flat(expected);
    const double one = once_ns([&] { look_up_paper(std::span(state).first(std::min(tried, count))); }) /
                       static_cast<double>(std::min(tried, count));
    const std::size_t few =
        std::clamp(static_cast<std::size_t>(paper_ns / static_cast<double>(rounds) / std::max(one, 1.0)),
                   std::min(tried, count), count);
    std::map<SceneForm, std::vector<double>> ns, ratios;
    const auto measured = [&](SceneForm which, std::size_t some, auto look_up) {
      stop();
      const std::span<std::uint8_t> out(state.data(), some);
      std::fill(out.begin(), out.end(), std::uint8_t{255});
      ns[which].push_back(once_ns([&] { look_up(out); }) / static_cast<double>(some));
      ratios[which].push_back(ns[which].back() / ns[SceneForm::once].back());
      if (!std::equal(out.begin(), out.end(), expected.begin()))
        throw std::runtime_error(std::string("dag bench: ") + to_string(which) + " gives other states");
    };
    for (std::size_t round = 0; round < rounds; ++round) {
      measured(SceneForm::once, count, [&](std::span<std::uint8_t> out) { look_up_flat(out); });
      measured(SceneForm::ranked, count,
               [&](std::span<std::uint8_t> out) { impl::tree::lookup(pointers, which_, index_, out); });
      measured(SceneForm::dag, count, [&](std::span<std::uint8_t> out) { dag_.lookup(which_, index_, out); });
      measured(SceneForm::paper, few, [&](std::span<std::uint8_t> out) { look_up_paper(out); });
    }
    for (const auto& [which, all] : ns) {
      form(which).ns = median(all);
      form(which).ns_to_once = median(ratios[which]);
    }
  }

  const MapsAtLevel& in_;
  const SceneDagOptions& options_;
  Format format_;
  FlatArray flat_;
  std::vector<impl::tree::Stream> streams_;
  std::vector<impl::tree::Tree> trees_;
  impl::dag::Dag dag_;
  std::vector<std::uint32_t> which_, index_;
  SceneDagFigures f_;
};

}  // namespace

const char* to_string(SceneForm form) {
  constexpr const char* names[] = {"flat", "once", "paper", "ranked", "dag", "lz4", "zstd"};
  return names[static_cast<std::size_t>(form)];
}

std::string area_or_outline(const Growth& growth) {
  constexpr double near = 0.15;
  if (growth.law == GrowthLaw::none || growth.law == GrowthLaw::too_few) return to_string(growth);
  const double slope = growth.exponential.slope;
  if (std::abs(slope - 2) < near) return "4^n, the area";
  if (std::abs(slope - 1) < near) return "2^n, the outline";
  if (growth.law == GrowthLaw::flat) return to_string(growth);
  char text[64];
  std::snprintf(text, sizeof text, "x%.2f each level", std::exp2(slope));
  return text;
}

SceneDagFigures scene_dag_figures(const MapsAtLevel& in, const SceneDagOptions& options) {
  if (in.maps.empty() || options.lookups == 0)
    throw std::invalid_argument("dag bench: a map and a lookup at least");
  return Comparison(in, options).figures();
}

std::vector<SceneGrowth> scene_growth(const std::vector<SceneDagFigures>& rows) {
  std::vector<SceneGrowth> all;
  for (const std::uint32_t bits : {1u, 2u}) {
    std::vector<const SceneDagFigures*> of_format;
    for (const SceneDagFigures& row : rows)
      if (row.bits == bits) of_format.push_back(&row);
    if (of_format.empty()) continue;
    if (of_format.size() > levels_of_growth)
      of_format.erase(of_format.begin(), of_format.end() - levels_of_growth);
    for (std::size_t k = 0; k < scene_forms; ++k) {
      std::vector<LevelValue> values;
      for (const SceneDagFigures* row : of_format)
        values.push_back(
            {row->level, static_cast<double>(row->forms[k].bytes) / static_cast<double>(row->maps)});
      all.push_back({bits, static_cast<SceneForm>(k), fit_growth(values)});
    }
  }
  return all;
}

SceneDagScene scene_dag(const SceneDagOptions& options) {
  if (options.first > options.last || options.last > impl::dag::max_level || options.lookups == 0)
    throw std::invalid_argument("dag bench: levels are A..B with A <= B <= 12; a lookup at least");
  const auto begins = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  begins(options.file);
  const scene::Scene loaded = scene::load(options.file);
  const scene::Plan planned = scene::plan(loaded);
  SceneDagScene all{options.file,
                    0,
                    planned.triangles.size(),
                    0,
                    {},
                    {},
                    {},
                    {},
                    triangles_left_out(loaded, planned, scene::LeftOut::varying_alpha)};
  if (planned.triangles.empty()) return all;
  const SceneMaps maps(loaded, planned);
  MergedLevels merged;
  all.maps = maps.uses().size();
  for (const MapUse& use : maps.uses()) all.triangles += use.triangles;
  for (std::uint32_t level = options.first; level <= options.last; ++level) {
    begins("level " + std::to_string(level) + ", maps");
    const auto baked = maps.baked(level, maps.fitting(level, options.memory), options.stop);
    for (const Format format : {Format::two_state, Format::four_state}) {
      const MapsAtLevel in = maps.in_format(level, format, baked);
      if (in.maps.empty()) continue;
      begins("level " + std::to_string(level) + ", " + std::to_string(2 * in.bits) + " states, " +
             std::to_string(in.maps.size()) + " maps");
      all.rows.push_back(scene_dag_figures(in, options));
      all.rows.back().all = maps.uses().size();
      merged.add(level, in.bits, in.maps);
    }
  }
  std::stable_sort(all.rows.begin(), all.rows.end(),
                   [](const SceneDagFigures& a, const SceneDagFigures& b) { return a.bits < b.bits; });
  all.merged = merged.bytes();
  begins("squares");
  all.squares = square_figures(loaded, planned, options.first, options.last, options.lookups, options.seed,
                               options.stop);
  all.growth = scene_growth(all.rows);
  return all;
}

}  // namespace mmverify::bench
