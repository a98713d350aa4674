#include "proofs/tree/induction/lemmas.hpp"

namespace mmverify::proofs::tree::induction {

using namespace proofs::induction;

namespace {

/// Children are the parts of a node; a leaf is the same in all of its parts.
constexpr char parts[] = R"(
; The tree of a quarter: a node's child; a leaf means the same state in each.
(define-fun part0 ((T Tree)) Tree (ite ((_ is leaf) T) T (child0 T)))
(define-fun part1 ((T Tree)) Tree (ite ((_ is leaf) T) T (child1 T)))
(define-fun part2 ((T Tree)) Tree (ite ((_ is leaf) T) T (child2 T)))
(define-fun part3 ((T Tree)) Tree (ite ((_ is leaf) T) T (child3 T)))
)";

Term part(const Term& tree, std::size_t k) { return apply("part" + std::to_string(k), {tree}, tree_sort); }

Term said(const char* predicate, std::vector<Term> of) { return apply(predicate, std::move(of), boolean); }

Term less_or_equal(const Term& a, const Term& b) { return said("<=", {a, b}); }

std::string pair_of(Shape a, Shape b) { return std::string(name(a)) + "_" + name(b); }

}  // namespace

void add(std::vector<Statement>& all, const std::string& name, const std::string& says, const Writer& write) {
  Script script(name, Answer::unsat, says);
  define_trees(script);
  Lemma lemma = write(script);
  script.comment("Denied:");
  all.push_back(script.denying(std::move(lemma.claims)));

  Script witness("witness_" + name, Answer::sat,
                 "Not vacuous: some case fulfils what " + name + " supposes.");
  define_trees(witness);
  witness.require(write(witness).occasion);
  all.push_back(witness.finish());
}

const char* name(Shape shape) { return shape == Shape::leaf ? "leaf" : "node"; }

Grown grow(Script& script, Shape shape, char letter, const char* tree) {
  script.comment(std::string("The tree ") + tree + ".");
  if (shape == Shape::leaf) {
    const char small = static_cast<char>(letter - 'A' + 'a');
    return {script.define(tree, leaf(script.declare(std::string(1, small), state_sort))), {}};
  }
  std::vector<Term> children;
  for (unsigned k = 0; k < 4; ++k)
    children.push_back(script.declare(std::string(1, letter) + std::to_string(k), tree_sort));
  return {script.define(tree, node(children)), children};
}

std::vector<std::pair<Term, Term>> places(Script& script, const std::vector<Term>& children, const Term& t,
                                          const Term& d) {
  std::vector<std::pair<Term, Term>> all;
  for (std::size_t k = 0; k < children.size(); ++k) {
    const Term bit = k == 0 ? t : plus(all.back().first, nodes(children[k - 1])),
               datum = k == 0 ? d : plus(all.back().second, leaves(children[k - 1]));
    const std::string number = std::to_string(k);
    const Term named = script.define("t" + number, bit);
    all.emplace_back(named, script.define("d" + number, datum));
  }
  return all;
}

Term counted(const Term& tree) { return said("counted", {tree}); }
Term placed(const Term& tree, const Term& t, const Term& d) { return said("placed", {tree, t, d}); }
Term meant(const Term& tree, const Term& path) { return said("meant", {tree, path}); }
Term passes(const Term& tree, const Term& c, const Term& t, const Term& d) {
  return said("passes", {tree, c, t, d});
}
Term finds(const Term& tree, const Term& t, const Term& d, const Term& path) {
  return said("finds", {tree, t, d, path});
}
Term written(const Term& tree, const Term& stack, const Term& t, const Term& d) {
  return said("written", {tree, stack, t, d});
}
Term reached(const Term& stack, const Term& t, const Term& d) { return said("reached", {stack, t, d}); }
Term settled(const Term& tree) { return said("settled", {tree}); }
Term settles(const Term& tree) { return said("settles", {tree}); }

