#include "proofs/index/induction/relation.hpp"

namespace mmverify::proofs::index::induction {

using namespace proofs::induction;

namespace {

constexpr char definitions[] = R"(
; The relation between the recursion and the reference on a triangle of M micro-triangles to a side.
;   u v w      barycentrics on the recursion's current triangle, times M
;   mid top    the recursion's flips
;   iu iv iw   the reference's words, reduced to the bits that are still to come: each in [0, M)
;   above      the XOR of the reference's t over the bits that are done
(define-fun below ((x Real)) Int (- (- 1) (to_int (- x)))) ; the greatest integer below x
(define-fun lesser ((a Int) (b Int)) Int (ite (< a b) a b))
(define-fun common ((M Int) (u Real) (v Real) (w Real) (top Bool) (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (and (<= 0.0 u) (<= 0.0 v) (<= 0.0 w) (= (+ u v w) (to_real M))
       (<= 0 iu) (< iu M) (<= 0 iv) (< iv M) (<= 0 iw) (< iw M)
       (= above top)))
; On the base triangle's hypotenuse: the reference's words are those of the square below it.
(define-fun hypotenuse ((M Int) (u Real) (v Real) (w Real) (mid Bool) (top Bool)
                        (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (and (common M u v w top iu iv iw above) (not mid) (= w 0.0)
       (= iw 0) (= iv (lesser (to_int v) (- M 1))) (= iu (- M 1 iv))))
; Off it, on a triangle that is not turned: the micro-triangle that contains the point nudged towards +u, +v.
(define-fun upright ((M Int) (u Real) (v Real) (w Real) (mid Bool) (top Bool)
                     (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (and (common M u v w top iu iv iw above) (not mid) (< 0.0 w)
       (= iu (to_int u)) (= iv (to_int v)) (= iw (below w))))
; On a middle triangle, which is turned: every bit is the complement, and u and w have changed places.
(define-fun middle ((M Int) (u Real) (v Real) (w Real) (mid Bool) (top Bool)
                    (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (and (common M u v w top iu iv iw above) mid (< 0.0 v) (< 0.0 w)
       (= iw (- M 1 (to_int u))) (= iv (- M 1 (below v))) (= iu (- M 1 (below w)))))
(define-fun related ((M Int) (u Real) (v Real) (w Real) (mid Bool) (top Bool)
                     (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (or (hypotenuse M u v w mid top iu iv iw above)
      (upright M u v w mid top iu iv iw above)
      (middle M u v w mid top iu iv iw above)))
)";

Term said(const char* predicate, const Term& M, const State& s) {
  return apply(predicate, {M, s.u, s.v, s.w, s.mid, s.top, s.iu, s.iv, s.iw, s.above}, boolean);
}

}  // namespace

const char* name(Place place) {
  switch (place) {
    case Place::hypotenuse: return "hypotenuse";
    case Place::upright: return "upright";
    case Place::middle: return "middle";
  }
  return "?";
}

void define_relation(Script& script) { script.raw(definitions); }

Term in_place(Place place, const Term& M, const State& state) { return said(name(place), M, state); }
Term related(const Term& M, const State& state) { return said("related", M, state); }

State declare_state(Script& script) {
  const auto declared = [&](const char* name, const std::string& sort) { return script.declare(name, sort); };
  const Term u = declared("u", real), v = declared("v", real), w = declared("w", real);
  const Term mid = declared("mid", boolean), top = declared("top", boolean);
  const Term iu = declared("iu", integer), iv = declared("iv", integer), iw = declared("iw", integer);
  return {u, v, w, mid, top, iu, iv, iw, declared("above", boolean)};
}

}  // namespace mmverify::proofs::index::induction
