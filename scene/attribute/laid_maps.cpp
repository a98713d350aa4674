#include "scene/attribute/laid_maps.hpp"

#include <algorithm>
#include <unordered_map>

namespace mmverify::scene {
namespace {

std::uint32_t word_of(const MapValue& value) {
  return std::uint32_t{value[0]} | std::uint32_t{value[1]} << 8 | std::uint32_t{value[2]} << 16 |
         std::uint32_t{value[3]} << 24;
}

}  // namespace

void lay(LaidMaps& laid, std::span<const MapKey> keys,
         const std::function<void(std::size_t, std::vector<MapValue>&)>& map) {
  const auto size = static_cast<std::size_t>(values_of_map(laid.kind, laid.level));
  std::unordered_multimap<std::uint64_t, std::size_t> known;  // where maps begin, by their hashes
  std::vector<MapValue> values;
  std::vector<std::uint32_t> words(size);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    map(k, values);
    std::transform(values.begin(), values.end(), words.begin(), word_of);
    const auto [begin, end] = known.equal_range(keys[k].hash);
    const auto same = std::find_if(begin, end, [&](const auto& candidate) {
      return std::equal(words.begin(), words.end(),
                        laid.values.begin() + static_cast<std::ptrdiff_t>(candidate.second));
    });
    if (same != end) {
      laid.first.push_back(same->second);
      continue;
    }
    if (laid.values.size() + size > most_laid_values) {
      laid.first.clear();
      laid.values = {};
      return;
    }
    known.emplace(keys[k].hash, laid.values.size());
    laid.first.push_back(laid.values.size());
    laid.values.insert(laid.values.end(), words.begin(), words.end());
  }
}

}  // namespace mmverify::scene
