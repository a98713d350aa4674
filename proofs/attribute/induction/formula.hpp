// The orders' formulas in their parts, so that a mutant can have one of them wrong: as the specification has them, here;
// and the orders that come of them, on numbers.
#pragma once

#include <algorithm>

#include "proofs/attribute/subject.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::proofs::attribute::induction {

namespace specified = spec::attribute;
using specified::EdgeMiddle;
using specified::FaceOf;
using specified::UprightExcess;
using specified::VertexOf;

struct Specified {
  template <class Word>
  static Word triangular_root_turn(const Word& x, const Word& r, const Word& bit) {
    return specified::triangular_root_turn(x, r, bit);
  }
  template <class Word>
  static Word square_root_turn(const Word& x, const Word& r, const Word& bit) {
    return spec::index::square_root_turn(x, r, bit);
  }
  template <class Word>
  static Word w_minor(const Word& i, const Word& j) {
    return specified::w_minor_index(i, j);
  }
  template <class Word>
  static VertexOf<Word> w_minor_in_row(const Word& x, const Word& r) {
    return specified::w_minor_in_row(x, r);
  }
  template <class Word>
  static Word u_major(const Word& i, const Word& j, const Word& N) {
    return specified::u_major_of_side(i, j, N);
  }
  template <class Word>
  static VertexOf<Word> u_major_in_row(const Word& y, const Word& r, const Word& N) {
    return specified::u_major_in_row(y, r, N);
  }
  template <class Word>
  static Word rows(const Word& iu, const Word& iv, bool upper) {
    return specified::row_index(iu, iv, upper);
  }
  template <class Word>
  static FaceOf<Word> row_face(const Word& x, const Word& r) {
    return specified::row_face(x, r);
  }
  template <class Word>
  static Word u_major_face(const Word& iu, const Word& iv, bool upper, const Word& N) {
    return specified::u_major_face_of_side(iu, iv, upper, N);
  }
  template <class Word>
  static FaceOf<Word> u_major_face_in_strip(const Word& x, const Word& r, const Word& N) {
    return specified::u_major_face_in_strip(x, r, N);
  }
  template <class Word>
  static std::array<VertexOf<Word>, 3> corners(const Word& iu, const Word& iv, bool upper) {
    return specified::corners_of_square(iu, iv, upper);
  }
  template <class Word>
  static FaceOf<Word> face_of_corners(const VertexOf<Word>& first, const VertexOf<Word>& second) {
    return specified::face_of_corners(first, second);
  }
  template <class At>
  static std::array<At, 3> corners_turn(const std::array<At, 3>& P, std::uint32_t digit) {
    return spec::index::corners_turn(P, digit);
  }
  template <class Word>
  static UprightExcess<Word> upright_turn(const UprightExcess<Word>& at, std::uint64_t digit, const Word& S) {
    return specified::upright_turn(at, digit, S);
  }
  template <class Word>
  static std::uint64_t upright_child(Word& k, const Word& S, bool upright) {
    return specified::upright_child(k, S, upright);
  }
  template <class Word>
  static std::uint64_t bird_corner(const Word& i, const Word& j, const Word& N) {
    return specified::bird_corner(i, j, N);
  }
  template <class Word>
  static bool halved(VertexOf<Word>& at) {
    return specified::halved(at);
  }
  template <class Word>
  static EdgeMiddle<Word> edge_middle(const VertexOf<Word>& at) {
    return specified::edge_middle(at);
  }
  template <class Word>
  static VertexOf<Word> in_the_middle(const EdgeMiddle<Word>& m) {
    return specified::in_the_middle(m);
  }
  template <class Word>
  static Word bird_number(const Word& before, const Word& edge, const Word& M) {
    return specified::bird_number(before, edge, M);
  }
};

/// The orders that iterate the parts as the specification iterates its own, on numbers of 64 bits.
template <class Formula>
struct ByFormula {
  using W = std::uint64_t;

  static W triangular_root(W x) {
    W r = 0;
    for (W bit = W{1} << 31; bit != 0; bit /= 2) r = Formula::triangular_root_turn(x, r, bit);
    return r;
  }
  static W square_root(W x) {
    W r = 0;
    for (W bit = W{1} << 15; bit != 0; bit /= 2) r = Formula::square_root_turn(x, r, bit);
    return r;
  }
  static W upright_before(W x, Level d) {
    UprightExcess<std::int64_t> at{0, true};
    for (Level l = d; l-- > 0;) at = Formula::upright_turn(at, x >> (2 * l) & 3, std::int64_t{1} << l);
    return static_cast<W>(static_cast<std::int64_t>(x) + at.excess) / 2;
  }
  static W upright_number(W k, Level d) {
    W x = 0;
    bool upright = true;
    for (Level l = d; l-- > 0;) {
      const W digit = Formula::upright_child(k, W{1} << l, upright);
      upright = (digit == 1) != upright;
      x = 4 * x + digit;
    }
    return x;
  }
  static MicroTriangle curve_triangle(W x, Level n) {
    const W N = spec::side(n);
    std::array<VertexOf<W>, 3> P{VertexOf<W>{0, 0}, {N, 0}, {0, N}};
    for (Level l = n; l-- > 0;) P = Formula::corners_turn(P, static_cast<std::uint32_t>(x >> (2 * l) & 3));
    return specified::narrowed(specified::face_of_any_corners(P));
  }
  static W bird(const Vertex& v, Level n) {
    if (const W corner = Formula::template bird_corner<W>(v.i, v.j, spec::side(n)); corner < 3) return corner;
    VertexOf<W> at{v.i, v.j};
    Level m = n;
    while (m > 0 && Formula::halved(at)) --m;
    if (m == 0) return 0;
    const EdgeMiddle<W> on = Formula::edge_middle(at);
    const W face = specified::curve_index(specified::narrowed(FaceOf<W>{on.iu, on.iv, 0}), m - 1);
    return Formula::template bird_number<W>(upright_before(face, m - 1), on.edge, spec::side(m - 1));
  }
  static Vertex bird_vertex(W x, Level n) {
    if (x < 3) return specified::bird_vertex(x, n);
    Level m = 1;
    while (x >= specified::vertex_count(m)) ++m;
    const auto place = specified::bird_place<W>(x, spec::side(m - 1));
    const MicroTriangle t = curve_triangle(upright_number(place.before, m - 1), m - 1);
    const Vertex at = specified::narrowed(Formula::in_the_middle(EdgeMiddle<W>{t.iu, t.iv, place.edge}));
    return {at.i << (n - m), at.j << (n - m)};
  }

