// The orders of micro-vertices and faces in maps: place to index, and back.
#pragma once

#include <cstdint>

#include "tests/foreign/attribute/faults.hpp"

namespace mmverify::tests::foreign::attribute {

using proofs::attribute::FaceOrder;
using proofs::attribute::MicroTriangle;
using proofs::attribute::Triplet;
using proofs::attribute::Vertex;
using proofs::attribute::VertexOrder;

inline std::uint32_t side_of(Level n) { return std::uint32_t{1} << n; }
inline std::uint64_t vertices_of(Level n) {
  const std::uint64_t N = side_of(n);
  return (N + 1) * (N + 2) / 2;
}

std::uint32_t index_of(VertexOrder, Level, const Vertex&, Fault);
Vertex vertex_of(VertexOrder, Level, std::uint32_t index, Fault);
std::uint32_t index_of(FaceOrder, Level, const MicroTriangle&, Fault);
MicroTriangle face_of(FaceOrder, Level, std::uint32_t index, Fault);

/// The base, and one step along u and along v from there; of an upper one backwards.
std::array<Vertex, 3> face_corners(const MicroTriangle&);
Triplet triplet_of(VertexOrder, Level, const MicroTriangle&, Fault);

}  // namespace mmverify::tests::foreign::attribute
