#include "scene/attribute/distinct_maps.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <bit>

namespace mmverify::scene {

std::uint64_t hash_of(std::span<const MapValue> map) {
  std::uint64_t hash = 0x9e3779b97f4a7c15;
  for (const MapValue& value : map) {
    // A multiplication and a shift a value, as of splitmix64.
    hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0xbf58476d1ce4e5b9;
    hash ^= hash >> 29;
  }
  return hash;
}

std::span<const MapValue> DistinctMaps::map(std::uint32_t number, std::vector<MapValue>& space) const {
  const std::size_t first = std::size_t{number} * size_;
  if (first + size_ <= values_.size()) return std::span(values_).subspan(first, size_);
  make_(owners_[number], space);
  return space;
}

std::uint32_t DistinctMaps::number_of(std::size_t owner, std::uint64_t hash, std::span<const MapValue> map) {
  std::vector<MapValue> space;
  const auto [begin, end] = numbers_.equal_range(hash);
  for (auto known = begin; known != end; ++known)
    if (const auto other = this->map(known->second, space);
        std::equal(other.begin(), other.end(), map.begin(), map.end()))
      return known->second;
  if (kept() && values_.size() + size_ <= most_) values_.insert(values_.end(), map.begin(), map.end());
  constant_ +=
      std::all_of(map.begin(), map.end(), [&](const MapValue& value) { return value == map.front(); });
  numbers_.emplace(hash, count());
  owners_.push_back(owner);
  return count() - 1;
}

std::vector<std::uint32_t> DistinctMaps::add(
    std::span<const std::size_t> owners,
    const std::function<void(std::size_t, std::span<const MapValue>)>& made) {
  const std::size_t together = std::clamp<std::size_t>((std::size_t{1} << 22) / size_, 16, 4096);
  std::vector<std::vector<MapValue>> maps(std::min(together, owners.size()));
  std::vector<std::uint64_t> hashes(maps.size());
  std::vector<std::uint32_t> numbers;
  numbers.reserve(owners.size());
  while (numbers.size() < owners.size()) {
    const std::size_t first = numbers.size(), count = std::min(together, owners.size() - first);
    oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
      make_(owners[first + k], maps[k]);
      hashes[k] = hash_(maps[k]);
      if (made) made(first + k, maps[k]);
    });
    for (std::size_t k = 0; k < count; ++k)
      numbers.push_back(number_of(owners[first + k], hashes[k], maps[k]));
  }
  return numbers;
}

}  // namespace mmverify::scene
