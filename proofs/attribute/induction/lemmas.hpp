// The lemmas about rows, columns, strips and corners, each written by running the specification's own templates on
// names.  No level occurs in them: N, the number of micro-triangles to a side, is a variable, and need be no power of
// two.
#pragma once

#include "proofs/attribute/induction/formula.hpp"
#include "proofs/attribute/induction/names.hpp"

namespace mmverify::proofs::attribute::induction {

/// r(r+1)/2 as the specification computes it, and that it grows.
void add_triangular(std::vector<Statement>& all);
/// The same of r^2.
void add_square(std::vector<Statement>& all);

/// Declares the names of a vertex with N micro-triangles to a side: i, j >= 0, i+j <= N.
VertexOf<Counted> declare_vertex(Script& script, const Counted& N);
/// i, j >= 0, i+j <= N.
Term is_vertex(const VertexOf<Counted>& at, const Counted& N);
Term same_vertex(const VertexOf<Counted>& a, const VertexOf<Counted>& b);
/// iu, iv >= 0, iu+iv < N, and if upper is 1 iu+iv < N-1.
Term is_face(const FaceOf<Counted>& t, const Counted& N);
Term same_face(const FaceOf<Counted>& a, const FaceOf<Counted>& b);
/// A vertex or a face that a program leaves, its members under names that begin so.
template <class Program>
VertexOf<Counted> vertex_outcome(Script& script, const std::string& prefix, Program program) {
  using At = VertexOf<Counted>;
  return {outcome(script, prefix + "_i", program, [](const At& at) { return at.i; }),
          outcome(script, prefix + "_j", program, [](const At& at) { return at.j; })};
}
template <class Program>
FaceOf<Counted> face_outcome(Script& script, const std::string& prefix, Program program) {
  using Face = FaceOf<Counted>;
  return {outcome(script, prefix + "_iu", program, [](const Face& t) { return t.iu; }),
          outcome(script, prefix + "_iv", program, [](const Face& t) { return t.iv; }),
          outcome(script, prefix + "_upper", program, [](const Face& t) { return t.upper; })};
}
/// An index, of which a program may take branches.
template <class Program>
Counted index_outcome(Script& script, const std::string& name, Program program) {
  return outcome(script, name, program, [](const Counted& x) { return x; });
}

/// Whether `upper` is 1, decided on a path.
inline bool is_upper(const FaceOf<Counted>& t) { return t.upper == 1; }

// ---------------------------------------------------------------------------------------------------------------------
// Roots
// ---------------------------------------------------------------------------------------------------------------------

template <class Formula>
void add_triangular_root(std::vector<Statement>& all) {
  add(all, "triangular_root",
      "The loop of triangular_root: it begins with r = 0 and a bit b with x < T(2b); a turn keeps T(r) <= x "
      "< "
      "T(r + 2b), with half the bit, and after the turn with b = 1 it is T(r) <= x < T(r + 1).",
      [](Script& script) {
        suppose_triangular(script);
        const Counted x = whole(script, "x"), r = whole(script, "r"), b = whole(script, "b");
        script.require(both({at_most(0, r), at_most(1, b), at_most(0, x)}));
        script.require(both({at_most(triangular(r), x), less(x, triangular(r + 2 * b))}));
        const Counted next =
            index_outcome(script, "next", [&] { return Formula::triangular_root_turn(x, r, b); });
        return Lemma{{at_most(r, next), at_most(triangular(next), x), less(x, triangular(next + b)),
                      at_most(triangular(Counted(0)), x)},
                     both({less(1, r), less(1, b)})};
      });
}

template <class Formula>
void add_square_root(std::vector<Statement>& all) {
  add(all, "square_root",
      "The loop of w_minor_row: it begins with r = 0 and a bit b with x < S(2b); a turn keeps S(r) <= x < "
      "S(r + 2b), "
      "with half the bit, and after the turn with b = 1 it is S(r) <= x < S(r + 1).",
      [](Script& script) {
        suppose_square(script);
        const Counted x = whole(script, "x"), r = whole(script, "r"), b = whole(script, "b");
        script.require(both({at_most(0, r), at_most(1, b), at_most(0, x)}));
        script.require(both({at_most(square(r), x), less(x, square(r + 2 * b))}));
        const Counted next =
            index_outcome(script, "next", [&] { return Formula::square_root_turn(x, r, b); });
        return Lemma{{at_most(r, next), at_most(square(next), x), less(x, square(next + b)),
                      at_most(square(Counted(0)), x)},
                     both({less(1, r), less(1, b)})};
      });
}

/// Declares r, a root of x: T(r) <= x < T(r+1), r >= 0; supposes what compares it with another row.
Counted declare_triangular_root(Script& script, const Counted& x, const Counted& other_row);
Counted declare_square_root(Script& script, const Counted& x, const Counted& other_row);

// ---------------------------------------------------------------------------------------------------------------------
// W-minor
// ---------------------------------------------------------------------------------------------------------------------

template <class Formula>
void add_w_minor(std::vector<Statement>& all) {
  add(all, "w_minor_back", "W-minor: from a vertex to its index and back is that vertex, whatever N is.",
      [](Script& script) {
        suppose_triangular(script);
        const VertexOf<Counted> at{whole(script, "i"), whole(script, "j")};
        script.require(both({at_most(0, at.i), at_most(0, at.j)}));
        const Counted x =
            index_outcome(script, "x", [&] { return Formula::template w_minor<Counted>(at.i, at.j); });
        const Counted r = declare_triangular_root(script, x, at.i + at.j);
        const auto back = vertex_outcome(script, "back", [&] { return Formula::w_minor_in_row(x, r); });
        return Lemma{{same_vertex(back, at)}, both({less(0, at.i), less(at.i, at.j)})};
      });
  add(all, "w_minor_onto",
      "W-minor: every x >= 0 is the index of the vertex that the way back gives; and x < T(N+1) says the "
      "same as i+j <= "
      "N, for every N: the indices below T(N+1) are those of N micro-triangles to a side, and a finer level "
      "begins with "
      "them, number by number.",
      [](Script& script) {
        suppose_triangular(script);
        const Counted x = whole(script, "x"), N = whole(script, "N");
        script.require(both({at_most(0, x), at_most(0, N)}));
        const Counted r = declare_triangular_root(script, x, N + 1);
        const auto at = vertex_outcome(script, "at", [&] { return Formula::w_minor_in_row(x, r); });
        const Counted index =
            index_outcome(script, "index", [&] { return Formula::template w_minor<Counted>(at.i, at.j); });
        return Lemma{{at_most(0, at.i), at_most(0, at.j), same(index, x),
                      equal(less(x, specified::vertices_of_side(N)), at_most(at.i + at.j, N))},
                     both({less(0, at.i), less(0, at.j), less(2, N)})};
      });
  add(all, "w_minor_moves",
      "W-minor: a vertex (i, j) is (2i, 2j) a level on, and its index there is greater, but for the "
      "w-corner's, which is "
      "0 on both.",
      [](Script& script) {
        suppose_triangular(script);
        const VertexOf<Counted> at{whole(script, "i"), whole(script, "j")};
        script.require(both({at_most(0, at.i), at_most(0, at.j)}));
        for (const Counted& r : {at.i + at.j, 2 * at.i + 2 * at.j}) {
          suppose_twice(script, r);
          suppose_ordered(script, 0, r);
        }
        suppose_ordered(script, at.i + at.j, 2 * at.i + 2 * at.j);
        const auto index = [&](const char* name, const Counted& i, const Counted& j) {
          return index_outcome(script, name, [&] { return Formula::template w_minor<Counted>(i, j); });
        };
        const Counted here = index("here", at.i, at.j), next = index("next", 2 * at.i, 2 * at.j);
        const Term corner = both({same(at.i, 0), same(at.j, 0)});
        return Lemma{
            {implies(no(corner), less(here, next)), implies(corner, both({same(here, 0), same(next, 0)}))},
            both({same(at.i, 1), same(at.j, 2)})};
      });
}

// ---------------------------------------------------------------------------------------------------------------------
// U-major
// ---------------------------------------------------------------------------------------------------------------------

/// U-major of a vertex is W-minor of the vertex turned, from the last one: what umajor_reversed proves, supposed.
void suppose_reversed(Script& script, const Counted& x, const VertexOf<Counted>& at, const Counted& N);

template <class Formula>
void add_u_major(std::vector<Statement>& all) {
  add(all, "u_major_reversed",
      "U-major(i, j) = T(N+1) - 1 - W-minor(j, N-i-j): the rows from the u-corner, backwards.",
      [](Script& script) {
        suppose_triangular(script);
        const Counted N = whole(script, "N");
        const auto at = declare_vertex(script, N);
        for (const Counted& r : {at.i, N - at.i, N + 1}) suppose_twice(script, r);
        const Counted x =
            index_outcome(script, "x", [&] { return Formula::template u_major<Counted>(at.i, at.j, N); });
        const Counted turned = index_outcome(
            script, "turned", [&] { return Specified::w_minor<Counted>(at.j, N - at.i - at.j); });
        return Lemma{{same(x, specified::vertices_of_side(N) - 1 - turned)},
                     both({less(0, at.i), less(at.i, at.j), less(at.i + at.j, N)})};
      });
  add(all, "u_major_back",
      "U-major: from a vertex to its index, which is below T(N+1), and back is that vertex.",
      [](Script& script) {
        suppose_triangular(script);
        const Counted N = whole(script, "N");
        const auto at = declare_vertex(script, N);
        const Counted x =
            index_outcome(script, "x", [&] { return Formula::template u_major<Counted>(at.i, at.j, N); });
        suppose_reversed(script, x, at, N);
        const Counted y = named(script, "y", specified::vertices_of_side(N) - 1 - x);
        const Counted r = declare_triangular_root(script, y, N - at.i);
        suppose_ordered(script, N - at.i, N + 1);
        suppose_ordered(script, 0, N - at.i);
        const auto back = vertex_outcome(script, "back", [&] { return Formula::u_major_in_row(y, r, N); });
        return Lemma{{within(0, x, specified::vertices_of_side(N)), same_vertex(back, at)},
                     both({less(0, at.i), less(0, at.j), less(at.i + at.j, N)})};
      });
  add(all, "u_major_onto",
      "U-major: every x in [0, T(N+1)) is the index of the vertex that the way back gives.",
      [](Script& script) {
        suppose_triangular(script);
        const Counted x = whole(script, "x"), N = whole(script, "N");
        script.require(at_most(0, N));
        script.require(within(0, x, specified::vertices_of_side(N)));
        const Counted y = named(script, "y", specified::vertices_of_side(N) - 1 - x);
        const Counted r = declare_triangular_root(script, y, N + 1);
        const auto at = vertex_outcome(script, "at", [&] { return Formula::u_major_in_row(y, r, N); });
        const Counted index =
            index_outcome(script, "index", [&] { return Formula::template u_major<Counted>(at.i, at.j, N); });
        suppose_reversed(script, index, at, N);
        return Lemma{{is_vertex(at, N), same(index, x)},
                     both({less(0, at.i), less(0, at.j), less(at.i + at.j, N)})};
      });
  add(all, "u_major_moves",
      "U-major: a vertex's index is greater a level on, but for the w-corner's, which is 0 on both.",
      [](Script& script) {
        suppose_triangular(script);
        const Counted N = whole(script, "N");
        const auto at = declare_vertex(script, N);
        script.require(at_most(1, N));
        suppose_twice(script, at.i);
        suppose_twice(script, 2 * at.i);
        suppose_ordered(script, 0, at.i);
        script.comment("A product of two numbers that are not negative.");
        script.require(at_most(0, at.i * (N - at.i)));
        const auto index = [&](const char* name, const Counted& i, const Counted& j, const Counted& side) {
          return index_outcome(script, name, [&] { return Formula::template u_major<Counted>(i, j, side); });
        };
        const Counted here = index("here", at.i, at.j, N), next = index("next", 2 * at.i, 2 * at.j, 2 * N);
        const Term corner = both({same(at.i, 0), same(at.j, 0)});
        return Lemma{
            {implies(no(corner), less(here, next)), implies(corner, both({same(here, 0), same(next, 0)}))},
            both({less(0, at.i), less(0, at.j), less(at.i + at.j, N)})};
      });
}

// ---------------------------------------------------------------------------------------------------------------------
// Faces in rows and in strips
// ---------------------------------------------------------------------------------------------------------------------

FaceOf<Counted> declare_face(Script& script, const Counted& N);
/// U-major of a face is its row index turned, from the last one: what u_major_faces_reversed proves, supposed.
void suppose_faces_reversed(Script& script, const Counted& x, const FaceOf<Counted>& t, const Counted& N);

template <class Formula>
void add_faces(std::vector<Statement>& all) {
  const auto row_of = [](Script& script, const char* name, const FaceOf<Counted>& t) {
    return index_outcome(script, name,
                         [&] { return Formula::template rows<Counted>(t.iu, t.iv, is_upper(t)); });
  };
  const auto strip_of = [](Script& script, const char* name, const FaceOf<Counted>& t, const Counted& N) {
    return index_outcome(script, name,
                         [&] { return Formula::template u_major_face<Counted>(t.iu, t.iv, is_upper(t), N); });
  };
  add(all, "rows_back", "Faces in rows: from a face to its index and back is that face, whatever N is.",
      [&](Script& script) {
        suppose_square(script);
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        const Counted x = row_of(script, "x", t);
        const Counted r = declare_square_root(script, x, t.iu + t.iv + t.upper);
        const auto back = face_outcome(script, "back", [&] { return Formula::row_face(x, r); });
        return Lemma{{same_face(back, t)}, both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
  add(all, "rows_onto",
      "Faces in rows: every x >= 0 is the index of the face that the way back gives; and x < S(N) says the "
      "same as that "
      "it is a face with N to a side, for every N.",
      [&](Script& script) {
        suppose_square(script);
        const Counted x = whole(script, "x"), N = whole(script, "N");
        script.require(both({at_most(0, x), at_most(1, N)}));
        const Counted r = declare_square_root(script, x, N);
        const auto t = face_outcome(script, "t", [&] { return Formula::row_face(x, r); });
        const Counted index = row_of(script, "index", t);
        return Lemma{{within(0, t.upper, 2), at_most(0, t.iu), at_most(0, t.iv), same(index, x),
                      equal(less(x, square(N)), is_face(t, N))},
                     both({less(0, t.iu), less(0, t.iv), same(t.upper, 1), less(2, N)})};
      });
  add(all, "u_major_faces_reversed",
      "Faces in U-major: 2N iu - iu iu + 2 iv + upper = N N - 1 - the row index of the face turned, (iv, "
      "N-1-iu-iv-upper): the rows from the u-corner, backwards.",
      [&](Script& script) {
        suppose_square(script);
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        const Counted x = strip_of(script, "x", t, N);
        const Counted row = named(script, "row", N - 1 - t.iu);
        for (const Counted& r : {t.iu, row, N}) suppose_square_product(script, r);
        const Counted turned_iv = named(script, "turned_iv", row - t.iv - t.upper);
        const Counted turned = index_outcome(
            script, "turned", [&] { return Specified::rows<Counted>(t.iv, turned_iv, is_upper(t)); });
        return Lemma{{same(x, square(N) - 1 - turned)},
                     both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
  add(all, "u_major_faces_back",
      "Faces in U-major: from a face to its index, which is below N N, and back is that face.",
      [&](Script& script) {
        suppose_square(script);
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        const Counted x = strip_of(script, "x", t, N);
        suppose_faces_reversed(script, x, t, N);
        const Counted y = named(script, "y", square(N) - 1 - x);
        const Counted r = declare_square_root(script, y, N - 1 - t.iu);
        suppose_square_ordered(script, N - 1 - t.iu, N);
        suppose_square_ordered(script, 0, N - 1 - t.iu);
        const auto back =
            face_outcome(script, "back", [&] { return Formula::u_major_face_in_strip(x, r, N); });
        return Lemma{{within(0, x, square(N)), same_face(back, t)},
                     both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
  add(all, "u_major_faces_onto",
      "Faces in U-major: every x in [0, N N) is the index of the face that the way back gives.",
      [&](Script& script) {
        suppose_square(script);
        const Counted x = whole(script, "x"), N = whole(script, "N");
        script.require(at_most(1, N));
        script.require(within(0, x, square(N)));
        const Counted y = named(script, "y", square(N) - 1 - x);
        const Counted r = declare_square_root(script, y, N);
        const auto t = face_outcome(script, "t", [&] { return Formula::u_major_face_in_strip(x, r, N); });
        const Counted index = strip_of(script, "index", t, N);
        for (const Counted& s : {N - 1 - r, r, N}) suppose_square_product(script, s);
        return Lemma{{is_face(t, N), same(index, x)}, both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
  add(all, "corners",
      "A face's corners are vertices of its level, wind like the base triangle, (x1-x0)(y2-y0) - "
      "(x2-x0)(y1-y0) = 1, and "
      "the first two tell the face.",
      [](Script& script) {
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        std::vector<VertexOf<Counted>> c;
        for (std::size_t k = 0; k < 3; ++k)
          c.push_back(vertex_outcome(script, "c" + std::to_string(k), [&] {
            return Formula::template corners<Counted>(t.iu, t.iv, is_upper(t))[k];
          }));
        const auto back = face_outcome(script, "back", [&] { return Formula::face_of_corners(c[0], c[1]); });
        const Counted winding = (c[1].i - c[0].i) * (c[2].j - c[0].j) - (c[2].i - c[0].i) * (c[1].j - c[0].j);
        return Lemma{{is_vertex(c[0], N), is_vertex(c[1], N), is_vertex(c[2], N), same(winding, 1),
                      same_face(back, t)},
                     both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
}

}  // namespace mmverify::proofs::attribute::induction
