// The orders of the built-in subjects.
#include "proofs/attribute/subject_parts.hpp"

namespace mmverify::proofs::attribute {

namespace slow = mmverify::spec::attribute;

namespace {

std::uint32_t word(std::uint64_t index) { return static_cast<std::uint32_t>(index); }

}  // namespace

Orders specified_orders() {
  Orders f;
  f.vertex_index = [](VertexOrder order, Level n, std::span<const Vertex> at,
                      std::span<std::uint32_t> index) {
    for (std::size_t k = 0; k < at.size(); ++k) index[k] = word(slow::vertex_index(order, at[k], n));
  };
  f.vertex_at = [](VertexOrder order, Level n, std::span<const std::uint32_t> index, std::span<Vertex> at) {
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = slow::vertex_at(order, index[k], n);
  };
  f.face_index = [](FaceOrder order, Level n, std::span<const MicroTriangle> at,
                    std::span<std::uint32_t> index) {
    for (std::size_t k = 0; k < at.size(); ++k) index[k] = word(slow::face_index(order, at[k], n));
  };
  f.face_at = [](FaceOrder order, Level n, std::span<const std::uint32_t> index,
                 std::span<MicroTriangle> at) {
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = slow::triangle_at(order, index[k], n);
  };
  f.triplet = [](FaceOrder faces, VertexOrder vertices, Level n, std::span<const std::uint32_t> face,
                 std::span<Triplet> out) {
    for (std::size_t k = 0; k < out.size(); ++k) {
      const slow::Triplet t = slow::triplet(vertices, slow::triangle_at(faces, face[k], n), n);
      out[k] = {word(t[0]), word(t[1]), word(t[2])};
    }
  };
  f.face_of = [](FaceOrder faces, VertexOrder vertices, Level n, std::span<const Triplet> of,
                 std::span<std::uint32_t> face) {
    for (std::size_t k = 0; k < of.size(); ++k) {
      const slow::Triplet t{of[k][0], of[k][1], of[k][2]};
      face[k] = word(slow::face_index(faces, slow::triangle_of_triplet(vertices, t, n), n));
    }
  };
  return f;
}

}  // namespace mmverify::proofs::attribute
