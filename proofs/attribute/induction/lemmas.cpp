#include "proofs/attribute/induction/lemmas.hpp"

namespace mmverify::proofs::attribute::induction {

using namespace proofs::induction;

void add_triangular(std::vector<Statement>& all) {
  add(all, "triangular_base", "The induction's base: spec::attribute::triangular(0) is 0, half of 0 times 1.",
      [](Script& script) {
        const Counted zero(script.define("T_0", specified::triangular(Integer(0)).term));
        return Lemma{{same(zero, 0), same(2 * zero, 0)}, truth(true)};
      });
  add(all, "triangular_step",
      "The induction's step. Supposed that half of r(r+1) is a whole number h, "
      "spec::attribute::triangular(r) is h and triangular(r+1) is h+r+1, which is half of (r+1)(r+2). So for "
      "every r >= 0, 2 T(r) = r(r+1) and T(r+1) = T(r) + r + 1.",
      [](Script& script) {
        const Counted r = whole(script, "r"), h = whole(script, "h");
        script.require(at_most(0, r));
        script.require(same(2 * h, r * (r + 1)));
        const Counted here(script.define("T_r", specified::triangular(Integer(r.term)).term));
        const Counted next(script.define("T_next", specified::triangular(Integer((r + 1).term)).term));
        return Lemma{{same(here, h), same(next, h + r + 1), same(2 * (h + r + 1), (r + 1) * (r + 1 + 1))},
                     both({same(r, 3)})};
      });
  add(all, "triangular_ordered",
      "T grows, by an induction over q from r+1 on, where it is the step's: if T(q) >= T(r+1) then T(q+1) >= "
      "T(r+1).",
      [](Script& script) {
        suppose_triangular(script);
        const Counted r = whole(script, "r"), q = whole(script, "q");
        script.require(both({at_most(0, r), less(r, q)}));
        suppose_step(script, r);
        suppose_step(script, q);
        script.require(at_most(triangular(r + 1), triangular(q)));
        return Lemma{
            {at_most(triangular(r) + r + 1, triangular(q)), at_most(triangular(r + 1), triangular(q + 1))},
            less(r + 1, q)};
      });
}

void add_square(std::vector<Statement>& all) {
  add(all, "square_step",
      "spec::index::square is 0 of 0 and grows by 2r+1: (r+1)(r+1) = r r + 2r + 1, for every r.",
      [](Script& script) {
        const Counted r = whole(script, "r");
        const Counted zero(script.define("S_0", spec::index::square(Integer(0)).term));
        const Counted here(script.define("S_r", spec::index::square(Integer(r.term)).term));
        const Counted next(script.define("S_next", spec::index::square(Integer((r + 1).term)).term));
        return Lemma{{same(zero, 0), same(here, r * r), same(next, here + 2 * r + 1)}, same(r, 3)};
      });
  add(all, "square_ordered",
      "S grows, by an induction over q from r+1 on, where it is the step's: if S(q) >= S(r+1) then S(q+1) >= "
      "S(r+1).",
      [](Script& script) {
        suppose_square(script);
        const Counted r = whole(script, "r"), q = whole(script, "q");
        script.require(both({at_most(0, r), less(r, q)}));
        suppose_square_step(script, r);
        suppose_square_step(script, q);
        script.require(at_most(square(r + 1), square(q)));
        return Lemma{{at_most(square(r) + 2 * r + 1, square(q)), at_most(square(r + 1), square(q + 1))},
                     less(r + 1, q)};
      });
}

Term is_vertex(const VertexOf<Counted>& at, const Counted& N) {
  return both({at_most(0, at.i), at_most(0, at.j), at_most(at.i + at.j, N)});
}
Term same_vertex(const VertexOf<Counted>& a, const VertexOf<Counted>& b) {
  return both({same(a.i, b.i), same(a.j, b.j)});
}
VertexOf<Counted> declare_vertex(Script& script, const Counted& N) {
  const VertexOf<Counted> at{whole(script, "i"), whole(script, "j")};
  script.require(is_vertex(at, N));
  return at;
}

Term is_face(const FaceOf<Counted>& t, const Counted& N) {
  return both({at_most(0, t.iu), at_most(0, t.iv), within(0, t.upper, 2), less(t.iu + t.iv + t.upper, N)});
}
Term same_face(const FaceOf<Counted>& a, const FaceOf<Counted>& b) {
  return both({same(a.iu, b.iu), same(a.iv, b.iv), same(a.upper, b.upper)});
}
FaceOf<Counted> declare_face(Script& script, const Counted& N) {
  const FaceOf<Counted> t{whole(script, "iu"), whole(script, "iv"), whole(script, "upper")};
  script.require(is_face(t, N));
  return t;
}

namespace {

/// Declares r, a root of x: T(r) <= x < T(r+1), r >= 0; supposes what compares it with another row.
Counted declare_triangular_root(Script& script, const Counted& x, const Counted& other_row) {
  script.comment("The root of it, by triangular_root.");
  const Counted r = whole(script, "r");
  script.require(at_most(0, r));
  script.require(both({at_most(triangular(r), x), less(x, triangular(r + 1))}));
  suppose_step(script, r);
  suppose_ordered(script, r, other_row);
  suppose_ordered(script, other_row, r);
  return r;
}
Counted declare_square_root(Script& script, const Counted& x, const Counted& other_row) {
  script.comment("The root of it, by square_root.");
  const Counted r = whole(script, "r");
  script.require(at_most(0, r));
  script.require(both({at_most(square(r), x), less(x, square(r + 1))}));
  suppose_square_step(script, r);
  suppose_square_ordered(script, r, other_row);
  suppose_square_ordered(script, other_row, r);
  return r;
}

/// U-major of a vertex is W-minor of the vertex turned, from the last one: what u_major_reversed proves, supposed.
void suppose_reversed(Script& script, const Counted& x, const VertexOf<Counted>& at, const Counted& N) {
  script.comment("u_major_reversed.");
  script.require(implies(is_vertex(at, N), same(x, specified::vertices_of_side(N) - 1 -
                                                       (triangular(N - at.i) + (N - at.i - at.j)))));
}
/// U-major of a face is its row index turned, from the last one: what u_major_faces_reversed proves, supposed.
void suppose_faces_reversed(Script& script, const Counted& x, const FaceOf<Counted>& t, const Counted& N) {
  script.comment("u_major_faces_reversed.");
  const Counted row = N - 1 - t.iu;
  script.require(
      implies(is_face(t, N), same(x, square(N) - 1 - (square(row) + 2 * (row - t.iv - t.upper) + t.upper))));
}

void add_u_major_places(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "u_major_back",
      "U-major: from a vertex to its index, which is below T(N+1), and back is that vertex.",
      [&](Script& script) {
        suppose_triangular(script);
        const Counted N = whole(script, "N");
        const auto at = declare_vertex(script, N);
        const Counted x = index_outcome(script, "x", [&] { return by.u_major(at.i, at.j, N); });
        suppose_reversed(script, x, at, N);
        const Counted y = named(script, "y", specified::vertices_of_side(N) - 1 - x);
        const Counted r = declare_triangular_root(script, y, N - at.i);
        suppose_ordered(script, N - at.i, N + 1);
        suppose_ordered(script, 0, N - at.i);
        const auto back = vertex_outcome(script, "back", [&] { return by.u_major_in_row(y, r, N); });
        return Lemma{{within(0, x, specified::vertices_of_side(N)), same_vertex(back, at)},
                     both({less(0, at.i), less(0, at.j), less(at.i + at.j, N)})};
      });
  add(all, "u_major_onto",
      "U-major: every x in [0, T(N+1)) is the index of the vertex that the way back gives.",
      [&](Script& script) {
        suppose_triangular(script);
        const Counted x = whole(script, "x"), N = whole(script, "N");
        script.require(at_most(0, N));
        script.require(within(0, x, specified::vertices_of_side(N)));
        const Counted y = named(script, "y", specified::vertices_of_side(N) - 1 - x);
        const Counted r = declare_triangular_root(script, y, N + 1);
        const auto at = vertex_outcome(script, "at", [&] { return by.u_major_in_row(y, r, N); });
        const Counted index = index_outcome(script, "index", [&] { return by.u_major(at.i, at.j, N); });
        suppose_reversed(script, index, at, N);
        return Lemma{{is_vertex(at, N), same(index, x)},
                     both({less(0, at.i), less(0, at.j), less(at.i + at.j, N)})};
      });
}

Counted row_of(const Parts<Counted>& by, Script& script, const char* name, const FaceOf<Counted>& t) {
  return index_outcome(script, name, [&] { return by.rows(t.iu, t.iv, is_upper(t)); });
}

Counted strip_of(const Parts<Counted>& by, Script& script, const char* name, const FaceOf<Counted>& t,
                 const Counted& N) {
  return index_outcome(script, name, [&] { return by.u_major_face(t.iu, t.iv, is_upper(t), N); });
}

void add_rows(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "rows_back", "Faces in rows: from a face to its index and back is that face, whatever N is.",
      [&](Script& script) {
        suppose_square(script);
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        const Counted x = row_of(by, script, "x", t);
        const Counted r = declare_square_root(script, x, t.iu + t.iv + t.upper);
        const auto back = face_outcome(script, "back", [&] { return by.row_face(x, r); });
        return Lemma{{same_face(back, t)}, both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
  add(all, "rows_onto",
      "Faces in rows: every x >= 0 is the index of the face that the way back gives; and x < S(N) says the "
      "same as that it is a face with N to a side, for every N.",
      [&](Script& script) {
        suppose_square(script);
        const Counted x = whole(script, "x"), N = whole(script, "N");
        script.require(both({at_most(0, x), at_most(1, N)}));
        const Counted r = declare_square_root(script, x, N);
        const auto t = face_outcome(script, "t", [&] { return by.row_face(x, r); });
        const Counted index = row_of(by, script, "index", t);
        return Lemma{{within(0, t.upper, 2), at_most(0, t.iu), at_most(0, t.iv), same(index, x),
                      equal(less(x, square(N)), is_face(t, N))},
                     both({less(0, t.iu), less(0, t.iv), same(t.upper, 1), less(2, N)})};
      });
}

void add_strips(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "u_major_faces_reversed",
      "Faces in U-major: 2N iu - iu iu + 2 iv + upper = N N - 1 - the row index of the face turned, (iv, "
      "N-1-iu-iv-upper): the rows from the u-corner, backwards.",
      [&](Script& script) {
        suppose_square(script);
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        const Counted x = strip_of(by, script, "x", t, N);
        const Counted row = named(script, "row", N - 1 - t.iu);
        for (const Counted& r : {t.iu, row, N}) suppose_square_product(script, r);
        const Counted turned_iv = named(script, "turned_iv", row - t.iv - t.upper);
        const Counted turned = index_outcome(
            script, "turned", [&] { return specified::row_index<Counted>(t.iv, turned_iv, is_upper(t)); });
        return Lemma{{same(x, square(N) - 1 - turned)},
                     both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
  add(all, "u_major_faces_back",
      "Faces in U-major: from a face to its index, which is below N N, and back is that face.",
      [&](Script& script) {
        suppose_square(script);
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        const Counted x = strip_of(by, script, "x", t, N);
        suppose_faces_reversed(script, x, t, N);
        const Counted y = named(script, "y", square(N) - 1 - x);
        const Counted r = declare_square_root(script, y, N - 1 - t.iu);
        suppose_square_ordered(script, N - 1 - t.iu, N);
        suppose_square_ordered(script, 0, N - 1 - t.iu);
        const auto back = face_outcome(script, "back", [&] { return by.u_major_face_in_strip(x, r, N); });
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
        const auto t = face_outcome(script, "t", [&] { return by.u_major_face_in_strip(x, r, N); });
        const Counted index = strip_of(by, script, "index", t, N);
        for (const Counted& s : {N - 1 - r, r, N}) suppose_square_product(script, s);
        return Lemma{{is_face(t, N), same(index, x)}, both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
}

}  // namespace

// ---- Roots

void add_triangular_root(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "triangular_root",
      "The loop of triangular_root: it begins with r = 0 and a bit b with x < T(2b); a turn keeps T(r) <= x "
      "< T(r + 2b), with half the bit, and after the turn with b = 1 it is T(r) <= x < T(r + 1).",
      [&](Script& script) {
        suppose_triangular(script);
        const Counted x = whole(script, "x"), r = whole(script, "r"), b = whole(script, "b");
        script.require(both({at_most(0, r), at_most(1, b), at_most(0, x)}));
        script.require(both({at_most(triangular(r), x), less(x, triangular(r + 2 * b))}));
        const Counted next = index_outcome(script, "next", [&] { return by.triangular_root_turn(x, r, b); });
        return Lemma{{at_most(r, next), at_most(triangular(next), x), less(x, triangular(next + b)),
                      at_most(triangular(Counted(0)), x)},
                     both({less(1, r), less(1, b)})};
      });
}

void add_square_root(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "square_root",
      "The loop of w_minor_row: it begins with r = 0 and a bit b with x < S(2b); a turn keeps S(r) <= x < "
      "S(r + 2b), with half the bit, and after the turn with b = 1 it is S(r) <= x < S(r + 1).",
      [&](Script& script) {
        suppose_square(script);
        const Counted x = whole(script, "x"), r = whole(script, "r"), b = whole(script, "b");
        script.require(both({at_most(0, r), at_most(1, b), at_most(0, x)}));
        script.require(both({at_most(square(r), x), less(x, square(r + 2 * b))}));
        const Counted next = index_outcome(script, "next", [&] { return by.square_root_turn(x, r, b); });
        return Lemma{{at_most(r, next), at_most(square(next), x), less(x, square(next + b)),
                      at_most(square(Counted(0)), x)},
                     both({less(1, r), less(1, b)})};
      });
}

// ---- W-minor

void add_w_minor(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "w_minor_back", "W-minor: from a vertex to its index and back is that vertex, whatever N is.",
      [&](Script& script) {
        suppose_triangular(script);
        const VertexOf<Counted> at{whole(script, "i"), whole(script, "j")};
        script.require(both({at_most(0, at.i), at_most(0, at.j)}));
        const Counted x = index_outcome(script, "x", [&] { return by.w_minor(at.i, at.j); });
        const Counted r = declare_triangular_root(script, x, at.i + at.j);
        const auto back = vertex_outcome(script, "back", [&] { return by.w_minor_in_row(x, r); });
        return Lemma{{same_vertex(back, at)}, both({less(0, at.i), less(at.i, at.j)})};
      });
  add(all, "w_minor_onto",
      "W-minor: every x >= 0 is the index of the vertex that the way back gives; and x < T(N+1) says the "
      "same as i+j <= N, for every N: the indices below T(N+1) are those of N micro-triangles to a side, and "
      "a finer level begins with them, number by number.",
      [&](Script& script) {
        suppose_triangular(script);
        const Counted x = whole(script, "x"), N = whole(script, "N");
        script.require(both({at_most(0, x), at_most(0, N)}));
        const Counted r = declare_triangular_root(script, x, N + 1);
        const auto at = vertex_outcome(script, "at", [&] { return by.w_minor_in_row(x, r); });
        const Counted index = index_outcome(script, "index", [&] { return by.w_minor(at.i, at.j); });
        return Lemma{{at_most(0, at.i), at_most(0, at.j), same(index, x),
                      equal(less(x, specified::vertices_of_side(N)), at_most(at.i + at.j, N))},
                     both({less(0, at.i), less(0, at.j), less(2, N)})};
      });
  add(all, "w_minor_moves",
      "W-minor: a vertex (i, j) is (2i, 2j) a level on, and its index there is greater, but for the "
      "w-corner's, which is 0 on both.",
      [&](Script& script) {
        suppose_triangular(script);
        const VertexOf<Counted> at{whole(script, "i"), whole(script, "j")};
        script.require(both({at_most(0, at.i), at_most(0, at.j)}));
        for (const Counted& r : {at.i + at.j, 2 * at.i + 2 * at.j}) {
          suppose_twice(script, r);
          suppose_ordered(script, 0, r);
        }
        suppose_ordered(script, at.i + at.j, 2 * at.i + 2 * at.j);
        const auto index = [&](const char* name, const Counted& i, const Counted& j) {
          return index_outcome(script, name, [&] { return by.w_minor(i, j); });
        };
        const Counted here = index("here", at.i, at.j), next = index("next", 2 * at.i, 2 * at.j);
        const Term corner = both({same(at.i, 0), same(at.j, 0)});
        return Lemma{
            {implies(no(corner), less(here, next)), implies(corner, both({same(here, 0), same(next, 0)}))},
            both({same(at.i, 1), same(at.j, 2)})};
      });
}

// ---- U-major

void add_u_major(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "u_major_reversed",
      "U-major(i, j) = T(N+1) - 1 - W-minor(j, N-i-j): the rows from the u-corner, backwards.",
      [&](Script& script) {
        suppose_triangular(script);
        const Counted N = whole(script, "N");
        const auto at = declare_vertex(script, N);
        for (const Counted& r : {at.i, N - at.i, N + 1}) suppose_twice(script, r);
        const Counted x = index_outcome(script, "x", [&] { return by.u_major(at.i, at.j, N); });
        const Counted turned = index_outcome(
            script, "turned", [&] { return specified::w_minor_index<Counted>(at.j, N - at.i - at.j); });
        return Lemma{{same(x, specified::vertices_of_side(N) - 1 - turned)},
                     both({less(0, at.i), less(at.i, at.j), less(at.i + at.j, N)})};
      });
  add_u_major_places(all, by);
  add(all, "u_major_moves",
      "U-major: a vertex's index is greater a level on, but for the w-corner's, which is 0 on both.",
      [&](Script& script) {
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
          return index_outcome(script, name, [&] { return by.u_major(i, j, side); });
        };
        const Counted here = index("here", at.i, at.j, N), next = index("next", 2 * at.i, 2 * at.j, 2 * N);
        const Term corner = both({same(at.i, 0), same(at.j, 0)});
        return Lemma{
            {implies(no(corner), less(here, next)), implies(corner, both({same(here, 0), same(next, 0)}))},
            both({less(0, at.i), less(0, at.j), less(at.i + at.j, N)})};
      });
}

// ---- Faces in rows and in strips

void add_faces(std::vector<Statement>& all, const Parts<Counted>& by) {
  add_rows(all, by);
  add_strips(all, by);
  add(all, "corners",
      "A face's corners are vertices of its level, wind like the base triangle, (x1-x0)(y2-y0) - "
      "(x2-x0)(y1-y0) = 1, and the first two tell the face.",
      [&](Script& script) {
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        std::vector<VertexOf<Counted>> c;
        for (std::size_t k = 0; k < 3; ++k)
          c.push_back(vertex_outcome(script, "c" + std::to_string(k),
                                     [&] { return by.corners(t.iu, t.iv, is_upper(t))[k]; }));
        const auto back = face_outcome(script, "back", [&] { return by.face_of_corners(c[0], c[1]); });
        const Counted winding = (c[1].i - c[0].i) * (c[2].j - c[0].j) - (c[2].i - c[0].i) * (c[1].j - c[0].j);
        return Lemma{{is_vertex(c[0], N), is_vertex(c[1], N), is_vertex(c[2], N), same(winding, 1),
                      same_face(back, t)},
                     both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
}

}  // namespace mmverify::proofs::attribute::induction
