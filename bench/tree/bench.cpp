#include "bench/tree/bench.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>

#include "bench/textures/alpha_textures.hpp"
#include "bench/timing.hpp"
#include "bench/tree/cache.hpp"
#include "bench/tree/maps.hpp"
#include "bench/tree/obvious.hpp"
#include "bench/tree/sdsl.hpp"
#include "bench/tree/textures.hpp"
#include "impl/tree/tree.hpp"

namespace mmverify::bench {
namespace {

using impl::tree::Format;
using impl::tree::Level;
using impl::tree::Stream;
using impl::tree::Tree;
using Map = std::vector<std::uint8_t>;

constexpr std::uint64_t modelled = 20'000;  // lookups that the cache model follows

/// The ns of a call, divided by `parts`.
template <class Call>
double timed(double parts, Call call) {
  const double start = thread_ns();
  call();
  return (thread_ns() - start) / parts;
}

std::uint8_t flat_state(const Map& map, std::uint64_t index, std::uint32_t b) {
  return static_cast<std::uint8_t>(map[index * b / 8] >> (index * b % 8) & ((1u << b) - 1));
}

struct Forms {
  const std::vector<Map>& maps;
  std::vector<Stream> streams;
  std::vector<Tree> trees;
  std::vector<const Tree*> tree_pointers;
  std::vector<SdslTree> sdsl;
};

struct Lookups {
  std::vector<std::uint32_t> which, index;

  std::span<const std::uint32_t> first_index(std::size_t count) const {
    return std::span(index).first(count);
  }
};

/// Makes the optimizer take the value for used.
void keep(std::uint8_t& value) { asm volatile("" : "+r"(value)); }

void compare(const char* who, std::span<const std::uint8_t> got, std::span<const std::uint8_t> expected) {
  if (!std::equal(got.begin(), got.end(), expected.begin(), expected.end()))
    throw std::runtime_error(std::string("tree bench: ") + who + " does not give the map's states");
}

class Measurement {
 public:
  Measurement(Level n, Format b, const std::vector<Map>& maps, const TreeBenchOptions& options)
      : n_(n), bits_(b), b_(static_cast<std::uint32_t>(b)), forms_{maps, {}, {}, {}, {}}, options_(options) {
    std::seed_seq words{static_cast<std::uint32_t>(options.seed),
                        static_cast<std::uint32_t>(options.seed >> 32), n, b_};
    std::mt19937_64 random(words);
    for (std::uint64_t k = 0; k < options.lookups; ++k) {
      lookups_.which.push_back(static_cast<std::uint32_t>(random() % maps.size()));
      lookups_.index.push_back(static_cast<std::uint32_t>(random() >> 32) &
                               static_cast<std::uint32_t>((std::uint64_t{1} << (2 * n)) - 1));
    }
    for (const Map& map : maps) {
      forms_.streams.push_back(impl::tree::encode_stream(n, b, map));
      forms_.trees.push_back(Tree::encode(n, b, map));
      forms_.sdsl.emplace_back(n, b, map);
    }
    for (const Tree& tree : forms_.trees) forms_.tree_pointers.push_back(&tree);
  }

  TreeFigures run() {
    TreeFigures f;
    f.level = n_;
    f.bits = b_;
    f.maps = forms_.maps.size();
    sizes(f);
    lines(f);
    lookups(f);
    whole_maps(f);
    return f;
  }

 private:
  TreeFormFigures& form(TreeFigures& f, TreeForm which) { return f.forms[static_cast<std::size_t>(which)]; }

  void sizes(TreeFigures& f) {
    const double micro_triangles =
        static_cast<double>(forms_.maps.size()) * static_cast<double>(std::uint64_t{1} << (2 * n_));
    double paper = 0, ours = 0, sdsl = 0, nodes = 0, flat = 0;
    for (std::size_t k = 0; k < forms_.maps.size(); ++k) {
      const Stream& s = forms_.streams[k];
      flat += 8 * static_cast<double>(forms_.maps[k].size());
      paper += static_cast<double>(s.nodes + s.leaves * b_);
      ours += static_cast<double>(forms_.trees[k].bits());
      sdsl += static_cast<double>(forms_.sdsl[k].bits());
      nodes += static_cast<double>(s.nodes);
    }
    form(f, TreeForm::flat).bits = flat / micro_triangles;
    form(f, TreeForm::paper).bits = paper / micro_triangles;
    form(f, TreeForm::ours).bits = ours / micro_triangles;
    form(f, TreeForm::sdsl).bits = sdsl / micro_triangles;
    f.memory_over_paper = ours / paper;
    f.nodes = nodes / static_cast<double>(forms_.maps.size());
  }

