// Which triangles of a mesh need an attribute micromap, at which level, and which maps are one.
//
// A triangle that one value shows within the stated error has none: it gets a special value.  Any other gets the lowest
// level that keeps the error.  Neighbours then differ by one level at most; the finer one's edge is decimated, and where
// that breaks the error the coarser one is raised.
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

/// Of a triangle with vertices 0, 1, 2 (w, u, v): the triangle across edge 0-1, 1-2 and 2-0, or no_neighbour.
inline constexpr std::int32_t no_neighbour = -1;
using Neighbours = std::array<std::int32_t, 3>;

/// Across each edge the other triangle that has the same two vertices; none where there is no other, or more than one.
/// Domain: three vertices a triangle; any numbers.
std::vector<Neighbours> neighbours_of(std::span<const std::array<std::uint32_t, 3>> triangles);

/// What a triangle of a plan gets.
struct TrianglePlan {
  std::uint32_t level = 0;
  std::uint8_t decimated = 0;  ///< bit k: across edge k, as of Neighbours, one level less
  bool special = false;        ///< one value shows it: no map, level 0, and no bound on its neighbours
  bool kept = true;            ///< whether the error is; if not, the level is the highest, undecimated or not
};

/// A mesh, and what its triangles may be.
struct PlanRequest {
  std::span<const Neighbours> neighbours;  ///< of one another; of a triangle each
  std::uint32_t highest = 5;               ///< level
  std::function<bool(std::size_t triangle)> special =
      {};  ///< whether one value keeps the error; empty: none does
  /// Whether a triangle's map of a level, with those edges decimated, keeps it.
  std::function<bool(std::size_t triangle, std::uint32_t level, std::uint8_t decimated)> keeps = {};
};

/// The least levels that are graded and keep the error as far as raising can do it:
///   |level(t) - level(s)| <= 1 across edges, t and s without special value;
///   each triangle keeps its error, or has the highest level and does not keep it undecimated either.
/// Where `keeps` is level >= wanted(triangle), they are max over s of wanted(s) - distance(s, t).
/// Time: a call of keeps for each level tried, and one for each change around a triangle.
/// Errors: std::invalid_argument for a neighbour that is no triangle, or that has not this one for its neighbour; a level
/// above max_attribute_level; no `keeps`.
std::vector<TrianglePlan> plan(const PlanRequest& request);

/// Different contents, numbered in the order in which they first come: maps that are stored once, colours of a palette.
class Shared {
 public:
  /// The number of these bytes.
  std::uint32_t add(std::span<const std::uint8_t> bytes);
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return bytes_; }  ///< of all, each once

 private:
  std::map<std::string, std::uint32_t> numbers_;
  std::uint32_t size_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace mmverify::impl::attribute
