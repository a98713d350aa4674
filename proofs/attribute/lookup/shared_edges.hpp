// Two base triangles with a common edge, one of them of a lower level: the interpolated values at its points.
#pragma once

#include <string>

#include "proofs/attribute/lookup/hats.hpp"

namespace mmverify::proofs::attribute {

/// A point of the common edge, at/(4N) along it from the first end of the finer map's edge.  That end is the last end
/// of the neighbour's edge, since both triangles wind the same way.
struct SharedEdge {
  std::uint32_t edge;  ///< of the finer map, whose flags mark it
  EdgeFlags flags;
  std::uint32_t beside;  ///< the neighbour's edge, which its flags do not mark
  EdgeFlags its_flags;
  std::uint64_t at;
};

/// The number of cases: 3 edges and 4 sets of other flags on either side, 4N + 1 points.
std::uint64_t shared_edge_cases(Level n);
SharedEdge shared_edge(Level n, std::uint64_t k);
/// "edge=0,flags=1,beside=2,its-flags=0,at=3/8".
std::string text_of(Level n, const SharedEdge& e);
/// Reads what text_of() writes.  Throws BadCase for any other text.
SharedEdge shared_edge_of_text(Level n, const std::string& text);

/// The point on an edge of a map of any level.
DyadicPoint point_on(std::uint32_t edge, std::uint64_t at, Level n);

/// The interpolated values of the finer map of level n and of the neighbour of level `lower`, by places 0..N along
/// the finer map's edge.  Nothing if a vertex off the edge has a weight.
std::optional<Hats> of_finer(const AttributeSubject& s, Level n, const SharedEdge& e);
std::optional<Hats> of_neighbour(const AttributeSubject& s, Level n, Level lower, const SharedEdge& e);

/// The hat functions of an edge of `steps` steps at a point, by places of the finer map: the vertices on either side
/// share the weight.
Hats along_edge(Level n, std::uint64_t at, std::uint32_t steps);

}  // namespace mmverify::proofs::attribute
