// Two base triangles with a common edge, one of them of a lower level: what both interpolate at its points.
#pragma once

#include <string>

#include "proofs/attribute/lookup/hats.hpp"

namespace mmverify::proofs::attribute {

/// A point of the common edge, at/(4N) along it from the first end of the finer map's edge; it is the last end of the
/// neighbour's, since both wind the same way.
struct SharedEdge {
  std::uint32_t edge;  ///< of the finer map, whose flags have it
  EdgeFlags flags;
  std::uint32_t beside;  ///< edge of the neighbour, whose flags have it not
  EdgeFlags its_flags;
  std::uint64_t at;
};

/// 3 edges and 4 sets of other flags on either side, 4N + 1 points.
std::uint64_t shared_edge_cases(Level n);
SharedEdge shared_edge(Level n, std::uint64_t k);
/// "edge=0,flags=1,beside=2,its-flags=0,at=3/8".
std::string text_of(Level n, const SharedEdge& e);
/// Throws BadCase.
SharedEdge shared_edge_of_text(Level n, const std::string& text);

/// The point a map of any level has there.
DyadicPoint point_on(std::uint32_t edge, std::uint64_t at, Level n);

/// What the finer map of level n interpolates there, by places 0..N along its edge; of the neighbour of level `lower` the
/// same, by the finer one's places.  Nothing where a vertex off the edge has a weight.
std::optional<Hats> of_finer(const AttributeSubject& s, Level n, const SharedEdge& e);
std::optional<Hats> of_neighbour(const AttributeSubject& s, Level n, Level lower, const SharedEdge& e);

/// The hat functions of an edge of `steps` steps, at a point of the finer map, by the finer one's places: the vertices
/// on either side share the weight.
Hats along_edge(Level n, std::uint64_t at, std::uint32_t steps);

}  // namespace mmverify::proofs::attribute
