#include "bench/vq/rivals/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "bench/timing.hpp"
#include "bench/vq/rivals/brushes.hpp"
#include "bench/vq/rivals/quad_tree.hpp"
#include "bench/vq/rivals/wavelet.hpp"

namespace mmverify::bench::rivals {
namespace {

/// The maps, budget and VQ of one side.
struct Sixteen {
  static constexpr std::uint32_t side = 16, bits = 256;
  using Block = impl::vq::Block2;
  static constexpr const char* vq = "VQ2, optimal";
  static const impl::vq::Map2& of(const OpacityMaps& maps) { return maps.regions_16; }
  static Block encoded(const impl::vq::Map2& map) { return impl::vq::encode_optimal(map).block; }
};
struct ThirtyTwo {
  static constexpr std::uint32_t side = 32, bits = 512;
  using Block = impl::vq::Block4;
  static constexpr const char* vq = "VQ4, balanced";
  static const impl::vq::Map4& of(const OpacityMaps& maps) { return maps.regions_32; }
  static Block encoded(const impl::vq::Map4& map) { return impl::vq::encode(map).block; }
};

/// VQ with the interface of a rival.
template <class Size>
struct Vq {
  using Block = typename Size::Block;
  Block block(const auto& map) const { return Size::encoded(map); }
  auto decode(const Block& block) const { return impl::vq::decode(block); }
  State region(const Block& block, std::uint32_t x, std::uint32_t y) const {
    return impl::vq::region(block, x, y);
  }
};

/// A rival whose bits are in a block of the budget's length, padded with 0.
template <class Size, class Codec>
struct InBlocks {
  using Block = std::array<std::uint64_t, Size::bits / 64>;
  Codec codec;
  Block block(States map) const {
    const Bits bits = codec.encode(map, Size::bits);
    if (bits.size > Size::bits) throw std::runtime_error("vq rivals: more bits than the block has");
    Block block{};
    std::copy(bits.words.begin(), bits.words.end(), block.begin());
    return block;
  }
  std::vector<State> decode(const Block& block) const { return codec.decode(block, Size::side); }
  State region(const Block& block, std::uint32_t x, std::uint32_t y) const {
    return codec.region(block, Size::side, x, y);
  }
};

void keep(std::uint32_t& value) { asm volatile("" : "+r"(value)); }

/// The number of O and T that became C.  Throws if a region changed otherwise, or if a region read alone
/// differs.
template <class Size, class Codec>
std::uint32_t substitutions(const char* name, const OpacityMaps& maps, const Codec& codec,
                            const typename Codec::Block& block) {
  const auto& map = Size::of(maps);
  const auto out = codec.decode(block);
  std::uint32_t lost = 0;
  for (std::uint32_t k = 0; k < map.size(); ++k) {
    if ((out[k] != map[k] && out[k] != State::C) ||
        out[k] != codec.region(block, k % Size::side, k / Size::side))
      throw std::runtime_error("vq bench: " + std::string(name) + " is wrong on " + maps.of);
    lost += out[k] != map[k] ? 1 : 0;
  }
  return lost;
}

template <class Size, class Codec>
void time_decoding(const std::vector<typename Codec::Block>& blocks, const Codec& codec, std::uint64_t seed,
                   std::size_t rounds, CodecFigures& figures) {
  constexpr std::size_t hits = 1 << 16, decoded = 1 << 9;
  std::mt19937_64 random(seed);
  struct Hit {
    std::uint32_t block, x, y;
  };
  std::vector<Hit> at(hits);
  for (Hit& hit : at)
    hit = {static_cast<std::uint32_t>(random() % blocks.size()),
           static_cast<std::uint32_t>(random() % Size::side),
           static_cast<std::uint32_t>(random() % Size::side)};
  figures.map_ns = median_ns(rounds,
                             [&] {
                               for (std::size_t k = 0; k < decoded; ++k) {
                                 const auto map = codec.decode(blocks[k % blocks.size()]);
                                 asm volatile("" : : "r"(map.data()) : "memory");
                               }
                             }) /
                   decoded;
  std::uint32_t sum = 0;
  figures.region_ns =
      median_ns(rounds,
                [&] {
                  for (const Hit& hit : at)
                    sum += static_cast<std::uint32_t>(codec.region(blocks[hit.block], hit.x, hit.y));
                  keep(sum);
                }) /
      hits;
}

template <class Size, class Codec>
CodecFigures measured(const char* name, const std::vector<OpacityMaps>& all, const Codec& codec,
                      std::uint64_t seed, std::size_t rounds) {
  CodecFigures figures{.side = Size::side, .codec = name, .bits = Size::bits};
  std::vector<typename Codec::Block> blocks;
  std::vector<double> ms;
  for (const OpacityMaps& maps : all) {
    typename Codec::Block block{};
    ms.push_back(once_ns([&] { block = codec.block(Size::of(maps)); }) / 1e6);
    const std::uint32_t lost = substitutions<Size>(name, maps, codec, block);
    const double regions = Size::side * Size::side, share = savings(Size::of(maps));
    figures.substitutions += lost;
    figures.states += static_cast<std::uint64_t>(std::llround(regions * share));
    figures.savings += (share - lost / regions) / static_cast<double>(all.size());
    figures.whole += lost == 0 ? 1 : 0;
    figures.lost.push_back(lost);
    blocks.push_back(block);
  }
  figures.encode_ms = median(ms);
  time_decoding<Size>(blocks, codec, seed, rounds, figures);
  return figures;
}

template <class Size, class Tree>
CodecFigures measured_tree(const char* name, const std::vector<OpacityMaps>& all, const Tree& tree,
                           std::uint64_t seed, std::size_t rounds) {
  CodecFigures figures = measured<Size>(name, all, InBlocks<Size, Tree>{tree}, seed, rounds);
  double bits = 0;
  for (const OpacityMaps& maps : all)
    bits += tree_bits(without_o_beside_t(Size::of(maps)), tree.root, Tree::cost);
  figures.lossless_bits = bits / static_cast<double>(all.size());
  return figures;
}

template <class Size>
void add_codecs(const std::vector<OpacityMaps>& all, std::uint64_t seed, std::size_t rounds,
                std::vector<CodecFigures>& codecs) {
  codecs.push_back(measured<Size>(Size::vq, all, Vq<Size>{}, seed, rounds));
  codecs.push_back(measured_tree<Size>("quad-tree, 3 levels", all, QuadTree{.root = 4}, seed, rounds));
  codecs.push_back(
      measured_tree<Size>("quad-tree, one root", all, QuadTree{.root = Size::side}, seed, rounds));
  codecs.push_back(measured_tree<Size>("wavelet mod 3, 3 levels", all, Wavelet{.root = 4}, seed, rounds));
  codecs.push_back(
      measured_tree<Size>("wavelet mod 3, one root", all, Wavelet{.root = Size::side}, seed, rounds));
  const auto brushes = [&](const char* name, std::uint32_t mutations) {
    codecs.push_back(
        measured<Size>(name, all, InBlocks<Size, Brushes>{{.mutations = mutations}}, seed, rounds));
  };
  brushes("brushes, greedy", 0);
  brushes("brushes, mutated", 20000);
}

/// The readings of one map of each texture, decoded by a codec.
template <class Size, class Decoded>
ReadMaps read(const char* name, const std::vector<OpacityMaps>& all, const Decoded& decoded) {
  ReadMaps figures{.side = Size::side, .map = name};
  std::array<std::uint64_t, all_readings.size()> wrong{};
  std::uint64_t hits = 0, checked = 0;
  for (const OpacityMaps& maps : all) {
    const auto map = decoded(Size::of(maps));
    for (std::size_t k = 0; k < map.size(); ++k) {
      const State was = Size::of(maps)[k];
      figures.lost_t += was == State::T && map[k] == State::C ? 1 : 0;
      figures.lost_o += was == State::O && map[k] == State::C ? 1 : 0;
    }
    std::array<std::int64_t, all_readings.size()> more{};
    for (const SampledHit& hit : maps.hits) {
      const auto x = static_cast<std::uint32_t>(hit.u * Size::side),
                 y = static_cast<std::uint32_t>(hit.v * Size::side);
      checked += map[x + Size::side * y] == State::C ? 1 : 0;
      for (std::size_t r = 0; r < all_readings.size(); ++r) {
        const bool read_opaque = opaque(map, Size::side, hit.u, hit.v, all_readings[r]);
        wrong[r] += read_opaque != hit.opaque ? 1 : 0;
        more[r] += static_cast<std::int64_t>(read_opaque) - static_cast<std::int64_t>(hit.opaque);
      }
    }
    hits += maps.hits.size();
    for (std::size_t r = 0; r < all_readings.size(); ++r)
      figures.by[r].shade += std::abs(static_cast<double>(more[r])) / static_cast<double>(maps.hits.size()) /
                             static_cast<double>(all.size());
  }
  figures.checked = static_cast<double>(checked) / static_cast<double>(hits);
  for (std::size_t r = 0; r < all_readings.size(); ++r) {
    figures.by[r].reading = all_readings[r];
    figures.by[r].wrong = static_cast<double>(wrong[r]) / static_cast<double>(hits);
  }
  return figures;
}

/// The map with one state given up, so that the codec has all of its bits for the other.
template <class Map>
Map without(Map map, State given_up) {
  std::replace(map.begin(), map.end(), given_up, State::C);
  return map;
}

template <class Size>
void add_readings(const std::vector<OpacityMaps>& all, std::vector<ReadMaps>& figures) {
  const auto vq = [](const auto& map) { return impl::vq::decode(Size::encoded(map)); };
  const auto tree = [](Weights weights) {
    return [weights](const auto& map) {
      const InBlocks<Size, QuadTree> quad_tree{{.root = 4, .weights = weights}};
      return quad_tree.decode(quad_tree.block(map));
    };
  };
  // The weight by which one region of the preferred state outweighs a whole map of the other.
  constexpr std::uint32_t first = Size::side * Size::side + 1;
  figures.push_back(read<Size>("source", all, [](const auto& map) { return map; }));
  figures.push_back(read<Size>(Size::vq, all, vq));
  figures.push_back(
      read<Size>("VQ, O alone", all, [&](const auto& map) { return vq(without(map, State::T)); }));
  figures.push_back(
      read<Size>("VQ, T alone", all, [&](const auto& map) { return vq(without(map, State::O)); }));
  figures.push_back(read<Size>("quad-tree, even", all, tree({})));
  figures.push_back(read<Size>("quad-tree, O first", all, tree({.t = 1, .o = first})));
  figures.push_back(read<Size>("quad-tree, T first", all, tree({.t = first, .o = 1})));
}

}  // namespace

Figures figures(const std::vector<OpacityMaps>& maps, std::uint64_t seed, std::size_t rounds,
                const std::function<void(const std::string&)>& begins) {
  Figures figures;
  begins("rivals of VQ2");
  add_codecs<Sixteen>(maps, seed, rounds, figures.codecs);
  begins("rivals of VQ4");
  add_codecs<ThirtyTwo>(maps, seed, rounds, figures.codecs);
  begins("three states read as two");
  add_readings<Sixteen>(maps, figures.read);
  add_readings<ThirtyTwo>(maps, figures.read);
  return figures;
}

}  // namespace mmverify::bench::rivals
