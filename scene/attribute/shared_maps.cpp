#include "scene/attribute/shared_maps.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>

namespace mmverify::scene {

MapKey key_of(std::span<const MapValue> map) {
  MapKey key;
  bool constant = true;
  std::uint64_t hash = 0x9e3779b97f4a7c15;
  for (const MapValue& value : map) {
    constant = constant && value == map.front();
    // A multiplication and a shift a value, as of splitmix64.
    hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0xbf58476d1ce4e5b9;
    hash ^= hash >> 29;
  }
  key.hash = hash;
  if (constant) key.constant = map.front();
  return key;
}

SharedMaps shared(std::span<const MapKey> keys,
                  const std::function<std::vector<MapValue>(std::size_t)>& map) {
  std::set<MapValue> constants;
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (keys[k].constant)
      constants.insert(*keys[k].constant);
    else
      others.push_back(k);
  }
  SharedMaps result{constants.size(), constants.size()};
  std::stable_sort(others.begin(), others.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a].hash < keys[b].hash; });
  for (std::size_t begin = 0; begin < others.size();) {
    std::size_t end = begin + 1;
    while (end < others.size() && keys[others[end]].hash == keys[others[begin]].hash) ++end;
    if (end - begin == 1) {
      ++result.distinct;
    } else {
      std::set<std::vector<MapValue>> maps;
      for (std::size_t k = begin; k < end; ++k) maps.insert(map(others[k]));
      result.distinct += maps.size();
    }
    begin = end;
  }
  return result;
}

}  // namespace mmverify::scene
