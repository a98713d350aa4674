#include "proofs/scene/cause/texture_age.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "spec/index/index.hpp"

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::State;

/// A box in UV.
struct Box {
  std::array<double, 2> least{1e30, 1e30}, greatest{-1e30, -1e30};

  void add(const std::array<double, 2>& uv) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      least[axis] = std::min(least[axis], uv[axis]);
      greatest[axis] = std::max(greatest[axis], uv[axis]);
    }
  }
  double area() const {
    return std::max(0.0, greatest[0] - least[0]) * std::max(0.0, greatest[1] - least[1]);
  }
};

bool is_known_state(State s) { return s == State::T || s == State::O; }

/// Whether a T and an O have a corner in common.
bool touch(const States& map, Level n) {
  const std::size_t side = (std::size_t{1} << n) + 1;
  std::vector<std::uint8_t> met(side * side);  // bit 0: T, bit 1: O
  for (std::uint32_t k = 0; k < map.size(); ++k)
    if (is_known_state(map[k]))
      for (const auto& corner : spec::index::corners(k, n)) {
        std::uint8_t& here = met[corner.i * side + corner.j];
        here = static_cast<std::uint8_t>(here | (map[k] == State::T ? 1 : 2));
        if (here == 3) return true;
      }
  return false;
}

/// Adds the corners of a micro-triangle.
void add(Box& box, const mmverify::scene::UvTriangle& uvs, std::uint32_t k, Level n) {
  const double side = static_cast<double>(std::uint32_t{1} << n);
  for (const auto& corner : spec::index::corners(k, n)) {
    const double u = corner.i / side, v = corner.j / side, w = 1 - u - v;
    box.add({w * uvs[0][0] + u * uvs[1][0] + v * uvs[2][0], w * uvs[0][1] + u * uvs[1][1] + v * uvs[2][1]});
  }
}

}  // namespace

std::optional<std::string> older_texture(const Judged& judged, const std::vector<std::size_t>& triangles,
                                         const std::vector<States>& stored,
                                         const std::vector<States>& right) {
  std::uint64_t opposite = 0, triangles_wrong = 0, known_of_wrong = 0, equal_of_wrong = 0;
  Box wrong, all;
  for (std::size_t t = 0; t < stored.size(); ++t) {
    const Level n = judged.maps.baked.triangles[triangles[t]].level;
    if (touch(stored[t], n)) return {};
    const auto& uvs = judged.maps.plan.triangles[triangles[t]].uvs;
    for (const auto& uv : uvs) all.add({uv[0], uv[1]});
    std::uint64_t known = 0, equal = 0;
    for (std::uint32_t k = 0; k < stored[t].size(); ++k) {
      const State is = stored[t][k], should = right[t][k];
      known += is_known_state(is) ? 1 : 0;
      equal += is_known_state(is) && is == should ? 1 : 0;
      opposite += is_known_state(is) && is_known_state(should) && is != should ? 1 : 0;
      if (is_known_state(is) ? is != should : is_known_state(should)) add(wrong, uvs, k, n);
    }
    if (5 * equal < 3 * known) return {};  // another's map, rather than an older texture's
    if (equal == known) continue;
    ++triangles_wrong;
    known_of_wrong += known;
    equal_of_wrong += equal;
  }
  // One wrong triangle may have another's map, which agrees by chance.
  const bool is_one_other_map = triangles_wrong < 2 && 4 * equal_of_wrong < 3 * known_of_wrong;
  if (opposite < 2 || is_one_other_map || wrong.area() > all.area() / 2) return {};
  return fmt::format(
      "the texture has changed since the bake, within u {:.3f} to {:.3f} and v {:.3f} to {:.3f}",
      wrong.least[0], wrong.greatest[0], wrong.least[1], wrong.greatest[1]);
}

}  // namespace mmverify::proofs::scene
