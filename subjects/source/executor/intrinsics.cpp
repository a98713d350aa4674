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

ValuePtr Executor::rotated(const llvm::CallBase& i, const Word& high, const Word& low, const Word& by) {
  const std::size_t width = low.size();
  Word both = low;
  both.insert(both.end(), high.begin(), high.end());
  const Word amount = circuit::resized(
      circuit::divided(graph_, by, circuit::constant(width, width)).remainder, 2 * width, false);
  if (i.getIntrinsicID() == Intrinsic::fshr) {
    const Word moved = circuit::shifted(graph_, circuit::Shift::right, both, amount);
    return number(Word(moved.begin(), moved.begin() + static_cast<long>(width)));
  }
  const Word moved = circuit::shifted(graph_, circuit::Shift::left, both, amount);
  return number(Word(moved.begin() + static_cast<long>(width), moved.end()));
}

ValuePtr Executor::computed(State& s, const llvm::CallBase& i) {
  const auto bits = [&](unsigned k) {
    const ValuePtr v = numeric(s, i.getArgOperand(k), i);
    require_set(v, i, "arithmetic on a value that was never set");
    return v->bits;
  };
  Graph& g = graph_;
  const auto smaller = [&](Literal first_is, bool take_smaller) {
    return number(circuit::chosen(g, first_is, bits(take_smaller ? 0 : 1), bits(take_smaller ? 1 : 0)));
  };
  switch (i.getIntrinsicID()) {
    case Intrinsic::ctpop:
    case Intrinsic::ctlz:
    case Intrinsic::cttz:
    case Intrinsic::bswap:
    case Intrinsic::bitreverse: return counted(s, i);
    case Intrinsic::umin: return smaller(circuit::less(g, bits(0), bits(1)), true);
    case Intrinsic::umax: return smaller(circuit::less(g, bits(0), bits(1)), false);
    case Intrinsic::smin: return smaller(circuit::less_signed(g, bits(0), bits(1)), true);
    case Intrinsic::smax: return smaller(circuit::less_signed(g, bits(0), bits(1)), false);
    case Intrinsic::fshl:
    case Intrinsic::fshr: return rotated(i, bits(0), bits(1), bits(2));
    case Intrinsic::uadd_with_overflow:
    case Intrinsic::sadd_with_overflow:
    case Intrinsic::usub_with_overflow:
    case Intrinsic::ssub_with_overflow:
    case Intrinsic::umul_with_overflow:
    case Intrinsic::smul_with_overflow: return with_overflow(s, i);
    case Intrinsic::abs: {
      if (const auto strict = known(numeric(s, i.getArgOperand(1), i)); strict && *strict != 0)
        require_never(
            Duty::overflow,
            circuit::equal(g, bits(0),
                           circuit::constant(std::uint64_t{1} << (bits(0).size() - 1), bits(0).size())),
            i, "the magnitude of the least number overflows");
      const Word a = bits(0), minus = circuit::difference(g, circuit::constant(0, a.size()), a);
      return number(circuit::chosen(g, a.back(), minus, a));
    }
    default: throw Unreadable(i, "a call of " + i.getCalledFunction()->getName().str());
  }
}

void Executor::set_life(State& s, const ValuePtr& p, bool lives) {
  if (!is_pointer(p) || p->targets.size() != 1) return;
  const int object = p->targets.front().object;
  const Object* found = s.memory.find(object);
  if (found == nullptr || found->call == 0) return;
  Object& own = s.memory.writable(object);
  forget(own, 0, own.cells.size());
  own.gone = lives ? never : always;
}

void Executor::require_aligned(State& s, const llvm::MemIntrinsic& i) {
  const Literal moves = circuit::not_zero(graph_, numeric(s, i.getLength(), i)->bits);
  require_aligned(s, value(s, i.getRawDest(), i), i.getDestAlign().valueOrOne().value(), moves, i, "written");
  if (const auto* copy = llvm::dyn_cast<llvm::MemTransferInst>(&i))
    require_aligned(s, value(s, copy->getRawSource(), i), copy->getSourceAlign().valueOrOne().value(), moves,
                    i, "read");
}

bool Executor::call_intrinsic(State& s, const llvm::CallBase& i) {
  if (const auto* bytes = llvm::dyn_cast<llvm::MemIntrinsic>(&i)) require_aligned(s, *bytes);
  const auto argument = [&](unsigned k) { return value(s, i.getArgOperand(k), i); };
  const auto size = [&] {
    const ValuePtr v = numeric(s, i.getArgOperand(2), i);
    require_set(v, i, "a size that was never set");
    return v->bits;
  };
  switch (i.getIntrinsicID()) {
    case Intrinsic::lifetime_start:
    case Intrinsic::lifetime_end:
      set_life(s, argument(1), i.getIntrinsicID() == Intrinsic::lifetime_start);
      break;
    case Intrinsic::stacksave: s.values[&i] = pointer(null_object); break;
    case Intrinsic::stackrestore:
    case Intrinsic::experimental_noalias_scope_decl:
    case Intrinsic::prefetch: break;
    case Intrinsic::assume: {
      const ValuePtr v = numeric(s, i.getArgOperand(0), i);
      require_set(v, i, "a promise about a value that was never set");
      require_never(Duty::promises, negated(v->bits[0]), i,
                    "the code's own promise (__builtin_assume) does not hold");
      break;
    }
    case Intrinsic::trap:
    case Intrinsic::ubsantrap: require_never(Duty::ends, always, i, "the program traps"); return false;
    case Intrinsic::eh_typeid_for: s.values[&i] = number(number_of_type(*i.getArgOperand(0), i), 32); break;
    case Intrinsic::is_constant:
      s.values[&i] = number({graph_.input()});  // one compiler knows what another does not
      break;
    case Intrinsic::expect: s.values[&i] = argument(0); break;
    case Intrinsic::memset: fill(s, argument(0), argument(1), size(), i); break;
    case Intrinsic::memcpy:
    case Intrinsic::memcpy_inline: copy(s, argument(0), argument(1), size(), false, i); break;
    case Intrinsic::memmove: copy(s, argument(0), argument(1), size(), true, i); break;
    default: s.values[&i] = computed(s, i);
  }
  return true;
}

}  // namespace mmverify::source::executor
