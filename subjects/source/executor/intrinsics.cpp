// LLVM's own functions: memory, counts of bits, sums that tell their overflow, and marks without effect.
#include <llvm/IR/IntrinsicInst.h>

#include "subjects/source/executor/executor.hpp"

namespace mmverify::source::executor {
namespace {

namespace Intrinsic = llvm::Intrinsic;

Word reversed_bytes(const Word& w) {
  Word made(w.size());
  for (std::size_t k = 0; k < w.size(); ++k) made[k] = w[8 * (w.size() / 8 - 1 - k / 8) + k % 8];
  return made;
}

/// Number of set bits, in a word of the same width.
Word ones_in(Graph& g, const Word& w) {
  Word count = circuit::constant(0, w.size());
  for (const Literal l : w) count = circuit::sum(g, count, circuit::constant(0, w.size()), l);
  return count;
}

/// Number of zero bits below the lowest set one; the width if there is none.
Word zeros_below(Graph& g, const Word& w) {
  Word below(w.size());
  Literal none = always;
  for (std::size_t k = 0; k < w.size(); ++k) below[k] = none = g.both(none, negated(w[k]));
  return ones_in(g, below);
}

}  // namespace

ValuePtr Executor::counted(State& s, const llvm::CallBase& i) {
  const ValuePtr v = numeric(s, i.getArgOperand(0), i);
  const auto id = i.getIntrinsicID();
  if (id == Intrinsic::bswap)
    return number(reversed_bytes(v->bits), v->unset.empty() ? Word{} : reversed_bytes(v->unset));
  const Word upside_down(v->bits.rbegin(), v->bits.rend());
  if (id == Intrinsic::bitreverse)
    return number(upside_down, v->unset.empty() ? Word{} : Word(v->unset.rbegin(), v->unset.rend()));
  require_set(v, i, "bits are counted that were never set");
  if (id == Intrinsic::ctpop) return number(ones_in(graph_, v->bits));
  if (const auto of_zero = known(numeric(s, i.getArgOperand(1), i)); of_zero && *of_zero != 0)
    require_never(Duty::promises, negated(circuit::not_zero(graph_, v->bits)), i,
                  "zeros of the number 0 are counted");
  return number(zeros_below(graph_, id == Intrinsic::cttz ? v->bits : upside_down));
}

ValuePtr Executor::with_overflow(State& s, const llvm::CallBase& i) {
  const ValuePtr a = numeric(s, i.getArgOperand(0), i), b = numeric(s, i.getArgOperand(1), i);
  require_set(a, i, "arithmetic on a value that was never set");
  require_set(b, i, "arithmetic on a value that was never set");
  const auto& op = llvm::cast<llvm::WithOverflowInst>(i);
  const bool multiplies = op.getBinaryOp() == llvm::Instruction::Mul;
  const std::size_t width = a->bits.size(), wide = multiplies ? 2 * width : width + 1;
  const Word x = circuit::resized(a->bits, wide, op.isSigned()),
             y = circuit::resized(b->bits, wide, op.isSigned());
  const Word whole = op.getBinaryOp() == llvm::Instruction::Add ? circuit::sum(graph_, x, y)
                     : multiplies                               ? circuit::product(graph_, x, y)
                                                                : circuit::difference(graph_, x, y);
  const Word kept = circuit::resized(whole, width, false);
  const Literal over = negated(circuit::equal(graph_, whole, circuit::resized(kept, wide, op.isSigned())));
  return parts({number(kept), number({over})});
}

bool Executor::call_intrinsic(Call&, State& s, const llvm::CallBase& i) {
  const auto argument = [&](unsigned k) { return value(s, i.getArgOperand(k), i); };
  const auto bits = [&](unsigned k) {
    const ValuePtr v = numeric(s, i.getArgOperand(k), i);
    require_set(v, i, "arithmetic on a value that was never set");
    return v->bits;
  };
  Graph& g = graph_;
  switch (i.getIntrinsicID()) {
    case Intrinsic::lifetime_start:
    case Intrinsic::lifetime_end: {
      const ValuePtr p = argument(1);
      if (!is_pointer(p) || p->targets.size() != 1) return true;
      const int object = p->targets.front().object;
      if (const Object* o = s.memory.find(object); o != nullptr && o->call != 0)
        forget(s.memory.writable(object), 0, o->cells.size());
      return true;
    }
    case Intrinsic::stacksave:
      s.values[&i] = pointer(null_object);
      return true;
    case Intrinsic::stackrestore:
    case Intrinsic::experimental_noalias_scope_decl:
    case Intrinsic::prefetch:
      return true;
    case Intrinsic::assume: {
      const ValuePtr v = numeric(s, i.getArgOperand(0), i);
      require_set(v, i, "a promise about a value that was never set");
      require_never(Duty::promises, negated(v->bits[0]), i,
                    "the code's own promise (__builtin_assume) does not hold");
      return true;
    }
    case Intrinsic::trap:
    case Intrinsic::ubsantrap:
      require_never(Duty::ends, always, i, "the program traps");
      return false;
    case Intrinsic::expect:
      s.values[&i] = argument(0);
      return true;
    case Intrinsic::memset:
      fill(s, argument(0), argument(1), bits(2), i);
      return true;
    case Intrinsic::memcpy:
    case Intrinsic::memcpy_inline:
      copy(s, argument(0), argument(1), bits(2), false, i);
      return true;
    case Intrinsic::memmove:
      copy(s, argument(0), argument(1), bits(2), true, i);
      return true;
    case Intrinsic::ctpop:
    case Intrinsic::ctlz:
    case Intrinsic::cttz:
    case Intrinsic::bswap:
    case Intrinsic::bitreverse:
      s.values[&i] = counted(s, i);
      return true;
    case Intrinsic::umin:
      s.values[&i] = number(circuit::chosen(g, circuit::less(g, bits(0), bits(1)), bits(0), bits(1)));
      return true;
    case Intrinsic::umax:
      s.values[&i] = number(circuit::chosen(g, circuit::less(g, bits(0), bits(1)), bits(1), bits(0)));
      return true;
    case Intrinsic::smin:
      s.values[&i] = number(circuit::chosen(g, circuit::less_signed(g, bits(0), bits(1)), bits(0), bits(1)));
      return true;
    case Intrinsic::smax:
      s.values[&i] = number(circuit::chosen(g, circuit::less_signed(g, bits(0), bits(1)), bits(1), bits(0)));
      return true;
    case Intrinsic::fshl:
    case Intrinsic::fshr: {
      const Word low = i.getIntrinsicID() == Intrinsic::fshl ? bits(1) : bits(1), high = bits(0);
      Word both = low;
      both.insert(both.end(), high.begin(), high.end());
      const std::size_t width = low.size();
      const Word amount = circuit::resized(
          circuit::divided(g, bits(2), circuit::constant(width, width)).remainder, 2 * width, false);
      const bool left = i.getIntrinsicID() == Intrinsic::fshl;
      const Word moved =
          circuit::shifted(g, left ? circuit::Shift::left : circuit::Shift::right, both, amount);
      s.values[&i] = number(left ? Word(moved.begin() + static_cast<long>(width), moved.end())
                                 : Word(moved.begin(), moved.begin() + static_cast<long>(width)));
      return true;
    }
    case Intrinsic::uadd_with_overflow:
    case Intrinsic::sadd_with_overflow:
    case Intrinsic::usub_with_overflow:
    case Intrinsic::ssub_with_overflow:
    case Intrinsic::umul_with_overflow:
    case Intrinsic::smul_with_overflow:
      s.values[&i] = with_overflow(s, i);
      return true;
    case Intrinsic::abs: {
      const Word a = bits(0);
      s.values[&i] =
          number(circuit::chosen(g, a.back(), circuit::difference(g, circuit::constant(0, a.size()), a), a));
      return true;
    }
    default:
      throw Unreadable(i, "a call of " + i.getCalledFunction()->getName().str());
  }
}

}  // namespace mmverify::source::executor
