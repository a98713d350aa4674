// The number of maps that are left if equal ones are stored once.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// A key that distinguishes maps without their values.
struct MapKey {
  std::uint64_t hash = 0;
  std::optional<MapValue> constant;  ///< the value that all values equal, if there is one
};
MapKey key_of(std::span<const MapValue> map);

struct SharedMaps {
  std::uint64_t distinct = 0;  ///< maps, each once, compared value by value in their own order
  std::uint64_t constant = 0;  ///< distinct maps of one value, for which a special index would do
  bool operator==(const SharedMaps&) const = default;
};

/// Exact: maps of equal hashes are baked again and compared.  `map(k)` bakes the map of keys[k].
SharedMaps shared(std::span<const MapKey> keys, const std::function<std::vector<MapValue>(std::size_t)>& map);

}  // namespace mmverify::scene
