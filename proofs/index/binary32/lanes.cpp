// impl's code for vectors, with Highway functions that write formulas: each lane by itself, as Highway's functions
// act.
#include <cstdint>

#include "proofs/index/binary32/steps.hpp"

namespace mmverify::proofs::index::binary32 {

using namespace proofs::induction;

namespace {

namespace hn {

struct FloatTag {};
struct IntTag {};
struct WordTag {};
template <class Tag>
struct Lane {
  Term term;
};
using FloatLane = Lane<FloatTag>;
using IntLane = Lane<IntTag>;
using WordLane = Lane<WordTag>;
/// A mask of lanes, as a Boolean.
template <class Tag>
struct Mask {
  Term term;
};

Term word(std::uint32_t k) { return Word<32>(k).term; }
template <class Tag>
Lane<Tag> bits(const char* head, const Lane<Tag>& a, const Lane<Tag>& b) {
  return {apply(head, {a.term, b.term}, word_sort(32))};
}
FloatLane rounded(const char* head, const FloatLane& a, const FloatLane& b) {
  return {apply(head, {a.term, b.term}, induction::binary32)};
}
Term asked(const char* head, const Term& a, const Term& b) { return apply(head, {a, b}, boolean); }

/// The number of choices between two zeros, or beside a NaN.  Processors differ in the operand that they give, so
/// each choice has a Boolean of its own.
thread_local int ties = 0;
Term either(const Term& a, const Term& b) {
  return choose(Term("tie_" + std::to_string(ties++), boolean), a, b);
}

FloatLane Set(FloatTag, float x) { return {Binary32(x).term}; }
FloatLane Zero(FloatTag d) { return Set(d, 0.0f); }
IntLane Set(IntTag, std::int32_t k) { return {word(static_cast<std::uint32_t>(k))}; }
IntLane Zero(IntTag d) { return Set(d, 0); }
WordLane Set(WordTag, std::uint32_t k) { return {word(k)}; }

FloatLane Mul(const FloatLane& a, const FloatLane& b) { return rounded("fp.mul RNE", a, b); }
FloatLane Add(const FloatLane& a, const FloatLane& b) { return rounded("fp.add RNE", a, b); }
FloatLane Sub(const FloatLane& a, const FloatLane& b) { return rounded("fp.sub RNE", a, b); }
FloatLane Min(const FloatLane& a, const FloatLane& b) {
  return {choose(asked("fp.lt", a.term, b.term), a.term,
                 choose(asked("fp.lt", b.term, a.term), b.term, either(a.term, b.term)))};
}
FloatLane Max(const FloatLane& a, const FloatLane& b) {
  return {choose(asked("fp.gt", a.term, b.term), a.term,
                 choose(asked("fp.gt", b.term, a.term), b.term, either(a.term, b.term)))};
}
Mask<FloatTag> Gt(const FloatLane& a, const FloatLane& b) { return {asked("fp.gt", a.term, b.term)}; }
Mask<FloatTag> Ge(const FloatLane& a, const FloatLane& b) { return {asked("fp.geq", a.term, b.term)}; }
FloatLane IfThenElseZero(const Mask<FloatTag>& mask, const FloatLane& x) {
  return {choose(mask.term, x.term, Binary32(0.0f).term)};
}
Mask<IntTag> RebindMask(IntTag, const Mask<FloatTag>& mask) { return {mask.term}; }
IntLane VecFromMask(IntTag, const Mask<IntTag>& mask) { return {choose(mask.term, word(~0u), word(0))}; }
IntLane ConvertTo(IntTag, const FloatLane& x) { return {static_cast<SignedWord>(Binary32(x.term)).term}; }
FloatLane ConvertTo(FloatTag, const IntLane& k) { return {Binary32(SignedWord(k.term)).term}; }

IntLane Add(const IntLane& a, const IntLane& b) { return bits("bvadd", a, b); }
IntLane Sub(const IntLane& a, const IntLane& b) { return bits("bvsub", a, b); }
IntLane Min(const IntLane& a, const IntLane& b) {
  return {choose(asked("bvslt", a.term, b.term), a.term, b.term)};
}
WordLane BitCast(WordTag, const IntLane& k) { return {k.term}; }
WordLane Xor(const WordLane& a, const WordLane& b) { return bits("bvxor", a, b); }
WordLane And(const WordLane& a, const WordLane& b) { return bits("bvand", a, b); }
WordLane Or(const WordLane& a, const WordLane& b) { return bits("bvor", a, b); }
/// (NOT a) AND b.
WordLane AndNot(const WordLane& a, const WordLane& b) {
  return And({apply("bvnot", {a.term}, word_sort(32))}, b);
}
template <int by>
WordLane ShiftLeft(const WordLane& a) {
  return bits("bvshl", a, {word(by)});
}
template <int by>
WordLane ShiftRight(const WordLane& a) {
  return bits("bvlshr", a, {word(by)});
}

}  // namespace hn

using Floats = hn::FloatTag;
using Ints = hn::IntTag;
using Words = hn::WordTag;
using FloatVec = hn::FloatLane;
using IntVec = hn::IntLane;
using WordVec = hn::WordLane;
using impl::index::Level;

#define HWY_INLINE inline
#include "impl/index/lanes-inl.hpp"
#undef HWY_INLINE

IntVec as_word(const Term& condition) { return {choose(condition, hn::word(1), hn::word(0))}; }

}  // namespace

Steps lane_steps() {
  return {.name = "lanes",
          .free = {"tie_0", "tie_1"},
          .scaled =
              [](const Term& x, const Term& N) {
                hn::ties = 0;
                return scaled(FloatVec{x}, FloatVec{N}).term;
              },
          .cut = [](const Term& y) -> CutTerms {
            const Cut c = cut(FloatVec{y});
            return {c.whole.term, c.part.term};
          },
          .reach_one =
              [](const Term& uf, const Term& vf) {
                hn::ties = 0;
                return reach_one(FloatVec{uf}, FloatVec{vf}).term;
              },
          .is_more_than_none = [](const Term& uf) { return is_more_than_none(FloatVec{uf}).term; },
          .square = [](const Term& iu, const Term& iv, const Term& carry, const Term& N) -> SquareTerms {
            const Square q = square(IntVec{iu}, IntVec{iv}, as_word(carry), IntVec{N});
            return {q.iu.term, q.iv.term, q.row.term};
          },
          .curve =
              [](const SquareTerms& q) {
                return curve(Square{IntVec{q.iu}, IntVec{q.iv}, IntVec{q.row}}).term;
              },
          .row_place = [](const Term& iu, const Term& iv, const Term& carry, const Term& beyond,
                          const Term& N) -> RowTerms {
            const RowPlace p = row_place(IntVec{iu}, IntVec{iv}, as_word(carry), as_word(beyond), IntVec{N});
            return {p.row.term, p.col.term, p.dia.term};
          }};
}

Steps lane_steps_of_plain_sums() {
  Steps steps = lane_steps();
  steps.reach_one = [](const Term& uf, const Term& vf) {
    return one_if_float(hn::Ge(hn::Add(FloatVec{uf}, FloatVec{vf}), hn::Set(Floats(), 1.0f))).term;
  };
  return steps;
}

}  // namespace mmverify::proofs::index::binary32