  void lines(TreeFigures& f) {
    const std::uint64_t count = std::min(modelled, options_.lookups);
    double paper = 0, ours = 0, sdsl = 0, read = 0;
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint32_t which = lookups_.which[k], index = lookups_.index[k];
      const StreamReads reads = stream_reads(n_, forms_.streams[which], index);
      paper += static_cast<double>(reads.lines);
      read += static_cast<double>(reads.tree_bits);
      ours += static_cast<double>(tree_lines(forms_.trees[which], index));
      sdsl += static_cast<double>(forms_.sdsl[which].lines(index));
    }
    const auto of = static_cast<double>(count);
    form(f, TreeForm::flat).lines = 1;
    form(f, TreeForm::paper).lines = paper / of;
    form(f, TreeForm::ours).lines = ours / of;
    form(f, TreeForm::sdsl).lines = sdsl / of;
    f.bits_read = read / of;
  }

  void flat_lookups(std::span<std::uint8_t> state) const {
    const std::uint32_t log_b = b_ - 1, mask = (1u << b_) - 1;
    for (std::size_t k = 0; k < state.size(); ++k) {
      const std::uint32_t bit = lookups_.index[k] << log_b;
      state[k] = static_cast<std::uint8_t>(forms_.maps[lookups_.which[k]][bit / 8] >> (bit % 8) & mask);
    }
  }
  void paper_lookups(std::span<std::uint8_t> state) const {
    for (std::size_t k = 0; k < state.size(); ++k)
      state[k] = impl::tree::lookup_stream(n_, bits_, forms_.streams[lookups_.which[k]], lookups_.index[k]);
  }

  /// The time of a chain of lookups: each index is changed by the state before it.
  template <class Find>
  double chained(std::size_t count, Find find) const {
    return timed(static_cast<double>(count), [&] {
      std::uint8_t state = 0;
      for (std::size_t k = 0; k < count; ++k)
        state = find(lookups_.which[k], lookups_.index[k] ^ (n_ > 0 ? state : 0u));
      keep(state);
    });
  }

  void lookups(TreeFigures& f) {
    const auto count = static_cast<std::size_t>(options_.lookups);
    // The count takes about 0.2 s a round, at some 2 ns a bit.
    const std::size_t paper_count =
        std::clamp<std::size_t>(static_cast<std::size_t>(1e8 / std::max(f.bits_read, 1.0)),
                                std::min<std::size_t>(count, 1000), count);
    std::vector<std::uint8_t> expected(count), state(count);
    flat_lookups(expected);
    std::array<std::vector<double>, tree_forms> ns, chained_ns;
    std::vector<double> paper_over_ours, sdsl_over_ours, ours_over_flat;
    for (std::size_t round = 0; round < options_.rounds; ++round) {
      std::array<double, tree_forms> now{}, chain{};
      const auto measure = [&](TreeForm which, std::size_t lookups, auto all, auto one) {
        std::fill(state.begin(), state.end(), std::uint8_t{255});
        const std::span<std::uint8_t> out(state.data(), lookups);
        const auto k = static_cast<std::size_t>(which);
        now[k] = timed(static_cast<double>(lookups), [&] { all(out); });
        compare(to_string(which), out, std::span(expected).first(lookups));
        chain[k] = chained(std::max<std::size_t>(lookups / 4, 1), one);
        ns[k].push_back(now[k]);
        chained_ns[k].push_back(chain[k]);
      };
      measure(
          TreeForm::flat, count, [&](std::span<std::uint8_t> out) { flat_lookups(out); },
          [&](std::uint32_t w, std::uint32_t i) { return flat_state(forms_.maps[w], i, b_); });
      measure(
          TreeForm::ours, count,
          [&](std::span<std::uint8_t> out) {
            impl::tree::lookup(forms_.tree_pointers, lookups_.which, lookups_.index, out);
          },
          [&](std::uint32_t w, std::uint32_t i) { return forms_.trees[w][i]; });
      measure(
          TreeForm::sdsl, count,
          [&](std::span<std::uint8_t> out) {
            SdslTree::lookup(forms_.sdsl, lookups_.which, lookups_.index, out);
          },
          [&](std::uint32_t w, std::uint32_t i) { return forms_.sdsl[w][i]; });
      measure(
          TreeForm::paper, paper_count, [&](std::span<std::uint8_t> out) { paper_lookups(out); },
          [&](std::uint32_t w, std::uint32_t i) {
            return impl::tree::lookup_stream(n_, bits_, forms_.streams[w], i);
          });
      const auto at = [&now](TreeForm which) { return now[static_cast<std::size_t>(which)]; };
      paper_over_ours.push_back(at(TreeForm::paper) / at(TreeForm::ours));
      sdsl_over_ours.push_back(at(TreeForm::sdsl) / at(TreeForm::ours));
      ours_over_flat.push_back(at(TreeForm::ours) / at(TreeForm::flat));
    }
    for (std::size_t k = 0; k < tree_forms; ++k) {
      const Spread lookup = spread_of(ns[k]);
      f.forms[k].ns = lookup.median;
      f.forms[k].least_ns = lookup.least;
      f.forms[k].most_ns = lookup.most;
      f.forms[k].chained_ns = median(chained_ns[k]);
    }
    f.paper_over_ours = median(paper_over_ours);
    f.sdsl_over_ours = median(sdsl_over_ours);
    f.ours_over_flat = median(ours_over_flat);
  }

