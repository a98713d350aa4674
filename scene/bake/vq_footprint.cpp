#include "scene/bake/vq_footprint.hpp"

#include <algorithm>

namespace mmverify::scene {
namespace {

template <class Map, class Encode>
VqFootprint footprint(const std::vector<Map>& maps, Encode encode, const std::function<void()>& stop) {
  VqFootprint f;
  f.maps = maps.size();
  for (const Map& map : maps) {
    if (stop) stop();
    f.regions += map.size();
    f.unknown += static_cast<std::uint64_t>(std::count(map.begin(), map.end(), impl::vq::State::C));
    if (std::all_of(map.begin(), map.end(), [&](impl::vq::State s) { return s == map[0]; })) {
      ++f.uniform;
      continue;
    }
    const auto encoded = encode(map);
    f.bytes += encoded.block.size();
    f.substitutions += encoded.substitutions;
  }
  return f;
}

}  // namespace

VqFootprint vq2_footprint(const SquareMaps& maps, const std::function<void()>& stop) {
  return footprint(
      maps.vq2, [](const impl::vq::Map2& map) { return impl::vq::encode_optimal(map); }, stop);
}

VqFootprint vq4_footprint(const SquareMaps& maps, const std::function<void()>& stop) {
  return footprint(
      maps.vq4, [](const impl::vq::Map4& map) { return impl::vq::encode(map); }, stop);
}

}  // namespace mmverify::scene
