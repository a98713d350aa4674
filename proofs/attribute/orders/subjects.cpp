// The orders of the built-in subjects.
#include "impl/attribute/order.hpp"
#include "proofs/attribute/subject_parts.hpp"

namespace mmverify::proofs::attribute {

namespace slow = mmverify::spec::attribute;
namespace fast = mmverify::impl::attribute;

namespace {

using Numbers = std::span<const std::uint32_t>;
using Out = std::span<std::uint32_t>;

std::uint32_t word(std::uint64_t index) { return static_cast<std::uint32_t>(index); }

fast::VertexOrder to_fast(VertexOrder order) { return static_cast<fast::VertexOrder>(order); }
fast::FaceOrder to_fast(FaceOrder order) { return static_cast<fast::FaceOrder>(order); }
fast::MicroTriangle to_fast(const MicroTriangle& t) { return {t.iu, t.iv, t.upper}; }
Vertex from_fast(const fast::Vertex& v) { return {v.i, v.j}; }
MicroTriangle from_fast(const fast::MicroTriangle& t) { return {t.iu, t.iv, t.upper}; }

/// So many elements apart: their members in arrays of their own.
template <std::size_t arrays>
class Apart {
 public:
  explicit Apart(std::size_t count) : count_(count), words_(arrays * count) {}
  std::span<std::uint32_t> operator[](std::size_t array) {
    return std::span(words_).subspan(array * count_, count_);
  }

 private:
  std::size_t count_;
  std::vector<std::uint32_t> words_;
};

/// out[k] = one(in[k]).
template <class In, class To, class One>
void each(std::span<const In> in, std::span<To> out, One one) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = one(in[k]);
}

}  // namespace

Orders specified_orders() {
  Orders f;
  f.vertex_index = [](VertexOrder order, Level n, std::span<const Vertex> at, Out out) {
    each(at, out, [&](const Vertex& v) { return word(slow::vertex_index(order, v, n)); });
  };
  f.vertex_at = [](VertexOrder order, Level n, Numbers index, std::span<Vertex> out) {
    each(index, out, [&](std::uint32_t x) { return slow::vertex_at(order, x, n); });
  };
  f.face_index = [](FaceOrder order, Level n, std::span<const MicroTriangle> at, Out out) {
    each(at, out, [&](const MicroTriangle& t) { return word(slow::face_index(order, t, n)); });
  };
  f.face_at = [](FaceOrder order, Level n, Numbers index, std::span<MicroTriangle> out) {
    each(index, out, [&](std::uint32_t x) { return slow::triangle_at(order, x, n); });
  };
  f.convert_vertices = [](VertexOrder from, VertexOrder to, Level n, Numbers index, Out out) {
    each(index, out,
         [&](std::uint32_t x) { return word(slow::vertex_index(to, slow::vertex_at(from, x, n), n)); });
  };
  f.convert_faces = [](FaceOrder from, FaceOrder to, Level n, Numbers index, Out out) {
    each(index, out,
         [&](std::uint32_t x) { return word(slow::face_index(to, slow::triangle_at(from, x, n), n)); });
  };
  f.triplet = [](FaceOrder faces, VertexOrder vertices, Level n, Numbers face, std::span<Triplet> out) {
    each(face, out, [&](std::uint32_t x) {
      const slow::Triplet t = slow::triplet(vertices, slow::triangle_at(faces, x, n), n);
      return Triplet{word(t[0]), word(t[1]), word(t[2])};
    });
  };
  f.face_of = [](FaceOrder faces, VertexOrder vertices, Level n, std::span<const Triplet> of, Out out) {
    each(of, out, [&](const Triplet& t) {
      return word(slow::face_index(faces, slow::triangle_of_triplet(vertices, {t[0], t[1], t[2]}, n), n));
    });
  };
  return f;
}