  static W index(VertexOrder order, const Vertex& v, Level n) {
    if (order == VertexOrder::bird) return bird(v, n);
    return order == VertexOrder::w_minor ? Formula::template w_minor<W>(v.i, v.j)
                                         : Formula::template u_major<W>(v.i, v.j, spec::side(n));
  }
  static Vertex vertex(VertexOrder order, W x, Level n) {
    if (order == VertexOrder::bird) return bird_vertex(x, n);
    if (order == VertexOrder::w_minor)
      return specified::narrowed(Formula::w_minor_in_row(x, triangular_root(x)));
    const W y = specified::vertex_count(n) - 1 - x;
    return specified::narrowed(Formula::template u_major_in_row<W>(y, triangular_root(y), spec::side(n)));
  }
  static W index(FaceOrder order, const MicroTriangle& t, Level n) {
    if (order == FaceOrder::curve) return specified::curve_index(t, n);
    return order == FaceOrder::rows ? Formula::template rows<W>(t.iu, t.iv, t.upper)
                                    : Formula::template u_major_face<W>(t.iu, t.iv, t.upper, spec::side(n));
  }
  static MicroTriangle face(FaceOrder order, W x, Level n) {
    if (order == FaceOrder::curve) return curve_triangle(x, n);
    if (order == FaceOrder::rows) return specified::narrowed(Formula::row_face(x, square_root(x)));
    const W r = square_root(specified::face_count(n) - 1 - x);
    return specified::narrowed(Formula::template u_major_face_in_strip<W>(x, r, spec::side(n)));
  }
  static std::array<W, 3> triplet(VertexOrder order, const MicroTriangle& t, Level n) {
    const auto c = Formula::template corners<W>(t.iu, t.iv, t.upper);
    return {index(order, specified::narrowed(c[0]), n), index(order, specified::narrowed(c[1]), n),
            index(order, specified::narrowed(c[2]), n)};
  }
  static MicroTriangle face_of(VertexOrder order, const Triplet& x, Level n) {
    const Vertex first = vertex(order, x[0], n), second = vertex(order, x[1], n);
    return specified::narrowed(
        Formula::template face_of_corners<W>({first.i, first.j}, {second.i, second.j}));
  }
};

/// The same as a subject has them.
template <class Formula>
Orders orders_by() {
  using By = ByFormula<Formula>;
  using Numbers = std::span<const std::uint32_t>;
  using Out = std::span<std::uint32_t>;
  const auto word = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  Orders f;
  f.vertex_index = [word](VertexOrder order, Level n, std::span<const Vertex> at, Out out) {
    std::transform(at.begin(), at.end(), out.begin(),
                   [&](const Vertex& v) { return word(By::index(order, v, n)); });
  };
  f.vertex_at = [](VertexOrder order, Level n, Numbers index, std::span<Vertex> out) {
    std::transform(index.begin(), index.end(), out.begin(),
                   [&](std::uint32_t x) { return By::vertex(order, x, n); });
  };
  f.face_index = [word](FaceOrder order, Level n, std::span<const MicroTriangle> at, Out out) {
    std::transform(at.begin(), at.end(), out.begin(),
                   [&](const MicroTriangle& t) { return word(By::index(order, t, n)); });
  };
  f.face_at = [](FaceOrder order, Level n, Numbers index, std::span<MicroTriangle> out) {
    std::transform(index.begin(), index.end(), out.begin(),
                   [&](std::uint32_t x) { return By::face(order, x, n); });
  };
  f.triplet = [word](FaceOrder faces, VertexOrder vertices, Level n, Numbers face, std::span<Triplet> out) {
    std::transform(face.begin(), face.end(), out.begin(), [&](std::uint32_t x) {
      const auto t = By::triplet(vertices, By::face(faces, x, n), n);
      return Triplet{word(t[0]), word(t[1]), word(t[2])};
    });
  };
  f.face_of = [word](FaceOrder faces, VertexOrder vertices, Level n, std::span<const Triplet> of, Out out) {
    std::transform(of.begin(), of.end(), out.begin(),
                   [&](const Triplet& t) { return word(By::index(faces, By::face_of(vertices, t, n), n)); });
  };
  return f;
}

}  // namespace mmverify::proofs::attribute::induction
