#include "proofs/attribute/induction/lemmas.hpp"
#include "proofs/index/induction/formula.hpp"

namespace mmverify::proofs::attribute::induction {

using namespace proofs::induction;

namespace {

constexpr char definitions[] = R"(
; A triangle with M micro-triangles to a side, and the words iu iv iw of one of them, reduced to the bits
; that are still to come.
;   mid        the triangle is turned, an odd number of middle children having been entered
;   above      the XOR of the formula's t over the bits that are done
;   upright    how the micro-triangle itself stands
(define-fun held ((M Int) (mid Bool) (upright Bool) (iu Int) (iv Int) (iw Int)) Bool
  (and (<= 0 iu) (< iu M) (<= 0 iv) (< iv M) (<= 0 iw) (< iw M)
       (= (+ iu iv iw) (- (ite mid (- (* 2 M) 1) (- M 1)) (ite upright 0 1)))))
; The words' highest bits in child d: all alike in the middle one, and else one differs.
(define-fun bit_u ((d Int) (mid Bool) (above Bool)) Bool (ite (or (= d 0) (= d 2)) (xor above (= d 2)) mid))
(define-fun bit_v ((d Int) (mid Bool) (above Bool)) Bool (ite (= d 3) (not mid) mid))
(define-fun bit_w ((d Int) (mid Bool) (above Bool)) Bool
  (ite (or (= d 0) (= d 2)) (not (bit_u d mid above)) mid))
)";

/// The triangle that the curve is in.  mid: turned, since a middle child was entered an odd number of times.  above:
/// children 0 and 2 have changed places (the XOR of the formula's t so far).
struct Frame {
  Term mid, above;
};
/// The low bits of iu, iv and iw that are still to come.
struct Words {
  Counted iu, iv, iw;
};

/// Writes `held`, `bit_u`, `bit_v`, `bit_w` into a script.
void define_curve(Script& script) { script.raw(definitions); }

/// The words are those of a micro-triangle inside the frame, upright or not.
Term held(const Counted& M, const Term& mid, const Term& upright, const Words& w) {
  return apply("held", {M.term, mid, upright, w.iu.term, w.iv.term, w.iw.term}, boolean);
}
/// The words' highest bits in child `digit`.
Term bit(const char* which, const Counted& digit, const Frame& frame) {
  return apply(which, {digit.term, frame.mid, frame.above}, boolean);
}
Frame declare_frame(Script& script) {
  const Term mid = script.declare("mid", boolean);
  return {mid, script.declare("above", boolean)};
}
Words declare_words(Script& script) {
  const Counted iu = whole(script, "iu"), iv = whole(script, "iv");
  return {iu, iv, whole(script, "iw")};
}
/// The frame of child `digit`.
Frame entered(Script& script, const Counted& digit, const Frame& frame) {
  const Term mid = script.define("next_mid", apply("xor", {frame.mid, same(digit, 1)}, boolean));
  return {mid, script.define("next_above", apply("xor", {frame.above, same(digit, 3)}, boolean))};
}

/// The digit b0 + 2 b1 of spec::index::curve_bits on the words' highest bits, and t.
struct CurveDigit {
  Counted digit;
  Term t;
};
CurveDigit curve_digit(Script& script, const Term& bu, const Term& bv, const Term& bw, const Frame& frame) {
  Term t = truth(false);
  const auto bits = index::induction::Specified::bits(spec::index::Quantised<Bit>{Bit(bu), Bit(bv), Bit(bw)},
                                                      Bit(truth(true)), [&](const Bit& of) {
                                                        t = of.term;
                                                        return Bit(frame.above) ^ of;
                                                      });
  const Term b0 = script.define("b0", bits.b0.term), b1 = script.define("b1", bits.b1.term);
  const auto one_if = [](const Term& b) { return Counted(choose(b, whole_number(1), whole_number(0))); };
  return {named(script, "digit", one_if(b0) + 2 * one_if(b1)), script.define("t", t)};
}

/// The words less m, if they are not below m.
Words rest_of(Script& script, const Words& w, const Counted& m) {
  const auto rest = [&](const char* name, const Counted& word) {
    return named(script, name, Counted(choose(at_most(m, word), (word - m).term, word.term)));
  };
  const Counted iu = rest("next_iu", w.iu), iv = rest("next_iv", w.iv);
  return {iu, iv, rest("next_iw", w.iw)};
}

void add_curve_opening(std::vector<Statement>& all) {
  add(all, "curve_opening",
      "The words that spec::attribute::curve_words gives a micro-triangle with N to a side are held by a "
      "triangle that is not turned, upright ones being the lower ones.  iw is negative, and its low n bits "
      "are those of iw + N.",
      [](Script& script) {
        define_curve(script);
        const Counted N = whole(script, "N");
        const auto t = declare_face(script, N);
        const auto paths = every_path(
            [&] { return specified::curve_words(Integer(t.iu.term), Integer(t.iv.term), is_upper(t)); });
        const auto word = [&](const char* name, auto project) {
          return Counted(script.define(name, as_formula(paths, project)));
        };
        const Words w{word("word_u", [](const auto& q) { return q.iu.term; }),
                      word("word_v", [](const auto& q) { return q.iv.term; }),
                      word("word_w", [](const auto& q) { return q.iw.term; }) + N};
        return Lemma{{held(N, truth(false), same(t.upper, 0), w), same(w.iu, t.iu), same(w.iv, t.iv)},
                     both({less(0, t.iu), less(0, t.iv), same(t.upper, 1)})};
      });
  add(all, "curve_opening_onto",
      "All words that such a triangle holds are some micro-triangle's: iu, iv are its square and iw is what "
      "is left.",
      [](Script& script) {
        define_curve(script);
        const Counted N = whole(script, "N");
        const Words w = declare_words(script);
        const Term upright = script.declare("upright", boolean);
        script.require(held(N, truth(false), upright, w));
        const Counted upper(choose(upright, whole_number(0), whole_number(1)));
        return Lemma{{is_face({w.iu, w.iv, upper}, N), same(w.iw, N - 1 - w.iu - w.iv - upper)},
                     both({less(0, w.iu), less(0, w.iv), less(0, w.iw)})};
      });
}

void add_curve_digit(std::vector<Statement>& all) {
  add(all, "curve_step",
      "One digit: the words of a micro-triangle with M = 2m to a side have a digit, that of "
      "spec::index::curve_bits; what is left of them is held by the digit's child, m to a side, and stands "
      "as before; child 1 alone is turned, below child 3 alone 0 and 2 change places; and the digit and the "
      "frame tell the words' highest bits.",
      [](Script& script) {
        define_curve(script);
        const Counted m = whole(script, "m");
        const Counted M = named(script, "M", 2 * m);
        const Frame frame = declare_frame(script);
        const Words w = declare_words(script);
        const Term upright = script.declare("upright", boolean);
        script.require(at_most(1, m));
        script.require(held(M, frame.mid, upright, w));
        const Term bu = script.define("bu", at_most(m, w.iu)), bv = script.define("bv", at_most(m, w.iv)),
                   bw = script.define("bw", at_most(m, w.iw));
        const CurveDigit found = curve_digit(script, bu, bv, bw, frame);
        const Frame next = entered(script, found.digit, frame);
        const Words rest = rest_of(script, w, m);
        return Lemma{
            {within(0, found.digit, 4), held(m, next.mid, upright, rest),
             equal(found.t, same(found.digit, 3)), equal(bu, bit("bit_u", found.digit, frame)),
             equal(bv, bit("bit_v", found.digit, frame)), equal(bw, bit("bit_w", found.digit, frame))},
            both({less(1, m), frame.mid, frame.above, same(found.digit, 2)})};
      });
  add(all, "curve_onto",
      "One digit, backwards: for each digit d and all words that d's child holds there are words with M = 2m "
      "to a side that have this digit and leave these: m more where d's bits are 1.",
      [](Script& script) {
        define_curve(script);
        const Counted m = whole(script, "m"), d = whole(script, "d");
        const Frame frame = declare_frame(script);
        const Words rest = declare_words(script);
        const Term upright = script.declare("upright", boolean);
        script.require(both({at_most(1, m), within(0, d, 4)}));
        const Frame next = entered(script, d, frame);
        script.require(held(m, next.mid, upright, rest));
        const Term bu = script.define("bu", bit("bit_u", d, frame)),
                   bv = script.define("bv", bit("bit_v", d, frame)),
                   bw = script.define("bw", bit("bit_w", d, frame));
        const auto word = [&](const char* name, const Counted& low, const Term& high) {
          return named(script, name, Counted(choose(high, (low + m).term, low.term)));
        };
        const Words w{word("word_u", rest.iu, bu), word("word_v", rest.iv, bv), word("word_w", rest.iw, bw)};
        const CurveDigit found = curve_digit(script, bu, bv, bw, frame);
        return Lemma{{held(2 * m, frame.mid, upright, w), same(found.digit, d)},
                     both({less(1, m), frame.mid, frame.above, same(d, 2)})};
      });
}

/// Corner 0, 1, 2 of the frame whose words begin at (a, b), M to a side.
VertexOf<Counted> frame_corner(Script& script, const std::string& name, int corner, const Counted& a,
                               const Counted& b, const Counted& M, const Frame& frame) {
  // Not turned: (a, b), (a+M, b), (a, b+M).  Turned: (a, b+M), (a+M, b+M), (a+M, b).  `above` swaps the first two.
  const auto at = [&](int k) {
    const auto pick = [&](const Counted& plain, const Counted& turned) {
      return Counted(choose(frame.mid, turned.term, plain.term));
    };
    if (k == 0) return VertexOf<Counted>{a, pick(b, b + M)};
    if (k == 1) return VertexOf<Counted>{a + M, pick(b, b + M)};
    return VertexOf<Counted>{pick(a, a + M), pick(b + M, b)};
  };
  const VertexOf<Counted> plain = at(corner), other = at(corner == 2 ? 2 : 1 - corner);
  const auto pick = [&](const Counted& x, const Counted& y) {
    return Counted(choose(frame.above, y.term, x.term));
  };
  return {named(script, name + "_i", pick(plain.i, other.i)),
          named(script, name + "_j", pick(plain.j, other.j))};
}

}  // namespace

