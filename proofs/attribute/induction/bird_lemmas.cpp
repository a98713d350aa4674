#include "proofs/attribute/induction/lemmas.hpp"

namespace mmverify::proofs::attribute::induction {

using namespace proofs::induction;

// ---- Upright micro-triangles along the curve

namespace {

/// T at the numbers that counts with m and 2m to a side need.
void suppose_counts(Script& script, const Counted& m) {
  for (const Counted& r : {m, m - 1, 2 * m, 2 * m - 1}) suppose_twice(script, r);
  script.comment("A product of two numbers that are not negative.");
  script.require(at_most(0, (m - 1) * m));
}

/// Upright ones in a triangle with S to a side.
Counted upright_count(const Counted& S, const Term& upright) {
  return Counted(
      choose(upright, specified::upright_within(S, true).term, specified::upright_within(S, false).term));
}

/// One digit d with a child of m to a side, from a triangle that stands upright or not: what upright_turn adds to the
/// excess, and how the child stands.
struct TurnTaken {
  Counted excess;
  Term upright;
};
TurnTaken turn_taken(const Parts<Counted>& by, Script& script, const Counted& d, const Counted& m,
                     const Term& upright) {
  const Counted before(script.declare("excess", integer));
  const auto turn = [&](std::uint64_t digit) {
    return every_path([&] {
      return by.upright_turn(UprightExcess<Counted>{before, decided(upright)}, digit, m);
    });
  };
  std::vector<Counted> added;
  std::vector<Term> stands;
  for (std::uint64_t digit = 0; digit < 4; ++digit) {
    const auto paths = turn(digit);
    added.push_back(Counted(as_formula(paths, [](const auto& u) { return u.excess.term; })));
    stands.push_back(as_formula(paths, [](const auto& u) { return truth(u.upright); }));
  }
  const Counted after = named(script, "excess_after", by_digit(d, {added[0], added[1], added[2], added[3]}));
  const Term next = script.define(
      "next_upright",
      choose(same(d, 0), stands[0], choose(same(d, 1), stands[1], choose(same(d, 2), stands[2], stands[3]))));
  return {named(script, "added", after - before), next};
}

/// The child that holds upright micro-triangle k, and its number there.
struct ChildFound {
  Counted digit, number;
};
ChildFound child_found(const Parts<Counted>& by, Script& script, const std::string& prefix, const Counted& k,
                       const Counted& m, const Term& upright) {
  struct ChildStep {
    std::uint64_t digit;
    Counted number;
  };
  const auto paths = every_path([&] {
    Counted left = k;
    const std::uint64_t digit = by.upright_child(left, m, decided(upright));
    return ChildStep{digit, left};
  });
  return {Counted(script.define(
              prefix + "_digit",
              as_formula(paths,
                         [](const ChildStep& f) { return whole_number(static_cast<long long>(f.digit)); }))),
          Counted(script.define(prefix + "_number",
                                as_formula(paths, [](const ChildStep& f) { return f.number.term; })))};
}

void add_upright_digit(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "upright_step",
      "Upright ones before a number on the curve, one digit. In a triangle with 2m to a side the number x = "
      "d m m + x' is in child d, where it is the upright one k', that is x' + excess' = 2k'. Then x + excess "
      "= 2k for a k below upright_within(2m), and upright_child finds d and k' from k.",
      [&](Script& script) {
        suppose_triangular(script);
        const Counted m = whole(script, "m"), d = whole(script, "d"), inside = whole(script, "number_inside"),
                      excess_inside = whole(script, "excess_inside"), k_inside = whole(script, "k_inside");
        const Term upright = script.declare("upright", boolean);
        script.require(both({at_most(1, m), within(0, d, 4)}));
        suppose_counts(script, m);
        const TurnTaken turn = turn_taken(by, script, d, m, upright);
        script.require(within(0, k_inside, upright_count(m, turn.upright)));
        script.require(same(inside + excess_inside, 2 * k_inside));
        const Counted squares = by_digit(d, {Counted(0), m * m, 2 * (m * m), 3 * (m * m)});
        const Counted twice = named(script, "twice_k", squares + inside + turn.excess + excess_inside);
        const Counted k = named(script, "k", twice / 2);
        const ChildFound found = child_found(by, script, "found", k, m, upright);
        return Lemma{{same(twice, 2 * k), within(0, k, upright_count(2 * m, upright)), same(found.digit, d),
                      same(found.number, k_inside)},
                     both({less(1, m), same(d, 3), no(upright), less(0, k_inside)})};
      });
  add(all, "upright_onto",
      "The way back, one digit: for every k below upright_within(2m), upright_child gives a digit d and a k' "
      "below d's upright_within(m), and x' + excess' = 2k' makes x + excess = 2k.",
      [&](Script& script) {
        suppose_triangular(script);
        const Counted m = whole(script, "m"), k = whole(script, "k"), inside = whole(script, "number_inside"),
                      excess_inside = whole(script, "excess_inside");
        const Term upright = script.declare("upright", boolean);
        script.require(at_most(1, m));
        suppose_counts(script, m);
        script.require(within(0, k, upright_count(2 * m, upright)));
        const ChildFound found = child_found(by, script, "found", k, m, upright);
        const TurnTaken turn = turn_taken(by, script, found.digit, m, upright);
        script.require(same(inside + excess_inside, 2 * found.number));
        const Counted squares = by_digit(found.digit, {Counted(0), m * m, 2 * (m * m), 3 * (m * m)});
        return Lemma{{within(0, found.digit, 4), within(0, found.number, upright_count(m, turn.upright)),
                      same(squares + inside + turn.excess + excess_inside, 2 * k)},
                     both({less(1, m), same(found.digit, 2), less(0, found.number)})};
      });
}

Counted corner_of(const Parts<Counted>& by, Script& script, const char* name, const VertexOf<Counted>& at,
                  const Counted& N) {
  return outcome(
      script, name, [&] { return by.bird_corner(at.i, at.j, N); },
      [](std::uint64_t corner) { return Counted(static_cast<long long>(corner)); });
}

/// Whether a vertex is halved, and what the halving leaves.
struct Halving {
  Term was;
  VertexOf<Counted> half;
};
Halving halving(const Parts<Counted>& by, Script& script, const std::string& prefix,
                const VertexOf<Counted>& at) {
  struct Halved {
    bool was;
    VertexOf<Counted> at;
  };

  const auto program = [&by, at] {
    VertexOf<Counted> half = at;
    const bool was = by.halved(half);
    return Halved{was, half};
  };
  const auto paths = proofs::induction::every_path(program);
  const Term was = script.define(
      prefix, proofs::induction::as_formula(paths, [](const Halved& h) { return truth(h.was); }));
  const auto half = vertex_outcome(script, prefix + "_at", [&] { return program().at; });
  return {was, half};
}

void add_bird_corners(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "bird_corners",
      "With one micro-triangle to a side every vertex is a corner, and the corners' indices are 0, 1 and 2: "
      "all below T(2) = 3.",
      [&](Script& script) {
        suppose_triangular(script);
        suppose_twice(script, 2);
        const auto at = declare_vertex(script, 1);
        const Counted x = corner_of(by, script, "x", at, 1);
        return Lemma{{less(x, specified::vertices_of_side(Counted(1))),
                      same(specified::vertices_of_side(Counted(1)), 3),
                      equal(same(x, 0), both({same(at.i, 0), same(at.j, 0)})),
                      equal(same(x, 1), same(at.i, 1)), equal(same(x, 2), same(at.j, 1))},
                     same(at.j, 1)};
      });
  add(all, "bird_prefix",
      "A vertex (i, j) with N to a side is (2i, 2j) with 2N: as a corner it has the same index, and else one "
      "halving leads to (i, j), so that both have the index of the level that is found from there.",
      [&](Script& script) {
        const Counted N = whole(script, "N");
        script.require(at_most(1, N));
        const auto at = declare_vertex(script, N);
        const VertexOf<Counted> twice{2 * at.i, 2 * at.j};
        const Counted here = corner_of(by, script, "here", at, N),
                      next = corner_of(by, script, "next", twice, 2 * N);
        const auto [was, half] = halving(by, script, "halved", twice);
        return Lemma{{same(here, next), was, same_vertex(half, at)}, both({less(0, at.i), less(at.i, at.j)})};
      });
  add(all, "bird_halves",
      "What a halving leaves is a vertex of the level before, and the vertex is twice that.  A corner of 2N "
      "to a side is halved, too: what is not halved is no corner.",
      [&](Script& script) {
        const Counted N = whole(script, "N");
        script.require(at_most(1, N));
        const auto at = declare_vertex(script, 2 * N);
        const auto [was, half] = halving(by, script, "halved", at);
        const Counted corner = corner_of(by, script, "corner", at, 2 * N);
        return Lemma{{implies(was, both({is_vertex(half, N), same_vertex(at, {2 * half.i, 2 * half.j})})),
                      implies(less(corner, 3), was)},
                     both({was, less(0, at.i), less(0, at.j)})};
      });
}

