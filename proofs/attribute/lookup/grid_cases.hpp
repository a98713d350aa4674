// Points on the cells of a level's grid as cases, and the lookup of such a point.
#pragma once

#include "proofs/attribute/orders/parts.hpp"
#include "proofs/points/cells.hpp"

namespace mmverify::proofs::attribute {

/// A point of the grid k / (4N), and the kind of the level's cell that holds it.
struct GridCase {
  GridPoint at;
  Kind kind;
};

/// The number of points, (4N+1)(4N+2)/2: each vertex of the level, three points on each open edge, and three points
/// off every line inside each open micro-triangle.  A micro-triangle is constant on a cell and weights are affine
/// there, so these points decide all rational points.
constexpr std::uint64_t grid_count(Level n) { return vertex_count(n + 2); }

/// The points in the order of the vertices of level n+2: column by column.
void fill(Level n, std::uint64_t first, std::span<GridCase> out);
/// A point as text, "u=3/8,v=1/4".  read() throws BadCase if a text is no point of the grid.
std::string text_of(const GridCase& of);
void read(Level n, const std::string& text, GridCase& of);
inline Kind kind_of(const GridCase& of, Kind) { return of.kind; }

inline std::string every_point(const Subject& s, Level) {
  return s.exact()
             ? "every rational point, by the vertices and three points of each open edge and micro-triangle"
             : "the (4N+1)(4N+2)/2 points k/(4N), as binary32 numbers";
}

namespace entry {
inline constexpr Entry point_triplet{"point -> triplet",
                                     [](const Functions& f) { return bool{f.lookup.triplet}; }};
inline constexpr Entry point_weights{"point -> weights",
                                     [](const Functions& f) { return bool{f.lookup.weights}; }};
inline constexpr Entry holder{"point -> face", [](const Functions& f) { return bool{f.lookup.holder}; }};
inline constexpr Entry remap{"point, face -> weights",
                             [](const Functions& f) { return bool{f.lookup.remap}; }};
inline constexpr Entry float_triplet{"floats -> triplet",
                                     [](const Functions& f) { return bool{f.lookup.triplet_of_floats}; }};
inline constexpr Entry float_weights{"floats -> weights",
                                     [](const Functions& f) { return bool{f.lookup.weights_of_floats}; }};
inline constexpr Entry rgba8{"floats -> RGBA8", [](const Functions& f) { return bool{f.lookup.rgba8}; }};
}  // namespace entry

/// A lookup of one point: three vertices by index and their weights.
struct Looked {
  Triplet triplet;
  FixedWeights weights;
};
std::vector<Looked> looked_up(const AttributeSubject& s, VertexOrder order, Level n,
                              std::span<const GridPoint> at);
std::string text_of(const Looked& found);

/// The parts of an interpolated value: the vertices with a weight, and the weights, in the order of their indices.
class Blend {
 public:
  void add(std::uint64_t vertex, const Fixed64& weight);
  friend bool operator==(const Blend&, const Blend&) = default;

 private:
  std::array<std::pair<std::uint64_t, Fixed64>, 3> parts_{};
  std::size_t size_ = 0;
};
Blend blend_of(const Looked& found);
/// The blend on a micro-triangle that holds the point, by the pattern.
Blend blend_on(const MicroTriangle& t, VertexOrder order, Level n, const GridPoint& at);

/// The closed micro-triangles that hold a point, up to six, found by trying all around it.
std::vector<MicroTriangle> all_holders(Level n, const GridPoint& at);

/// A mutant that changes weights: `change(n, point, weights)`.
template <class Change>
auto on_weights(Change change) {
  return spoils(&Functions::lookup, &Lookup::weights,
                [change](Level n, Points p, std::span<FixedWeights> out) {
                  for (std::size_t k = 0; k < out.size(); ++k) change(n, p[k], out[k]);
                });
}

}  // namespace mmverify::proofs::attribute
