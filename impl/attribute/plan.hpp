// A plan for a mesh: which triangles need an attribute micromap, at which level, and which maps are equal.
//
// A triangle that one value shows within the stated error has no map: it gets a special value.  Any other gets the
// lowest level that keeps the error.  Then neighbours are made to differ by one level at most.  The finer one's edge is
// decimated; if that breaks the error, the coarser one is raised.
// Source: Color and Attribute Micromaps, 3.2 and 7 ("a fixed palette of color values").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "impl/attribute/bake.hpp"

namespace mmverify::impl::attribute {

/// The neighbours of a triangle with vertices 0, 1, 2 (w, u, v) across edge 0-1, 1-2 and 2-0, or no_neighbour.
inline constexpr std::int32_t no_neighbour = -1;
using Neighbours = std::array<std::int32_t, 3>;

/// The neighbour across an edge is the other triangle with the same two vertices; none if no other, or more than one,
/// has them.  Domain: three vertices a triangle; any numbers.
/// Test: impl_attribute_bake_test
std::vector<Neighbours> neighbours_of(std::span<const std::array<std::uint32_t, 3>> triangles);

/// The plan of one triangle.
struct TrianglePlan {
  std::uint32_t level = 0;
  std::uint8_t decimated = 0;  ///< bit k: the neighbour across edge k has one level less
  bool special = false;        ///< one value shows it: no map, level 0, and no bound on its neighbours
  bool kept =
      true;  ///< the map keeps the error; else the level is the highest, and fails undecimated as well
};

/// A mesh, and the conditions on its triangles' maps.
struct PlanRequest {
  std::span<const Neighbours> neighbours;  ///< one entry a triangle; mutual
  std::uint32_t highest = 5;               ///< highest level
  std::function<bool(std::size_t triangle)> special =
      {};  ///< whether one value keeps the error; empty: none does
  /// Whether a triangle's map of a level, with those edges decimated, keeps the error.
  std::function<bool(std::size_t triangle, std::uint32_t level, std::uint8_t decimated)> keeps = {};
};

/// The least graded levels that keep the error as far as raising can do it:
///   |level(t) - level(s)| <= 1 across edges, t and s without special value;
///   each triangle keeps its error, or has the highest level and does not keep it undecimated either.
/// If `keeps` is level >= wanted(triangle), they are max over s of wanted(s) - distance(s, t).
/// Time: a call of keeps for each level tried, and one for each change around a triangle.
/// Errors: std::invalid_argument for a neighbour that is no triangle, or whose neighbours lack this one; a level
/// above max_attribute_level; no `keeps`.
/// Law: attribute.plan_graded, attribute.plan_keeps_error
std::vector<TrianglePlan> plan(const PlanRequest& request);

/// Distinct byte strings, numbered in the order of their first use: for maps that are stored once, or colours of a
/// palette.
class Shared {
 public:
  /// The number of this byte string; a new one gets the next number.
  /// Test: scene_attribute_plan_test
  std::uint32_t add(std::span<const std::uint8_t> bytes);
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return bytes_; }  ///< of all distinct strings

 private:
  std::map<std::string, std::uint32_t> numbers_;
  std::uint32_t size_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace mmverify::impl::attribute
