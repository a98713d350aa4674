// Maps of which equal ones are stored once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// A hash of a map's values in their order.
std::uint64_t hash_of(std::span<const MapValue> map);

/// The distinct maps among maps of one size, compared value by value and numbered from 0 in order of appearance.
class DistinctMaps {
 public:
  /// Makes the map of an owner, such as a triangle; called from any thread, with the same result each time.
  using Make = std::function<void(std::size_t owner, std::vector<MapValue>& map)>;
  using Hash = std::uint64_t (*)(std::span<const MapValue>);

  /// `values`: of each map.  Maps are kept up to `most` values in all; further ones are made again where their
  /// values matter.
  DistinctMaps(std::uint64_t values, std::uint64_t most, Make make, Hash hash = hash_of)
      : size_(static_cast<std::size_t>(values)), most_(most), make_(std::move(make)), hash_(hash) {}

  /// Makes a map for each owner, side by side, and adds it.  Returns the number of each owner's map.
  /// `made` receives each place among the owners and its map, from any thread.
  /// Memory: the kept maps and 2^22 values, or 16 maps.
  std::vector<std::uint32_t> add(
      std::span<const std::size_t> owners,
      const std::function<void(std::size_t k, std::span<const MapValue> map)>& made = {});

  std::uint32_t count() const { return static_cast<std::uint32_t>(owners_.size()); }
  /// The number of maps whose values are all equal, for which a special index would do.
  std::uint32_t constant() const { return constant_; }

  /// Whether all maps are kept, and then their values, map by map.
  bool kept() const { return values_.size() == size_ * owners_.size(); }
  std::span<const MapValue> values() const { return values_; }
  /// A map; `space` holds its values if they are not kept.
  std::span<const MapValue> map(std::uint32_t number, std::vector<MapValue>& space) const;

 private:
  std::uint32_t number_of(std::size_t owner, std::uint64_t hash, std::span<const MapValue> map);

  std::size_t size_;
  std::uint64_t most_;
  Make make_;
  Hash hash_;
  std::vector<MapValue> values_;     ///< of the first maps
  std::vector<std::size_t> owners_;  ///< the first owner of each map
  std::uint32_t constant_ = 0;
  std::unordered_multimap<std::uint64_t, std::uint32_t> numbers_;  ///< by hash
};

}  // namespace mmverify::scene
