#include "scene/bake/square_maps.hpp"

#include <algorithm>
#include <stdexcept>

#include "impl/index/index.hpp"
#include "impl/micromap/reorder.hpp"

namespace mmverify::scene {
namespace {

using impl::micromap::Bytes;

/// The marks of a region: some of it not opaque, some not transparent.
constexpr unsigned not_opaque = 1, not_transparent = 2;
/// The marks of a 4-state code.
constexpr unsigned seen[4] = {not_opaque, not_transparent, not_opaque | not_transparent,
                              not_opaque | not_transparent};

std::vector<bool> in_pairs(const Plan& plan, const Pairs& pairs) {
  std::vector<bool> wanted(plan.triangles.size(), false);
  for (const Pair& pair : pairs.distinct) wanted[pair.lower.triangle] = wanted[pair.upper.triangle] = true;
  return wanted;
}

/// A use's 4-state map at the baked level, its vertices in the use's order.
Bytes map_of(const BakedTriangle& baked, const VertexOrder& order) {
  using namespace impl::micromap;
  const std::uint64_t count = micro_triangles(baked.level);
  Bytes map(packed_bytes(count, Format::four_state)), out(map.size());
  if (baked.uniform) {
    const auto byte = static_cast<std::uint8_t>(static_cast<unsigned>(*baked.uniform) * 0x55);
    std::fill(map.begin(), map.end(), byte);
  } else if (baked.format == Format::two_state) {
    widen(baked.map, count, map);
  } else {
    map.assign(baked.map.begin(), baked.map.end());
  }
  reorder(map, baked.level, Format::four_state, order, out);
  return out;
}

template <class Map>
std::vector<Map> at_level(const Scene& scene, const Plan& plan, const Pairs& pairs, unsigned level,
                          const BakeOptions& options) {
  Plan needed;
  needed.surfaces = plan.surfaces;
  std::vector<std::size_t> number(plan.triangles.size());
  const std::vector<bool> wanted = in_pairs(plan, pairs);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    number[k] = needed.triangles.size();
    if (wanted[k]) needed.triangles.push_back(plan.triangles[k]);
  }
  const std::vector<unsigned> levels(needed.triangles.size(), level);
  const Baked baked = bake(scene, needed, levels, {options.threads, false, options.margin, {}});
  std::vector<Map> maps(pairs.distinct.size());
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const Pair& pair = pairs.distinct[k];
    square_map(map_of(baked.triangles[number[pair.lower.triangle]], pair.lower.order),
               map_of(baked.triangles[number[pair.upper.triangle]], pair.upper.order), level, maps[k]);
  }
  return maps;
}

}  // namespace

void square_map(std::span<const std::uint8_t> lower, std::span<const std::uint8_t> upper, unsigned level,
                std::span<impl::vq::State> states) {
  if (level < 1 || level > 8) throw std::invalid_argument("square_map: a level not in 1..8");
  const std::uint64_t count = impl::micromap::micro_triangles(level);
  const auto size = impl::micromap::packed_bytes(count, impl::micromap::Format::four_state);
  if (lower.size() != size || upper.size() != size || states.size() != count)
    throw std::invalid_argument("square_map: maps of another size");
  const std::size_t side = std::size_t{1} << level;
  std::vector<unsigned> marks(states.size(), 0);
  const auto add = [&](std::span<const std::uint8_t> map, bool turned) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const impl::index::Corners corners = impl::index::corners(k, level);
      // Both micro-triangles of a square have their least i and least j at its lower left.
      std::size_t i = std::min({corners[0].i, corners[1].i, corners[2].i}),
                  j = std::min({corners[0].j, corners[1].j, corners[2].j});
      // The upper triangle's barycentrics (u, v) are at (1-u, 1-v) of the map.
      if (turned) i = side - 1 - i, j = side - 1 - j;
      marks[i + side * j] |= seen[map[k / 4] >> (2 * (k % 4)) & 3];
    }
  };
  add(lower, false);
  add(upper, true);
  for (std::size_t k = 0; k < states.size(); ++k)
    states[k] = marks[k] == not_opaque        ? impl::vq::State::T
                : marks[k] == not_transparent ? impl::vq::State::O
                                              : impl::vq::State::C;
}

SquareMaps square_maps(const Scene& scene, const Plan& plan, const Pairs& pairs, const BakeOptions& options) {
  return {at_level<impl::vq::Map2>(scene, plan, pairs, 4, options),
          at_level<impl::vq::Map4>(scene, plan, pairs, 5, options)};
}

}  // namespace mmverify::scene
