#include "proofs/tree/induction/names.hpp"

namespace mmverify::proofs::tree::induction {

using proofs::induction::apply;
using proofs::induction::decided;
using proofs::induction::no;
using proofs::induction::whole_number;

namespace {

constexpr char trees[] = R"(
; A tree: a leaf with its state, or an internal node with its children.
; A function on trees is declared, and what defines it, one level deep, is a predicate that is asserted
; of the trees in question.
(declare-sort State 0)
(declare-datatypes ((Tree 0)) (((leaf (value State))
                                (node (child0 Tree) (child1 Tree) (child2 Tree) (child3 Tree)))))
)";

constexpr char counts[] = R"(
; Nodes and leaves, which are the bits and values of an encoding, and internal nodes.
(declare-fun nodes (Tree) Int)
(declare-fun leaves (Tree) Int)
(declare-fun inner (Tree) Int)
(define-fun counted ((T Tree)) Bool
  (ite ((_ is leaf) T)
    (and (= (nodes T) 1) (= (leaves T) 1) (= (inner T) 0))
    (and (= (nodes T) (+ 1 (nodes (child0 T)) (nodes (child1 T)) (nodes (child2 T)) (nodes (child3 T))))
         (= (leaves T) (+ (leaves (child0 T)) (leaves (child1 T)) (leaves (child2 T)) (leaves (child3 T))))
         (= (inner T) (+ 1 (inner (child0 T)) (inner (child1 T)) (inner (child2 T)) (inner (child3 T)))))))
)";

constexpr char sequences[] = R"(
; Succinct-Tree, `size` bits, true for internal nodes; Data.
(declare-const size Int)
(declare-fun internal (Int) Bool)
(declare-fun data (Int) State)
; The encoding of T begins at bit t and value d: pre-order, children first to last.
(declare-fun stands (Tree Int Int) Bool)
(define-fun placed ((T Tree) (t Int) (d Int)) Bool
  (= (stands T t d)
     (and (< t size)
          (ite ((_ is leaf) T)
            (and (not (internal t)) (= (data d) (value T)))
            (and (internal t)
                 (stands (child0 T) (+ t 1) d)
                 (stands (child1 T) (+ t 1 (nodes (child0 T))) (+ d (leaves (child0 T))))
                 (stands (child2 T) (+ t 1 (nodes (child0 T)) (nodes (child1 T)))
                                    (+ d (leaves (child0 T)) (leaves (child1 T))))
                 (stands (child3 T) (+ t 1 (nodes (child0 T)) (nodes (child1 T)) (nodes (child2 T)))
                                    (+ d (leaves (child0 T)) (leaves (child1 T)) (leaves (child2 T)))))))))
)";

constexpr char maps[] = R"(
; The way from a root to a micro-triangle: a digit, and the rest.
(declare-sort Path 0)
(declare-fun first (Path) Int)
(declare-fun rest (Path) Path)
; The map that T means: the state at the end of each path.
(declare-fun state_at (Tree Path) State)
(define-fun meant ((T Tree) (p Path)) Bool
  (and (<= 0 (first p)) (<= (first p) 3)
       (= (state_at T p)
          (ite ((_ is leaf) T) (value T)
          (ite (= (first p) 0) (state_at (child0 T) (rest p))
          (ite (= (first p) 1) (state_at (child1 T) (rest p))
          (ite (= (first p) 2) (state_at (child2 T) (rest p)) (state_at (child3 T) (rest p)))))))))
)";

constexpr char merging[] = R"(
; What Algorithm 1 compares of two children: their states; internal nodes have none.
(define-fun same_state ((A Tree) (B Tree)) Bool
  (and (= ((_ is leaf) A) ((_ is leaf) B)) (=> ((_ is leaf) A) (= (value A) (value B)))))
)";

}  // namespace

void define_trees(Script& script) { script.raw(trees); }
void define_counts(Script& script) { script.raw(counts); }
void define_sequences(Script& script) { script.raw(sequences); }
void define_maps(Script& script) { script.raw(maps); }
void define_merging(Script& script) { script.raw(merging); }

Term implies(const Term& premise, const Term& conclusion) {
  return apply("=>", {premise, conclusion}, boolean);
}
Term plus(const Term& a, const Term& b) { return apply("+", {a, b}, integer); }
Term minus(const Term& a, long long k) { return k == 0 ? a : apply("-", {a, whole_number(k)}, integer); }
Term at_least(long long bound, const Term& x) { return apply("<=", {whole_number(bound), x}, boolean); }

Term leaf(const Term& value) { return apply("leaf", {value}, tree_sort); }
Term node(const std::vector<Term>& children) { return apply("node", children, tree_sort); }
Term is_leaf(const Term& tree) { return apply("(_ is leaf)", {tree}, boolean); }
Term value(const Term& tree) { return apply("value", {tree}, state_sort); }
Term child(const Term& tree, std::size_t k) { return apply("child" + std::to_string(k), {tree}, tree_sort); }
Term nodes(const Term& tree) { return apply("nodes", {tree}, integer); }
Term leaves(const Term& tree) { return apply("leaves", {tree}, integer); }
Term stands(const Term& tree, const Term& t, const Term& d) { return apply("stands", {tree, t, d}, boolean); }
Term state_at(const Term& tree, const Term& path) { return apply("state_at", {tree, path}, state_sort); }
Term first(const Term& path) { return apply("first", {path}, integer); }
Term rest(const Term& path) { return apply("rest", {path}, path_sort); }
Term bitscan_ends(const Term& child, const Term& t, const Term& d) {
  return apply("bitscan", {child, t, d}, cursor_sort);
}
Term place(const Term& t, const Term& d) { return apply("place", {t, d}, cursor_sort); }
Term stacked(const Term& tree, const Term& stack) { return apply("stacked", {tree, stack}, stack_sort); }

Integer Bits::size() const { return Integer(Term("size", integer)); }
bool Bits::operator[](const Integer& t) const { return decided(apply("internal", {t.term}, boolean)); }

Place bitscan(const Bits&, const Integer& child, const Place& at) {
  const Term end = bitscan_ends(child.term, at.t.term, at.d.term);
  return {Integer(apply("bit", {end}, integer)), Integer(apply("datum", {end}, integer))};
}

Child::operator bool() const { return decided(has_state()); }

bool operator==(const Child& a, const Child& b) {
  return decided(apply("same_state", {a.tree_.value(), b.tree_.value()}, boolean));
}

Term Child::tree(const std::vector<Term>& children) const {
  return tree_ ? proofs::induction::choose(has_state(), *tree_, node(children)) : node(children);
}

bool Node::internal() const { return decided(no(is_leaf(tree))); }

Term Stack::term() const {
  Term all = below_;
  for (const Node& n : above_) all = stacked(n.tree, all);
  return all;
}

}  // namespace mmverify::proofs::tree::induction
