// The orders by walking them: counted, in the place of closed forms.
#pragma once

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

/// The index of each vertex of a level in the three orders, as a walk meets them:
///   W-minor   row after row from the w-corner, each from the edge w-u on
///   U-major   column after column from the edge w-v, each from v = 0 on
///   Bird      the corners w, u, v; then, level by level, along the curve of the level before, the middles of the edges
///             w-v, u-v and w-u of each micro-triangle that stands upright
/// Source: Color and Attribute Micromaps, 3.1.  Domain: n in 0..13, as a table is made of Bird.
class VertexWalks {
 public:
  explicit VertexWalks(Level n);
  std::uint32_t index(VertexOrder order, const Vertex& at) const;

 private:
  std::vector<std::uint32_t> rows_, columns_;  ///< number of the first vertex of each
  std::vector<std::uint32_t> bird_;            ///< by number in U-major
};

/// That of a level, made once and kept: laws that run side by side are at several levels.  Memory of all: 180 MB.
const VertexWalks& vertex_walks(Level n);

/// Number k of a sample of the level's vertices.  Of each eight in turn: any; near a corner; near an edge; beside a row's
/// or a column's first; beside powers of two; two that have, in one of the orders, an index beside a power of two; one
/// that has, in one of them, an index beside a multiple of 2^16.
Vertex drawn_vertex(Level n, std::uint64_t k, std::uint64_t seed);
/// The face that has the vertex for its base, an upper one as often as a lower one; of a vertex on the hypotenuse one
/// that it is a corner of.
MicroTriangle drawn_face(Level n, std::uint64_t k, std::uint64_t seed);

}  // namespace mmverify::proofs::attribute
