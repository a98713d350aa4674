// Places of a level where orders are apt to be wrong, and others at random.
#pragma once

#include <cstdint>

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

/// Number k of a sample of the level's vertices.  Of each eight in turn: any; near a corner; near an edge; beside a row's
/// or a column's first; beside powers of two; two that have, in one of the orders, an index beside a power of two; one
/// that has, in one of them, an index beside a multiple of 2^16.
Vertex drawn_vertex(Level n, std::uint64_t k, std::uint64_t seed);
/// The face that has the vertex for its base, an upper one as often as a lower one; of a vertex on the hypotenuse one
/// that it is a corner of.
MicroTriangle drawn_face(Level n, std::uint64_t k, std::uint64_t seed);

}  // namespace mmverify::proofs::attribute
