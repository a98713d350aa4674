#include "bench/vq/bench.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>

#include "bench/timing.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::bench {
namespace {

using impl::vq::Block2;
using impl::vq::Block4;
using impl::vq::Effort;
using impl::vq::Map2;
using impl::vq::Map4;
using impl::vq::State;

std::uint32_t transforms_of(const Block2& block) { return (block[24] | std::uint32_t{block[25]} << 8) & 511; }
std::uint32_t transforms_of(const Block4& block) { return (block[32] | std::uint32_t{block[33]} << 8) & 511; }

template <class Map, class Encoded>
void check(const char* encoder, const std::string& of, const Map& map, const Encoded& encoded) {
  const Map out = impl::vq::decode(encoded.block);
  std::uint32_t lost = 0;
  bool conservative = true;
  for (std::size_t k = 0; k < map.size(); ++k) {
    conservative = conservative && (out[k] == map[k] || out[k] == State::C);
    lost += out[k] != map[k] ? 1 : 0;
  }
  if (!conservative || lost != encoded.substitutions)
    throw std::runtime_error("vq bench: " + std::string(encoder) + " is wrong on " + of);
}

template <class Map, class Encode>
VqEncoded measured(const char* encoder, const std::string& of, const Map& map, std::size_t rounds,
                   Encode encode) {
  std::vector<double> ms;
  VqEncoded result;
  for (std::size_t round = 0; round < rounds; ++round) {
    const double start = thread_ns();
    const auto encoded = encode(map);
    ms.push_back((thread_ns() - start) / 1e6);
    if (round == 0) {
      check(encoder, of, map, encoded);
      result.substitutions = encoded.substitutions;
      result.transforms = transforms_of(encoded.block);
    }
  }
  const Spread spread = spread_of(ms);
  result.ms = spread.median;
  result.least_ms = spread.least;
  result.most_ms = spread.most;
  return result;
}

VqRow row_of(const OpacityMaps& maps, std::size_t rounds) {
  VqRow row;
  row.of = maps.of;
  row.savings_64x2 = savings(maps.sub_triangles_64x2);
  row.savings_8 = savings(maps.regions_8);
  row.savings_16 = savings(maps.regions_16);
  row.savings_32 = savings(maps.regions_32);
  row.states_16 = static_cast<std::uint32_t>(row.savings_16 * 256);
  row.states_32 = static_cast<std::uint32_t>(row.savings_32 * 1024);
  row.discontinuous =
      impl::vq::discontinuous_vectors(maps.regions_16) + impl::vq::discontinuous_vectors(maps.regions_32);
  const auto vq2 = [&](Vq2Encoder e, auto encode) {
    row.vq2[static_cast<std::size_t>(e)] = measured(to_string(e), maps.of, maps.regions_16, rounds, encode);
  };
  vq2(Vq2Encoder::paper, [](const Map2& map) { return impl::vq::encode_paper(map); });
  vq2(Vq2Encoder::paper_highest_first, impl::vq::encode_paper_highest_first);
  vq2(Vq2Encoder::optimal, impl::vq::encode_optimal);
  const auto vq4 = [&](Vq4Encoder e, std::size_t times, auto encode) {
    row.vq4[static_cast<std::size_t>(e)] = measured(to_string(e), maps.of, maps.regions_32, times, encode);
  };
  vq4(Vq4Encoder::paper, rounds, [](const Map4& map) { return impl::vq::encode_paper(map); });
  vq4(Vq4Encoder::paper_free_c, rounds, impl::vq::encode_paper_free_c);
  vq4(Vq4Encoder::fast, rounds, [](const Map4& map) { return encode(map, Effort::fast); });
  vq4(Vq4Encoder::balanced, rounds, [](const Map4& map) { return encode(map, Effort::balanced); });
  vq4(Vq4Encoder::thorough, rounds, [](const Map4& map) { return encode(map, Effort::thorough); });
  vq4(Vq4Encoder::proved, 1, [&](const Map4& map) {
    const impl::vq::Proved4 proved = impl::vq::encode_proved(map);
    row.least = proved.least;
    return proved.encoded;
  });
  return row;
}

/// Makes the optimizer take the value for used.
void keep(std::uint32_t& value) { asm volatile("" : "+r"(value)); }

template <std::uint32_t side, class Block>
VqDecodeTimes decode_times(const std::vector<Block>& blocks, std::uint64_t seed, std::size_t rounds) {
  constexpr std::size_t hits = 1 << 20, maps = 1 << 13;
  std::mt19937_64 random(seed);
  struct Hit {
    std::uint32_t block, x, y;
  };
  std::vector<Hit> at(hits);
  for (Hit& hit : at)
    hit = {static_cast<std::uint32_t>(random() % blocks.size()), static_cast<std::uint32_t>(random() % side),
           static_cast<std::uint32_t>(random() % side)};
  std::vector<double> map_ns, by_regions_ns, region_ns;
  std::uint32_t sum = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    double start = thread_ns();
    for (std::size_t k = 0; k < maps; ++k) {
      const auto map = impl::vq::decode(blocks[k % blocks.size()]);
      asm volatile("" : : "r"(map.data()) : "memory");
    }
    map_ns.push_back((thread_ns() - start) / maps);
    start = thread_ns();
    for (std::size_t k = 0; k < maps / 16; ++k)
      for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
          sum += static_cast<std::uint32_t>(impl::vq::region(blocks[k % blocks.size()], x, y));
    keep(sum);
    by_regions_ns.push_back((thread_ns() - start) / (maps / 16));
    start = thread_ns();
    for (const Hit& hit : at)
      sum += static_cast<std::uint32_t>(impl::vq::region(blocks[hit.block], hit.x, hit.y));
    keep(sum);
    region_ns.push_back((thread_ns() - start) / hits);
  }
  return {median(map_ns), median(by_regions_ns), median(region_ns)};
}

}  // namespace

