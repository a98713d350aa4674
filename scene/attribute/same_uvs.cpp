#include "scene/attribute/same_uvs.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <utility>

namespace mmverify::scene {

std::vector<std::size_t> first_of_same_uvs(std::span<const MapOfTriangle> triangles) {
  std::map<std::pair<std::size_t, std::array<std::uint32_t, 6>>, std::size_t> known;
  std::vector<std::size_t> first;
  first.reserve(triangles.size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    std::array<std::uint32_t, 6> bits;
    for (std::size_t c = 0; c < 6; ++c)
      bits[c] = std::bit_cast<std::uint32_t>(triangles[k].uvs[c / 2][c % 2]);
    first.push_back(known.try_emplace({triangles[k].texture, bits}, k).first->second);
  }
  return first;
}

}  // namespace mmverify::scene