void add_curve_words(std::vector<Statement>& all) {
  add_curve_opening(all);
  add_curve_digit(all);
  add(all, "curve_base",
      "One micro-triangle left: the words have no bit left, and it stands upright if the triangle is not "
      "turned.",
      [](Script& script) {
        define_curve(script);
        const Frame frame = declare_frame(script);
        const Words w = declare_words(script);
        const Term upright = script.declare("upright", boolean);
        script.require(held(1, frame.mid, upright, w));
        return Lemma{{same(w.iu, 0), same(w.iv, 0), same(w.iw, 0), equal(upright, no(frame.mid))}, frame.mid};
      });
}

void add_curve_corners(std::vector<Statement>& all, const Parts<Counted>& by) {
  add(all, "curve_corners_step",
      "From index to corners: a triangle with 2m to a side has corners P as the frame says; the corners of "
      "child d are those of d's frame, m to a side, whose words begin m further on where d's bits are 1.",
      [&](Script& script) {
        define_curve(script);
        const Counted m = whole(script, "m"), a = whole(script, "a"), b = whole(script, "b"),
                      d = whole(script, "d");
        script.require(both({at_most(1, m), within(0, d, 4)}));
        const Frame frame = declare_frame(script);
        std::array<VertexOf<Counted>, 3> P{frame_corner(script, "P0", 0, a, b, 2 * m, frame),
                                           frame_corner(script, "P1", 1, a, b, 2 * m, frame),
                                           frame_corner(script, "P2", 2, a, b, 2 * m, frame)};
        const Frame next = entered(script, d, frame);
        const auto moved = [&](const char* name, const Counted& from, const char* which) {
          return named(script, name, Counted(choose(bit(which, d, frame), (from + m).term, from.term)));
        };
        const Counted next_a = moved("next_a", a, "bit_u"), next_b = moved("next_b", b, "bit_v");
        std::vector<Term> claims;
        for (int k = 0; k < 3; ++k) {
          const std::size_t at = static_cast<std::size_t>(k);
          const auto child = [&](std::uint32_t digit) { return by.corners_turn(P, digit)[at]; };
          const std::string name = "child_P" + std::to_string(k);
          const VertexOf<Counted> got{
              named(script, name + "_i", by_digit(d, {child(0).i, child(1).i, child(2).i, child(3).i})),
              named(script, name + "_j", by_digit(d, {child(0).j, child(1).j, child(2).j, child(3).j}))};
          claims.push_back(same_vertex(
              got, frame_corner(script, "next_P" + std::to_string(k), k, next_a, next_b, m, next)));
        }
        return Lemma{claims, both({less(1, m), less(0, a), less(a, b), same(d, 1)})};
      });
  add(all, "curve_corners_base",
      "From index to corners, one micro-triangle left: the corners are those of the micro-triangle at the "
      "words' beginning (a, b), a lower one where the frame is not turned and an upper one where it is.",
      [&](Script& script) {
        define_curve(script);
        const Counted a = whole(script, "a"), b = whole(script, "b");
        const Frame frame = declare_frame(script);
        std::array<VertexOf<Counted>, 3> P{frame_corner(script, "P0", 0, a, b, 1, frame),
                                           frame_corner(script, "P1", 1, a, b, 1, frame),
                                           frame_corner(script, "P2", 2, a, b, 1, frame)};
        const auto t = face_outcome(script, "t", [&] { return specified::face_of_any_corners(P); });
        const Counted upper(choose(frame.mid, Counted(1).term, Counted(0).term));
        return Lemma{{same_face(t, {a, b, upper})}, both({less(0, a), less(a, b), frame.mid})};
      });
}

}  // namespace mmverify::proofs::attribute::induction
