// Orders of vertices and faces, in batches.
#include <span>

#include "tests/foreign/attribute/places.hpp"

namespace mmverify::tests::foreign::attribute {
namespace {

using proofs::attribute::Orders;

std::uint32_t converted(VertexOrder from, VertexOrder to, Level n, std::uint32_t x, Fault wrong) {
  if (wrong == convert_corners_stay && (x == 1 || x == 2)) return x;
  if (wrong == convert_to_itself_by_w_minor && from == to && from == VertexOrder::u_major)
    from = VertexOrder::w_minor;
  if (wrong == convert_bird_to_strips_at_8 && n == 8 && from == VertexOrder::bird &&
      to == VertexOrder::u_major)
    to = VertexOrder::w_minor;
  if (wrong == convert_by_reversal && from == VertexOrder::w_minor && to == VertexOrder::u_major)
    return static_cast<std::uint32_t>(vertices_of(n) - 1 - x);
  return index_of(to, n, vertex_of(from, n, x, wrong), wrong);
}

std::uint32_t converted(FaceOrder from, FaceOrder to, Level n, std::uint32_t x, Fault wrong) {
  if (wrong == convert_faces_last_quarter_at_6 && n == 6 && from == FaceOrder::curve &&
      to == FaceOrder::rows && x >= 3u << 10)
    x ^= 1;
  if (wrong == convert_faces_rows_to_strips_reversed && from == FaceOrder::rows && to == FaceOrder::u_major)
    return static_cast<std::uint32_t>((std::uint64_t{1} << 2 * n) - 1 - x);
  if (wrong == convert_faces_in_8_bits && to == FaceOrder::u_major && from == FaceOrder::curve) {
    MicroTriangle t = face_of(from, n, x, wrong);
    t.iv &= 0x7f;
    return index_of(to, n, t, wrong);
  }
  return index_of(to, n, face_of(from, n, x, wrong), wrong);
}

std::uint32_t face_by_vertices(FaceOrder faces, VertexOrder vertices, Level n, const Triplet& t,
                               Fault wrong) {
  const Vertex a = vertex_of(vertices, n, t[0], wrong), b = vertex_of(vertices, n, t[1], wrong),
               c = vertex_of(vertices, n, t[2], wrong);
  bool upper = b.i + 1 == a.i;
  if (wrong == face_by_index_of_first) upper = t[0] > t[2];
  if (wrong == face_by_last_corner_from_4 && n >= 4)
    upper = c.i < a.i || c.j < a.j || (c.i == a.i && a.i > 12);
  const MicroTriangle face = upper ? MicroTriangle{b.i, c.j, true} : MicroTriangle{a.i, a.j, false};
  return index_of(faces, n, face, wrong);
}

/// Each answer, as a batch has them: some faults lie in how it is cut.
template <class From, class To, class Answer>
void each(std::span<const From> from, std::span<To> to, Fault wrong, Answer answer) {
  for (std::size_t k = 0; k < from.size(); ++k) to[k] = answer(from[k]);
  const std::size_t eights = from.size() / 8 * 8;
  if (wrong == orders_tail_from_before && eights > 0)
    for (std::size_t k = eights; k < from.size(); ++k) to[k] = to[k - 8];
}

}  // namespace

Orders orders_with(Fault wrong) {
  Orders f;
  f.vertex_index = [=](VertexOrder order, Level n, std::span<const Vertex> at, std::span<std::uint32_t> out) {
    each(at, out, wrong, [&](const Vertex& x) { return index_of(order, n, x, wrong); });
    if (wrong == orders_batch_over_256)
      for (std::size_t k = 256; k < at.size(); ++k) out[k] = out[k - 256];
  };
  f.vertex_at = [=](VertexOrder order, Level n, std::span<const std::uint32_t> index, std::span<Vertex> out) {
    each(index, out, wrong, [&](std::uint32_t x) { return vertex_of(order, n, x, wrong); });
  };
  f.face_index = [=](FaceOrder order, Level n, std::span<const MicroTriangle> at,
                     std::span<std::uint32_t> out) {
    each(at, out, wrong, [&](const MicroTriangle& t) { return index_of(order, n, t, wrong); });
  };
  f.face_at = [=](FaceOrder order, Level n, std::span<const std::uint32_t> index,
                  std::span<MicroTriangle> out) {
    each(index, out, wrong, [&](std::uint32_t x) { return face_of(order, n, x, wrong); });
  };
  f.convert_vertices = [=](VertexOrder from, VertexOrder to, Level n, std::span<const std::uint32_t> index,
                           std::span<std::uint32_t> out) {
    each(index, out, wrong, [&](std::uint32_t x) { return converted(from, to, n, x, wrong); });
  };
  f.convert_faces = [=](FaceOrder from, FaceOrder to, Level n, std::span<const std::uint32_t> index,
                        std::span<std::uint32_t> out) {
    each(index, out, wrong, [&](std::uint32_t x) { return converted(from, to, n, x, wrong); });
  };
  f.triplet = [=](FaceOrder faces, VertexOrder vertices, Level n, std::span<const std::uint32_t> face,
                  std::span<Triplet> out) {
    each(face, out, wrong,
         [&](std::uint32_t x) { return triplet_of(vertices, n, face_of(faces, n, x, wrong), wrong); });
  };
  f.face_of = [=](FaceOrder faces, VertexOrder vertices, Level n, std::span<const Triplet> triplets,
                  std::span<std::uint32_t> out) {
    each(triplets, out, wrong,
         [&](const Triplet& t) { return face_by_vertices(faces, vertices, n, t, wrong); });
  };
  return f;
}

}  // namespace mmverify::tests::foreign::attribute