const char* to_string(Vq2Encoder encoder) {
  return encoder == Vq2Encoder::paper                 ? "paper"
         : encoder == Vq2Encoder::paper_highest_first ? "paper, highest"
                                                      : "optimal";
}

const char* to_string(Vq4Encoder encoder) {
  switch (encoder) {
    case Vq4Encoder::paper: return "paper";
    case Vq4Encoder::paper_free_c: return "paper, C free";
    case Vq4Encoder::fast: return "fast";
    case Vq4Encoder::balanced: return "balanced";
    case Vq4Encoder::thorough: return "thorough";
    case Vq4Encoder::proved: break;
  }
  return "proved";
}

std::vector<std::pair<std::uint32_t, std::size_t>> transform_counts(
    const std::vector<VqRow>& rows, const std::function<std::uint32_t(const VqRow&)>& chosen) {
  std::map<std::uint32_t, std::size_t> counts;
  for (const VqRow& row : rows) ++counts[chosen(row)];
  std::vector<std::pair<std::uint32_t, std::size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return sorted;
}

VqFigures vq_figures(const VqBenchOptions& options) {
  if (options.maps == 0 || options.rounds == 0)
    throw std::invalid_argument("vq bench: a map and a round at least");
  const auto begins = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  VqFigures figures;
  std::vector<OpacityMaps> all;
  begins(options.textures.empty() ? "generating maps" : "maps of " + options.textures);
  if (options.textures.empty()) {
    all = leaf_opacity_maps(options.maps, options.seed);
  } else {
    const std::vector<AlphaTexture> textures = alpha_textures(options.textures);
    all = opacity_maps(textures);
    figures.left_out = textures.size() - all.size();
  }
  if (all.empty()) throw std::runtime_error(options.textures + ": no texture has alpha of 1/2 anywhere");
  for (const OpacityMaps& maps : all) {
    begins(maps.of);
    figures.rows.push_back(row_of(maps, options.rounds));
  }
  begins("decoding");
  std::vector<Block2> blocks_2;
  std::vector<Block4> blocks_4;
  for (const OpacityMaps& maps : all) {
    blocks_2.push_back(impl::vq::encode_optimal(maps.regions_16).block);
    blocks_4.push_back(encode(maps.regions_32, Effort::fast).block);
  }
  figures.vq2 = decode_times<16>(blocks_2, options.seed, options.rounds);
  figures.vq4 = decode_times<32>(blocks_4, options.seed, options.rounds);
  figures.rivals = rivals::figures(all, options.seed, options.rounds, begins);
  return figures;
}

}  // namespace mmverify::bench