  void whole_maps(TreeFigures& f) {
    // The count takes about 30 ms of the obvious way a round.
    const double states = static_cast<double>(std::uint64_t{1} << (2 * n_));
    const auto most = static_cast<std::size_t>(std::max(2e7 / states, 1.0));
    const std::size_t count = std::min(forms_.maps.size(), most);
    const auto of = static_cast<double>(count);
    Map out(forms_.maps[0].size());
    std::array<std::vector<double>, 6> ns;
    const auto each = [&](std::size_t slot, auto call) {
      ns[slot].push_back(timed(of, [&] {
        for (std::size_t k = 0; k < count; ++k) call(k);
      }));
    };
    std::uint64_t sum = 0;
    for (std::size_t round = 0; round < options_.rounds; ++round) {
      each(0, [&](std::size_t k) { sum += obvious_encode(n_, bits_, forms_.maps[k]).nodes; });
      each(1, [&](std::size_t k) { sum -= impl::tree::encode_stream(n_, bits_, forms_.maps[k]).nodes; });
      each(2, [&](std::size_t k) { sum += Tree::encode(n_, bits_, forms_.maps[k]).level() - n_; });
      each(3, [&](std::size_t k) { obvious_decode(n_, bits_, forms_.streams[k], out); });
      compare("the obvious decoder", out, forms_.maps[count - 1]);
      each(4, [&](std::size_t k) { impl::tree::decode_stream(n_, bits_, forms_.streams[k], out); });
      compare("decode_stream", out, forms_.maps[count - 1]);
      each(5, [&](std::size_t k) { forms_.trees[k].decode(out); });
      compare("Tree::decode", out, forms_.maps[count - 1]);
    }
    if (sum != 0) throw std::runtime_error("tree bench: the obvious encoder makes another tree");
    f.obvious_encode = median(ns[0]);
    f.encode_stream = median(ns[1]);
    f.encode_tree = median(ns[2]);
    f.obvious_decode = median(ns[3]);
    f.decode_stream = median(ns[4]);
    f.decode_tree = median(ns[5]);
  }

  Level n_;
  Format bits_;
  std::uint32_t b_;
  Forms forms_;
  Lookups lookups_;
  const TreeBenchOptions& options_;
};

}  // namespace

const char* to_string(TreeForm form) {
  switch (form) {
    case TreeForm::flat: return "flat";
    case TreeForm::paper: return "paper";
    case TreeForm::ours: return "ours";
    case TreeForm::sdsl: break;
  }
  return "sdsl";
}

std::size_t tree_map_count(std::uint32_t level, Format bits) {
  constexpr std::uint64_t all = std::uint64_t{64} << 20, most = 1024;
  const std::uint64_t bytes =
      std::max<std::uint64_t>((std::uint64_t{static_cast<std::uint32_t>(bits)} << (2 * level)) / 8, 1);
  return static_cast<std::size_t>(std::min(most, all / bytes));
}

TreeFigures measure_trees(std::uint32_t level, Format bits, const std::vector<Map>& maps,
                          const TreeBenchOptions& options) {
  if (level > impl::tree::max_level || maps.empty() || options.rounds == 0 || options.lookups == 0)
    throw std::invalid_argument("tree bench: levels up to 12, a map, a round and a lookup at least");
  return Measurement(level, bits, maps, options).run();
}

std::vector<TreeFigures> tree_figures(const TreeBenchOptions& options) {
  if (options.first > options.last || options.last > impl::tree::max_level)
    throw std::invalid_argument("tree bench: levels are A..B with A <= B <= 12");
  std::vector<AlphaTexture> textures;
  if (!options.textures.empty()) textures = alpha_textures(options.textures);
  std::vector<TreeFigures> figures;
  for (const Format bits : {Format::two_state, Format::four_state})
    for (std::uint32_t level = options.first; level <= options.last; ++level) {
      if (options.progress)
        options.progress("level " + std::to_string(level) + ", " + (bits == Format::two_state ? "2" : "4") +
                         " states");
      std::vector<Map> maps;
      if (textures.empty())
        for (std::size_t k = 0; k < tree_map_count(level, bits); ++k)
          maps.push_back(leaf_map(level, bits, options.seed + k));
      else
        maps = texture_maps(textures, level, bits);
      figures.push_back(measure_trees(level, bits, maps, options));
    }
  return figures;
}

}  // namespace mmverify::bench
