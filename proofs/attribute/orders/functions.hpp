// The functions of a subject of topic attribute for orders: index <-> place, of vertices and of faces.
#pragma once

#include <span>

#include "proofs/engine/law.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::proofs::attribute {

using spec::attribute::FaceOrder;
using spec::attribute::MicroTriangle;
using spec::attribute::Vertex;
using spec::attribute::VertexOrder;

/// The indices of three vertices, as subjects give them; they fit 32 bits up to level 16.
using Triplet = std::array<std::uint32_t, 3>;

/// Batches: answer k is that of element k, one answer an element.  Domain: level n in 0..16, elements of that level.
struct Orders {
  std::function<void(VertexOrder, Level n, std::span<const Vertex>, std::span<std::uint32_t> index)>
      vertex_index = {};
  std::function<void(VertexOrder, Level n, std::span<const std::uint32_t> index, std::span<Vertex>)>
      vertex_at = {};
  std::function<void(FaceOrder, Level n, std::span<const MicroTriangle>, std::span<std::uint32_t> index)>
      face_index = {};
  std::function<void(FaceOrder, Level n, std::span<const std::uint32_t> index, std::span<MicroTriangle>)>
      face_at = {};
  /// An index of one order to the index in another.
  std::function<void(VertexOrder from, VertexOrder to, Level n, std::span<const std::uint32_t> index,
                     std::span<std::uint32_t>)>
      convert_vertices = {};
  std::function<void(FaceOrder from, FaceOrder to, Level n, std::span<const std::uint32_t> index,
                     std::span<std::uint32_t>)>
      convert_faces = {};
  /// The vertices of faces, both by index: the base, then one step along u and one along v (backwards for upper
  /// faces).
  std::function<void(FaceOrder, VertexOrder, Level n, std::span<const std::uint32_t> face,
                     std::span<Triplet>)>
      triplet = {};
  /// The face of a triplet.
  std::function<void(FaceOrder, VertexOrder, Level n, std::span<const Triplet>,
                     std::span<std::uint32_t> face)>
      face_of = {};
};

}  // namespace mmverify::proofs::attribute
