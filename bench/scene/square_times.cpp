#include "bench/scene/square_times.hpp"

#include <algorithm>
#include <random>

#include "bench/timing.hpp"
#include "impl/micromap/micromap.hpp"
#include "scene/bake/square_maps.hpp"

namespace mmverify::bench {
namespace {

constexpr std::size_t rounds = 5;
constexpr std::uint64_t record_bytes = 8;

template <class Block, class Map, class Encode>
SquareFigures measured(const char* form, std::uint32_t level, const std::vector<Map>& maps, Encode encode,
                       std::uint64_t lookups, std::uint64_t seed, const std::function<void()>& stop) {
  SquareFigures f;
  f.form = form;
  f.level = level;
  f.maps = maps.size();
  std::vector<Block> blocks;
  double encoding = 0;
  for (const Map& map : maps) {
    if (stop) stop();
    if (std::all_of(map.begin(), map.end(), [&](impl::vq::State s) { return s == map[0]; })) {
      ++f.uniform;
      continue;
    }
    encoding += once_ns([&] {
      const auto encoded = encode(map);
      f.substitutions += encoded.substitutions;
      blocks.push_back(encoded.block);
    });
    f.regions += map.size();
  }
  if (blocks.empty()) return f;
  f.bytes = blocks.size() * (sizeof(Block) + record_bytes);
  f.flat_bytes = 2 * blocks.size() *
                 (impl::micromap::packed_bytes(impl::micromap::micro_triangles(level),
                                               impl::micromap::Format::four_state) +
                  record_bytes);
  f.build_rate = 1e3 * static_cast<double>(f.regions) / encoding;
  struct Lookup {
    std::uint32_t block, x, y;
  };
  std::mt19937_64 random(seed);
  std::vector<Lookup> asked(lookups);
  const std::uint32_t side = std::uint32_t{1} << level;
  for (Lookup& one : asked)
    one = {static_cast<std::uint32_t>(random() % blocks.size()), static_cast<std::uint32_t>(random() % side),
           static_cast<std::uint32_t>(random() % side)};
  std::vector<impl::vq::State> states(asked.size());
  f.ns = median_ns(rounds,
                   [&] {
                     for (std::size_t k = 0; k < asked.size(); ++k)
                       states[k] = impl::vq::region(blocks[asked[k].block], asked[k].x, asked[k].y);
                   }) /
         static_cast<double>(asked.size());
  return f;
}

}  // namespace

std::vector<SquareFigures> square_figures(const scene::Scene& scene, const scene::Plan& plan,
                                          std::uint32_t first, std::uint32_t last, std::uint64_t lookups,
                                          std::uint64_t seed, const std::function<void()>& stop) {
  std::vector<SquareFigures> figures;
  const auto asked_for = [&](std::uint32_t level) { return first <= level && level <= last; };
  if (!asked_for(4) && !asked_for(5)) return figures;
  const scene::SquareMaps maps = scene::square_maps(scene, plan, scene::pairs(scene, plan));
  const auto keep = [&](const SquareFigures& f) {
    if (f.bytes != 0) figures.push_back(f);
  };
  if (asked_for(4))
    keep(measured<impl::vq::Block2>(
        "vq2", 4, maps.vq2, [](const impl::vq::Map2& map) { return impl::vq::encode_optimal(map); }, lookups,
        seed, stop));
  if (asked_for(5))
    keep(measured<impl::vq::Block4>(
        "vq4", 5, maps.vq4, [](const impl::vq::Map4& map) { return impl::vq::encode(map); }, lookups, seed,
        stop));
  return figures;
}

}  // namespace mmverify::bench