using Middle = EdgeMiddle<Counted>;

Middle middle_outcome(const Parts<Counted>& by, Script& script, const std::string& prefix,
                      const VertexOf<Counted>& at) {
  const auto program = [&] { return by.edge_middle(at); };
  return Middle{outcome(script, prefix + "_iu", program, [](const Middle& m) { return m.iu; }),
                outcome(script, prefix + "_iv", program, [](const Middle& m) { return m.iv; }),
                outcome(script, prefix + "_edge", program, [](const Middle& m) { return m.edge; })};
}

Term is_middle(const Middle& m, const Counted& M) {
  return both({at_most(0, m.iu), at_most(0, m.iv), less(m.iu + m.iv, M), within(0, m.edge, 3)});
}

void add_bird_middles(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "bird_middle",
      "A vertex with 2M to a side that is not halved is the middle of one edge of one upright micro-triangle "
      "with M to a side, and the way back leads to it.",
      [&](Script& script) {
        const Counted M = whole(script, "M");
        script.require(at_most(1, M));
        const auto at = declare_vertex(script, 2 * M);
        const auto [was, half] = halving(by, script, "halved", at);
        script.require(no(was));
        const Middle m = middle_outcome(by, script, "on", at);
        const auto back = vertex_outcome(script, "back", [&] { return by.in_the_middle(m); });
        return Lemma{{is_middle(m, M), same_vertex(back, at)}, both({less(0, at.i), less(at.i, at.j)})};
      });
  add(all, "bird_middle_onto",
      "The middle of each of the three edges of each upright micro-triangle is a vertex with 2M to a side "
      "that is not halved, and no other edge's.",
      [&](Script& script) {
        const Counted M = whole(script, "M");
        script.require(at_most(1, M));
        const Middle m{whole(script, "iu"), whole(script, "iv"), whole(script, "edge")};
        script.require(is_middle(m, M));
        const auto at = vertex_outcome(script, "at", [&] { return by.in_the_middle(m); });
        const auto [was, half] = halving(by, script, "halved", at);
        const Middle back = middle_outcome(by, script, "back", at);
        return Lemma{{is_vertex(at, 2 * M), no(was), same(back.iu, m.iu), same(back.iv, m.iv),
                      same(back.edge, m.edge)},
                     both({less(0, m.iu), less(m.iu, m.iv), same(m.edge, 2)})};
      });
}

