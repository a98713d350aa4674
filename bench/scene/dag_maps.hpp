// The maps of a scene at one level, as input for a comparison of forms.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "impl/bake/triangles.hpp"
#include "impl/micromap/micromap.hpp"
#include "scene/plan/plan.hpp"

namespace mmverify::bench {

/// A distinct triangle of a plan with its vertices in one order, like a record of an array.
struct MapUse {
  std::uint32_t triangle = 0;  ///< number in Plan::triangles
  scene::VertexOrder order{0, 1, 2};
  std::uint64_t triangles = 0;  ///< triangles of the scene's meshes that it stands for
};

/// Each used pair of triangle and order, once, in the order of the plan's primitives.
std::vector<MapUse> map_uses(const scene::Plan& plan);

/// The maps of one level and format that have at least two states.
struct MapsAtLevel {
  std::uint32_t level = 0, bits = 0;
  std::uint64_t taken = 0;  ///< baked maps; `uniform` of them have one state, and are not in `maps`
  std::uint64_t uniform = 0;
  std::vector<std::vector<std::uint8_t>> maps;  ///< packed
  std::vector<std::uint64_t> triangles;         ///< triangles that each of `maps` stands for
};

/// A baker of a scene's maps, level by level.
class SceneMaps {
 public:
  /// The scene and its plan must outlive it.  Errors: std::invalid_argument as of scene::surface_baker().
  SceneMaps(const scene::Scene& scene, const scene::Plan& plan);

  const std::vector<MapUse>& uses() const { return uses_; }

  /// The number of maps of a level that fit a budget of bytes, each with 4 states: at most all, at least one.
  std::size_t fitting(std::uint32_t level, std::uint64_t budget) const;

  /// The 4-state maps of `taken` of the uses, packed.  Map j is that of use floor(j uses / taken): all uses
  /// if taken = uses, else some spread evenly among them.  `stop` is called before each and may throw.
  /// Domain: level 0..12; 0 < taken <= uses.
  std::vector<std::vector<std::uint8_t>> baked(std::uint32_t level, std::size_t taken,
                                               const std::function<void()>& stop = {}) const;

  /// The same maps in one format, without maps of one state: a special index replaces them, so they take no
  /// bytes in any form.
  /// 2-state is force-2-state.
  MapsAtLevel in_format(std::uint32_t level, impl::micromap::Format format,
                        const std::vector<std::vector<std::uint8_t>>& baked) const;

 private:
  std::size_t use_of(std::size_t number, std::size_t taken) const { return number * uses_.size() / taken; }

  const scene::Plan& plan_;
  std::vector<MapUse> uses_;
  std::vector<impl::bake::TriangleBaker> bakers_;
};

}  // namespace mmverify::bench