void define_passes(Script& script) {
  define_counts(script);
  define_sequences(script);
  script.raw(R"(
; Where bitscan(child, t, d) ends.
(declare-datatypes ((Place 0)) (((place (bit Int) (datum Int)))))
(declare-fun bitscan (Int Int Int) Place)
; The induction's statement: bitscan passes over T, which stands at (t, d), as over one of c subtrees.
(define-fun passes ((T Tree) (c Int) (t Int) (d Int)) Bool
  (=> (and (<= 1 c) (stands T t d))
      (= (bitscan c t d) (bitscan (- c 1) (+ t (nodes T)) (+ d (leaves T))))))
)");
}

void define_finds(Script& script) {
  define_maps(script);
  script.raw(R"(
; What tree-lookup returns from (t, d) on, its digits being those of p.
(declare-fun lookup (Int Int Path) State)
; The induction's statement: from where T stands, tree-lookup finds the state that T means.
(define-fun finds ((T Tree) (t Int) (d Int) (p Path)) Bool
  (=> (stands T t d) (= (lookup t d p) (state_at T p))))
)");
}

void define_written(Script& script) {
  define_counts(script);
  define_sequences(script);
  script.raw(R"(
; Algorithm 2's stack, its top first.
(declare-datatypes ((Stack 0)) (((bottom) (stacked (top Tree) (below Stack)))))
; Algorithm 2 comes to have this stack, with t bits and d values appended.
(declare-fun reached (Stack Int Int) Bool)
; The induction's statement: once T is on top of S, its encoding is appended, and S is left.
(define-fun written ((T Tree) (S Stack) (t Int) (d Int)) Bool
  (=> (reached (stacked T S) t d)
      (and (stands T t d) (reached S (+ t (nodes T)) (+ d (leaves T))))))
)");
}

void define_settled(Script& script) {
  script.raw(R"(
; No four siblings in T are leaves of one state.
(declare-fun settled (Tree) Bool)
(define-fun settles ((T Tree)) Bool
  (= (settled T)
     (or ((_ is leaf) T)
         (and (settled (child0 T)) (settled (child1 T)) (settled (child2 T)) (settled (child3 T))
              (not (and ((_ is leaf) (child0 T)) ((_ is leaf) (child1 T))
                        ((_ is leaf) (child2 T)) ((_ is leaf) (child3 T))
                        (= (value (child0 T)) (value (child1 T)))
                        (= (value (child0 T)) (value (child2 T)))
                        (= (value (child0 T)) (value (child3 T)))))))))
)");
}

void add_quarters(std::vector<Statement>& all) {
  add(all, "same_in_quarters",
      "Trees that give a path the same state do so in the quarter that its first digit names: so those that "
      "mean the same map do in each quarter.",
      [](Script& script) -> Lemma {
        define_maps(script);
        script.raw(parts);
        const Term T = script.declare("T", tree_sort), S = script.declare("S", tree_sort),
                   p = script.declare("p", path_sort);
        for (const Term& path : {p, rest(p)})
          for (const Term& tree : {T, S}) script.require(meant(tree, path));
        const Term same = equal(state_at(T, p), state_at(S, p));
        std::vector<Term> claims;
        for (unsigned k = 0; k < 4; ++k)
          claims.push_back(implies(both({equal(first(p), whole_number(k)), same}),
                                   equal(state_at(part(T, k), rest(p)), state_at(part(S, k), rest(p)))));
        return {same, claims};
      });
}

void add_canonical(std::vector<Statement>& all) {
  for (const Shape left : shapes)
    for (const Shape right : shapes)
      add(all, "canonical_" + pair_of(left, right),
          std::string("A ") + name(left) + " and a " + name(right) +
              ", neither with four siblings that are leaves of one state, that mean the same map are the "
              "same tree.",
          [&](Script& script) -> Lemma {
            define_maps(script);
            define_settled(script);
            script.raw(parts);
            script.raw(R"(
; T and S mean the same map: state_at is the same on every path.
(declare-fun same (Tree Tree) Bool)
; The induction's statement.
(define-fun alike ((T Tree) (S Tree)) Bool
  (=> (and (settled T) (settled S) (same T S)) (= T S)))
)");
            const auto same = [](const Term& a, const Term& b) { return said("same", {a, b}); };
            const Term T = grow(script, left, 'A', "T").tree, S = grow(script, right, 'B', "S").tree;
            script.require(settles(T));
            script.require(settles(S));
            if (left == Shape::leaf && right == Shape::leaf) {
              const Term p = script.declare("p", path_sort);
              script.require(meant(T, p));
              script.require(meant(S, p));
              script.require(implies(same(T, S), equal(state_at(T, p), state_at(S, p))));
            } else {
              script.comment("By same_in_quarters.");
              std::vector<Term> quarters;
              for (unsigned k = 0; k < 4; ++k) quarters.push_back(same(part(T, k), part(S, k)));
              script.require(implies(same(T, S), both(quarters)));
              script.comment("Supposed of each quarter, where one of the two trees is smaller, or both.");
              for (unsigned k = 0; k < 4; ++k) script.require(said("alike", {part(T, k), part(S, k)}));
            }
            return {both({settled(T), settled(S)}), {said("alike", {T, S})}};
          });
}