Orders library_orders() {
  Orders f;
  f.vertex_index = [](VertexOrder order, Level n, std::span<const Vertex> at, Out out) {
    Apart<2> in(at.size());
    for (std::size_t k = 0; k < at.size(); ++k) {
      in[0][k] = at[k].i;
      in[1][k] = at[k].j;
    }
    fast::vertex_index(to_fast(order), in[0], in[1], n, out);
  };
  f.vertex_at = [](VertexOrder order, Level n, Numbers index, std::span<Vertex> out) {
    Apart<2> found(out.size());
    fast::vertex_at(to_fast(order), index, n, {found[0], found[1]});
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = {found[0][k], found[1][k]};
  };
  f.face_index = [](FaceOrder order, Level n, std::span<const MicroTriangle> at, Out out) {
    Apart<3> in(at.size());
    for (std::size_t k = 0; k < at.size(); ++k) {
      in[0][k] = at[k].iu;
      in[1][k] = at[k].iv;
      in[2][k] = at[k].upper ? 1 : 0;
    }
    fast::face_index(to_fast(order), in[0], in[1], in[2], n, out);
  };
  f.face_at = [](FaceOrder order, Level n, Numbers index, std::span<MicroTriangle> out) {
    Apart<3> found(out.size());
    fast::face_at(to_fast(order), index, n, {found[0], found[1], found[2]});
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = {found[0][k], found[1][k], found[2][k] != 0};
  };
  f.convert_vertices = [](VertexOrder from, VertexOrder to, Level n, Numbers index, Out out) {
    fast::convert(to_fast(from), to_fast(to), index, n, out);
  };
  f.convert_faces = [](FaceOrder from, FaceOrder to, Level n, Numbers index, Out out) {
    fast::convert(to_fast(from), to_fast(to), index, n, out);
  };
  f.triplet = [](FaceOrder faces, VertexOrder vertices, Level n, Numbers face, std::span<Triplet> out) {
    Apart<3> found(out.size());
    fast::triplets(to_fast(faces), to_fast(vertices), face, n, {found[0], found[1], found[2]});
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = {found[0][k], found[1][k], found[2][k]};
  };
  f.face_of = [](FaceOrder faces, VertexOrder vertices, Level n, std::span<const Triplet> of, Out out) {
    Apart<2> in(of.size());
    for (std::size_t k = 0; k < of.size(); ++k) {
      in[0][k] = of[k][0];
      in[1][k] = of[k][1];
    }
    fast::faces_of(to_fast(faces), to_fast(vertices), in[0], in[1], n, out);
  };
  return f;
}

Orders library_orders_one_by_one() {
  Orders f;
  f.vertex_index = [](VertexOrder order, Level n, std::span<const Vertex> at, Out out) {
    each(at, out, [&](const Vertex& v) { return fast::vertex_index(to_fast(order), v.i, v.j, n); });
  };
  f.vertex_at = [](VertexOrder order, Level n, Numbers index, std::span<Vertex> out) {
    each(index, out, [&](std::uint32_t x) { return from_fast(fast::vertex_at(to_fast(order), x, n)); });
  };
  f.face_index = [](FaceOrder order, Level n, std::span<const MicroTriangle> at, Out out) {
    each(at, out, [&](const MicroTriangle& t) { return fast::face_index(to_fast(order), to_fast(t), n); });
  };
  f.face_at = [](FaceOrder order, Level n, Numbers index, std::span<MicroTriangle> out) {
    each(index, out, [&](std::uint32_t x) { return from_fast(fast::face_at(to_fast(order), x, n)); });
  };
  f.triplet = [](FaceOrder faces, VertexOrder vertices, Level n, Numbers face, std::span<Triplet> out) {
    each(face, out, [&](std::uint32_t x) {
      return fast::triplet(to_fast(vertices), fast::face_at(to_fast(faces), x, n), n);
    });
  };
  f.face_of = [](FaceOrder faces, VertexOrder vertices, Level n, std::span<const Triplet> of, Out out) {
    each(of, out, [&](const Triplet& t) {
      return fast::face_index(to_fast(faces), fast::triangle_of(to_fast(vertices), t, n), n);
    });
  };
  return f;
}

Orders orders_in_32_bits() {
  Orders f;
  f.vertex_index = [](VertexOrder order, Level n, std::span<const Vertex> at, Out out) {
    each(at, out, [&](const Vertex& v) {
      return order == VertexOrder::w_minor ? slow::w_minor_index<std::uint32_t>(v.i, v.j)
                                           : slow::u_major_index<std::uint32_t>(v.i, v.j, n);
    });
  };
  return f;
}

Orders figure_4_triplets(bool short_root) {
  Orders f;
  f.triplet = [short_root](FaceOrder, VertexOrder, Level, Numbers face, std::span<Triplet> out) {
    each(face, out, [&](std::uint32_t index) {
      float root = std::sqrt(static_cast<float>(index));
      if (short_root) root = std::nextafter(root, 0.0f);
      const auto row = static_cast<std::uint32_t>(root);
      const std::uint32_t col = index - row * row, c = col / 2;
      const auto to_index = [](std::uint32_t r, std::uint32_t column) { return r * (r + 1) / 2 + column; };
      if (col % 2 == 0) return Triplet{to_index(row, c), to_index(row + 1, c), to_index(row + 1, c + 1)};
      return Triplet{to_index(row, c), to_index(row + 1, c + 1), to_index(row, c + 1)};
    });
  };
  return f;
}

}  // namespace mmverify::proofs::attribute
