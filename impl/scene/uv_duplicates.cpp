#include "impl/scene/uv_duplicates.hpp"

#include <algorithm>
#include <bit>

namespace mmverify::impl::scene {

std::size_t UvDuplicates::Hash::operator()(const Key& key) const {
  std::uint64_t hash = key.surface;
  // Odd, of random bits: the multiplier of Fibonacci hashing.
  for (const Uv& corner : key.corners)
    for (const float x : corner)
      hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint32_t>(x)) * 0x9E3779B97F4A7C15u;
  return static_cast<std::size_t>(hash ^ hash >> 32);
}

UvDuplicates::Found UvDuplicates::add(std::uint32_t surface, const UvTriangle& uvs) {
  Key key{surface, uvs};
  for (Uv& corner : key.corners)
    for (float& x : corner) x += 0.0f;  // -0 + 0 is +0, so that equal floats hash alike
  std::sort(key.corners.begin(), key.corners.end());
  const auto [entry, is_new] = distinct_.try_emplace(key, First{distinct_.size(), uvs});
  const UvTriangle& first = entry->second.uvs;
  VertexOrder order{0, 1, 2};
  while (uvs[0] != first[order[0]] || uvs[1] != first[order[1]] || uvs[2] != first[order[2]])
    std::next_permutation(order.begin(), order.end());
  return {entry->second.number, order, is_new};
}

}  // namespace mmverify::impl::scene