Counted bird_number(const Parts<Counted>& by, Script& script, const Counted& before, const Counted& edge,
                    const Counted& M) {
  return index_outcome(script, "x", [&] { return by.bird_number(before, edge, M); });
}

void suppose_vertices(Script& script, const Counted& M) {
  suppose_triangular(script);
  for (const Counted& r : {M, M + 1, 2 * M + 1}) suppose_twice(script, r);
}

void add_bird_numbers(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "bird_number",
      "T(2M+1) - T(M+1) = 3 T(M): doubling the side adds three vertices for each upright micro-triangle.  "
      "The index of edge e of upright one `before` of T(M) lies in [T(M+1), T(2M+1)), and the way back gives "
      "both.",
      [&](Script& script) {
        const Counted M = whole(script, "M"), before = whole(script, "before"), edge = whole(script, "edge");
        suppose_vertices(script, M);
        script.require(both({at_most(1, M), within(0, before, triangular(M)), within(0, edge, 3)}));
        const Counted x = bird_number(by, script, before, edge, M);
        const auto place = specified::bird_place(x, M);
        const Counted low = specified::vertices_of_side(M), high = specified::vertices_of_side(2 * M);
        return Lemma{{same(high - low, 3 * triangular(M)), within(low, x, high),
                      same(named(script, "back_before", place.before), before),
                      same(named(script, "back_edge", place.edge), edge)},
                     both({less(1, M), less(0, before), same(edge, 2)})};
      });
  add(all, "bird_number_onto",
      "Every x in [T(M+1), T(2M+1)) is the index of the edge that the way back gives.", [&](Script& script) {
        const Counted M = whole(script, "M"), wanted = whole(script, "wanted");
        suppose_vertices(script, M);
        script.require(at_most(1, M));
        script.require(within(specified::vertices_of_side(M), wanted, specified::vertices_of_side(2 * M)));
        const auto place = specified::bird_place(wanted, M);
        const Counted before = named(script, "before", place.before),
                      edge = named(script, "edge", place.edge);
        const Counted x = bird_number(by, script, before, edge, M);
        return Lemma{{within(0, before, triangular(M)), within(0, edge, 3), same(x, wanted)},
                     both({less(1, M), less(0, before), same(edge, 2)})};
      });
}

}  // namespace

void add_upright(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "upright_base",
      "Of a triangle of one micro-triangle: upright_within is 1 if it stands upright and 0 if it does not.",
      [&](Script& script) {
        suppose_triangular(script);
        suppose_step(script, 0);
        return Lemma{{same(upright_count(1, truth(true)), 1), same(upright_count(1, truth(false)), 0)},
                     truth(true)};
      });
  add_upright_digit(all, by);
  add(all, "upright_ordered",
      "Of two upright ones the one with the smaller k comes first on the curve: it has the smaller digit, or "
      "the same digit and the smaller number there.",
      [&](Script& script) {
        suppose_triangular(script);
        const Counted m = whole(script, "m"), k = whole(script, "k"), later = whole(script, "later");
        const Term upright = script.declare("upright", boolean);
        script.require(at_most(1, m));
        suppose_counts(script, m);
        script.require(both({at_most(0, k), less(k, later), less(later, upright_count(2 * m, upright))}));
        const ChildFound a = child_found(by, script, "first", k, m, upright);
        const ChildFound b = child_found(by, script, "second", later, m, upright);
        return Lemma{{at_most(a.digit, b.digit), implies(same(a.digit, b.digit), less(a.number, b.number))},
                     both({less(1, m), less(a.digit, b.digit)})};
      });
}

// ---- Bird

void add_bird(std::vector<Statement>& all, const Parts<Counted>& by) {
  add_bird_corners(all, by);
  add_bird_middles(all, by);
  add_bird_numbers(all, by);
}

}  // namespace mmverify::proofs::attribute::induction
