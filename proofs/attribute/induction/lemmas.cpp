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
      "spec::attribute::triangular(r) is h and "
      "triangular(r+1) is h+r+1, which is half of (r+1)(r+2). So for every r >= 0, 2 T(r) = r(r+1) and "
      "T(r+1) = T(r) + "
      "r + 1.",
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

void suppose_reversed(Script& script, const Counted& x, const VertexOf<Counted>& at, const Counted& N) {
  script.comment("u_major_reversed.");
  script.require(implies(is_vertex(at, N), same(x, specified::vertices_of_side(N) - 1 -
                                                       (triangular(N - at.i) + (N - at.i - at.j)))));
}
void suppose_faces_reversed(Script& script, const Counted& x, const FaceOf<Counted>& t, const Counted& N) {
  script.comment("u_major_faces_reversed.");
  const Counted row = N - 1 - t.iu;
  script.require(
      implies(is_face(t, N), same(x, square(N) - 1 - (square(row) + 2 * (row - t.iv - t.upper) + t.upper))));
}

}  // namespace mmverify::proofs::attribute::induction
