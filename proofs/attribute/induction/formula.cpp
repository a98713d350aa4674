#include "proofs/attribute/induction/formula.hpp"

namespace mmverify::proofs::attribute::induction {
namespace {

using W = std::uint64_t;

/// The orders on numbers of 64 bits.
struct ByParts {
  PartsOnNumbers by;

  W triangular_root(W x) const {
    W r = 0;
    for (W bit = W{1} << 31; bit != 0; bit /= 2) r = by.triangular_root_turn(x, r, bit);
    return r;
  }
  W square_root(W x) const {
    W r = 0;
    for (W bit = W{1} << 15; bit != 0; bit /= 2) r = by.square_root_turn(x, r, bit);
    return r;
  }
  W upright_before(W x, Level d) const {
    UprightExcess<std::int64_t> at{0, true};
    for (Level l = d; l-- > 0;) at = by.upright_turn(at, x >> (2 * l) & 3, std::int64_t{1} << l);
    return static_cast<W>(static_cast<std::int64_t>(x) + at.excess) / 2;
  }
  W upright_number(W k, Level d) const {
    W x = 0;
    bool upright = true;
    for (Level l = d; l-- > 0;) {
      const W digit = by.upright_child(k, W{1} << l, upright);
      upright = (digit == 1) != upright;
      x = 4 * x + digit;
    }
    return x;
  }
  MicroTriangle curve_triangle(W x, Level n) const {
    const W N = spec::side(n);
    std::array<VertexOf<W>, 3> P{VertexOf<W>{0, 0}, {N, 0}, {0, N}};
    for (Level l = n; l-- > 0;) P = by.corners_turn(P, static_cast<std::uint32_t>(x >> (2 * l) & 3));
    return specified::narrowed(specified::face_of_any_corners(P));
  }
  W bird(const Vertex& v, Level n) const {
    if (const W corner = by.bird_corner(v.i, v.j, spec::side(n)); corner < 3) return corner;
    VertexOf<W> at{v.i, v.j};
    Level m = n;
    while (m > 0 && by.halved(at)) --m;
    if (m == 0) return 0;
    const EdgeMiddle<W> on = by.edge_middle(at);
    const W face = specified::curve_index(specified::narrowed(FaceOf<W>{on.iu, on.iv, 0}), m - 1);
    return by.bird_number(upright_before(face, m - 1), on.edge, spec::side(m - 1));
  }
  Vertex bird_vertex(W x, Level n) const {
    if (x < 3) return specified::bird_vertex(x, n);
    Level m = 1;
    while (x >= specified::vertex_count(m)) ++m;
    const auto place = specified::bird_place<W>(x, spec::side(m - 1));
    const MicroTriangle t = curve_triangle(upright_number(place.before, m - 1), m - 1);
    const Vertex at = specified::narrowed(by.in_the_middle(EdgeMiddle<W>{t.iu, t.iv, place.edge}));
    return {at.i << (n - m), at.j << (n - m)};
  }

  W index(VertexOrder order, const Vertex& v, Level n) const {
    if (order == VertexOrder::bird) return bird(v, n);
    return order == VertexOrder::w_minor ? by.w_minor(v.i, v.j) : by.u_major(v.i, v.j, spec::side(n));
  }
  Vertex vertex(VertexOrder order, W x, Level n) const {
    if (order == VertexOrder::bird) return bird_vertex(x, n);
    if (order == VertexOrder::w_minor) return specified::narrowed(by.w_minor_in_row(x, triangular_root(x)));
    const W y = specified::vertex_count(n) - 1 - x;
    return specified::narrowed(by.u_major_in_row(y, triangular_root(y), spec::side(n)));
  }
  W index(FaceOrder order, const MicroTriangle& t, Level n) const {
    if (order == FaceOrder::curve) return specified::curve_index(t, n);
    return order == FaceOrder::rows ? by.rows(t.iu, t.iv, t.upper)
                                    : by.u_major_face(t.iu, t.iv, t.upper, spec::side(n));
  }
  MicroTriangle face(FaceOrder order, W x, Level n) const {
    if (order == FaceOrder::curve) return curve_triangle(x, n);
    if (order == FaceOrder::rows) return specified::narrowed(by.row_face(x, square_root(x)));
    const W r = square_root(specified::face_count(n) - 1 - x);
    return specified::narrowed(by.u_major_face_in_strip(x, r, spec::side(n)));
  }
  std::array<W, 3> triplet(VertexOrder order, const MicroTriangle& t, Level n) const {
    const auto c = by.corners(t.iu, t.iv, t.upper);
    return {index(order, specified::narrowed(c[0]), n), index(order, specified::narrowed(c[1]), n),
            index(order, specified::narrowed(c[2]), n)};
  }
  MicroTriangle face_of(VertexOrder order, const Triplet& x, Level n) const {
    const Vertex first = vertex(order, x[0], n), second = vertex(order, x[1], n);
    return specified::narrowed(by.face_of_corners({first.i, first.j}, {second.i, second.j}));
  }
};

}  // namespace

Orders orders_by(const PartsOnNumbers& parts) {
  const ByParts by{parts};
  using Numbers = std::span<const std::uint32_t>;
  using Out = std::span<std::uint32_t>;
  const auto word = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  Orders f;
  f.vertex_index = [word, by](VertexOrder order, Level n, std::span<const Vertex> at, Out out) {
    std::transform(at.begin(), at.end(), out.begin(),
                   [&](const Vertex& v) { return word(by.index(order, v, n)); });
  };
  f.vertex_at = [by](VertexOrder order, Level n, Numbers index, std::span<Vertex> out) {
    std::transform(index.begin(), index.end(), out.begin(),
                   [&](std::uint32_t x) { return by.vertex(order, x, n); });
  };
  f.face_index = [word, by](FaceOrder order, Level n, std::span<const MicroTriangle> at, Out out) {
    std::transform(at.begin(), at.end(), out.begin(),
                   [&](const MicroTriangle& t) { return word(by.index(order, t, n)); });
  };
  f.face_at = [by](FaceOrder order, Level n, Numbers index, std::span<MicroTriangle> out) {
    std::transform(index.begin(), index.end(), out.begin(),
                   [&](std::uint32_t x) { return by.face(order, x, n); });
  };
  f.triplet = [word, by](FaceOrder faces, VertexOrder vertices, Level n, Numbers face,
                         std::span<Triplet> out) {
    std::transform(face.begin(), face.end(), out.begin(), [&](std::uint32_t x) {
      const auto t = by.triplet(vertices, by.face(faces, x, n), n);
      return Triplet{word(t[0]), word(t[1]), word(t[2])};
    });
  };
  f.face_of = [word, by](FaceOrder faces, VertexOrder vertices, Level n, std::span<const Triplet> of,
                         Out out) {
    std::transform(of.begin(), of.end(), out.begin(),
                   [&](const Triplet& t) { return word(by.index(faces, by.face_of(vertices, t, n), n)); });
  };
  return f;
}

}  // namespace mmverify::proofs::attribute::induction