void add_parse(std::vector<Statement>& all) {
  for (const Shape left : shapes)
    for (const Shape right : shapes)
      add(all, "parse_" + pair_of(left, right),
          std::string("A ") + name(left) + " and a " + name(right) +
              " whose encodings both begin at the same place are the same tree: sequences are read in one "
              "way.",
          [&](Script& script) -> Lemma {
            define_counts(script);
            define_sequences(script);
            script.raw(R"(
; The induction's statement.
(define-fun one ((T Tree) (S Tree) (t Int) (d Int)) Bool
  (=> (and (stands T t d) (stands S t d)) (= T S)))
)");
            const auto [T, children] = grow(script, left, 'A', "T");
            const auto [S, others] = grow(script, right, 'B', "S");
            const Term t = script.declare("t", integer), d = script.declare("d", integer);
            script.require(placed(T, t, d));
            script.require(placed(S, t, d));
            if (left == Shape::node && right == Shape::node) {
              script.comment("Where the children of T stand.");
              const auto at = places(script, children, plus(t, whole_number(1)), d);
              script.comment("Supposed of each pair of children, there.");
              for (unsigned k = 0; k < 4; ++k)
                script.require(said("one", {children[k], others[k], at[k].first, at[k].second}));
            }
            return {stands(T, t, d), {said("one", {T, S, t, d})}};
          });
}

void add_sizes(std::vector<Statement>& all) {
  for (const Shape shape : shapes)
    add(all, std::string("sizes_") + name(shape),
        std::string("A ") + name(shape) +
            " has 4i+1 nodes and 3i+1 leaves, i of its nodes being internal; on x micro-triangles no more "
            "than (4x-1)/3 nodes and x leaves, and just as many nodes where the tree is perfect.",
        [shape](Script& script) -> Lemma {
          define_counts(script);
          script.raw(R"(
; The induction's statements.
(define-fun balanced ((T Tree)) Bool
  (and (= (nodes T) (+ (* 4 (inner T)) 1)) (= (leaves T) (+ (* 3 (inner T)) 1))))
(define-fun within ((T Tree) (x Int)) Bool
  (and (<= (* 3 (nodes T)) (- (* 4 x) 1)) (<= (leaves T) x)))
(define-fun full ((T Tree) (x Int)) Bool (= (* 3 (nodes T)) (- (* 4 x) 1)))
)");
          const auto [T, children] = grow(script, shape);
          const Term y = script.declare("y", integer);
          script.require(counted(T));
          script.require(at_least(1, y));
          // A leaf may be that of any level; a perfect tree's is one micro-triangle.
          if (shape == Shape::leaf)
            return {less_or_equal(whole_number(2), y),
                    {said("balanced", {T}), said("within", {T, y}), said("full", {T, whole_number(1)})}};
          const Term x = script.define("x", apply("*", {whole_number(4), y}, integer));
          std::vector<Term> sizes, perfect;
          script.comment("Supposed of each child, which has y micro-triangles.");
          for (const Term& c : children) {
            script.require(said("balanced", {c}));
            script.require(said("within", {c, y}));
            perfect.push_back(said("full", {c, y}));
          }
          return {
              both(perfect),
              {said("balanced", {T}), said("within", {T, x}), implies(both(perfect), said("full", {T, x}))}};
        });
}

}  // namespace mmverify::proofs::tree::induction
