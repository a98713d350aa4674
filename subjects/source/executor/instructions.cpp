// Instructions on numbers and pointers.
#include <llvm/IR/InstrTypes.h>

#include <algorithm>

#include "subjects/source/executor/executor.hpp"

namespace mmverify::source::executor {
namespace {

using I = llvm::Instruction;
using Predicate = llvm::CmpInst::Predicate;

/// From the lowest unset bit of a and b on, all bits of a sum are unset.
Word unset_above(Graph& g, const Value& a, const Value& b) {
  if (a.unset.empty() && b.unset.empty()) return {};
  const Word ua = unset_bits(a), ub = unset_bits(b);
  Word all(ua.size());
  Literal any = never;
  for (std::size_t k = 0; k < ua.size(); ++k) all[k] = any = g.either(any, g.either(ua[k], ub[k]));
  return all;
}

/// All bits are unset if one of a or b is.
Word unset_wholly(Graph& g, const Value& a, const Value& b) {
  if (a.unset.empty() && b.unset.empty()) return {};
  Word all = unset_bits(a);
  const Word other = unset_bits(b);
  all.insert(all.end(), other.begin(), other.end());
  return Word(a.bits.size(), g.any_of(all));
}

/// A bit of a AND b, or of a OR b, is set where one side's set bit decides it.
Word unset_in_logic(Graph& g, const Value& a, const Value& b, bool conjunction) {
  if (a.unset.empty() && b.unset.empty()) return {};
  const Word ua = unset_bits(a), ub = unset_bits(b);
  Word all(ua.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Literal x = conjunction ? a.bits[k] : negated(a.bits[k]),
                  y = conjunction ? b.bits[k] : negated(b.bits[k]);
    all[k] = g.any_of({g.both(ua[k], ub[k]), g.both(ua[k], y), g.both(x, ub[k])});
  }
  return all;
}

Word unset_in_shift(Graph& g, circuit::Shift shift, const Value& a, const Value& b) {
  if (a.unset.empty() && b.unset.empty()) return {};
  if (!b.unset.empty()) return unset_wholly(g, a, b);
  return circuit::shifted(g, shift, unset_bits(a), b.bits);
}

circuit::Shift shift_of(unsigned opcode) {
  return opcode == I::Shl                                              ? circuit::Shift::left
         : opcode == I::LShr || planted == Mistake::shift_without_sign ? circuit::Shift::right
                                                                       : circuit::Shift::right_with_sign;
}

Word magnitude(Graph& g, const Word& a) {
  return circuit::chosen(g, a.back(), circuit::difference(g, circuit::constant(0, a.size()), a), a);
}

/// Quotient and remainder, rounded toward zero.
circuit::Division divided_signed(Graph& g, const Word& a, const Word& b) {
  circuit::Division d = circuit::divided(g, magnitude(g, a), magnitude(g, b));
  const auto with_sign = [&](Literal minus, const Word& w) {
    return circuit::chosen(g, minus, circuit::difference(g, circuit::constant(0, w.size()), w), w);
  };
  return {with_sign(g.differ(a.back(), b.back()), d.quotient), with_sign(a.back(), d.remainder)};
}

template <class F>
Word bitwise(const Word& a, const Word& b, F f) {
  Word made(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) made[k] = f(a[k], b[k]);
  return made;
}

Literal compare(Graph& g, Predicate p, const Word& a, const Word& b) {
  switch (p) {
    case Predicate::ICMP_EQ: return circuit::equal(g, a, b);
    case Predicate::ICMP_NE: return negated(circuit::equal(g, a, b));
    case Predicate::ICMP_ULT:
      return planted == Mistake::signed_compare ? circuit::less_signed(g, a, b) : circuit::less(g, a, b);
    case Predicate::ICMP_UGT: return circuit::less(g, b, a);
    case Predicate::ICMP_ULE: return negated(circuit::less(g, b, a));
    case Predicate::ICMP_UGE: return negated(circuit::less(g, a, b));
    case Predicate::ICMP_SLT: return circuit::less_signed(g, a, b);
    case Predicate::ICMP_SGT: return circuit::less_signed(g, b, a);
    case Predicate::ICMP_SLE: return negated(circuit::less_signed(g, b, a));
    default: return negated(circuit::less_signed(g, a, b));
  }
}

}  // namespace

bool Executor::step(Call& c, State& s, const llvm::Instruction& i) {
  const llvm::Type& type = *i.getType();
  if (const auto* a = llvm::dyn_cast<llvm::AllocaInst>(&i)) {
    const auto count = known(numeric(s, a->getArraySize(), i));
    if (!count) throw Unreadable(i, "an array of variable size on the stack");
    Object object;
    object.name = a->hasName() ? a->getName().str() : "a variable of " + c.function.getName().str();
    object.cells.resize(*count * layout_.getTypeAllocSize(a->getAllocatedType()));
    object.call = c.number;
    object.align = a->getAlign().value();
    // A compiler gives an array of bytes more than its type asks for; an entry point may not rely on that.
    if (c.function.hasFnAttribute(law_attribute))
      object.promised = layout_.getABITypeAlign(a->getAllocatedType()).value();
    s.memory.add(++objects_, std::move(object));
    s.values[&i] = pointer(objects_);
  } else if (const auto* l = llvm::dyn_cast<llvm::LoadInst>(&i)) {
    if (l->isAtomic()) throw Unreadable(i, "an atomic read");
    const ValuePtr from = value(s, l->getPointerOperand(), i);
    require_aligned(s, from, l->getAlign().value(), always, i, "read");
    s.values[&i] = load(s, from, layout_.getTypeStoreSize(i.getType()), type, i);
  } else if (const auto* t = llvm::dyn_cast<llvm::StoreInst>(&i)) {
    if (t->isAtomic()) throw Unreadable(i, "an atomic write");
    const ValuePtr to = value(s, t->getPointerOperand(), i);
    require_aligned(s, to, t->getAlign().value(), always, i, "written");
    store_typed(s, to, value(s, t->getValueOperand(), i), *t->getValueOperand()->getType(), i);
  } else if (const auto* gep = llvm::dyn_cast<llvm::GetElementPtrInst>(&i)) {
    s.values[&i] = moved(s, *llvm::cast<llvm::GEPOperator>(gep), i);
  } else if (const auto* call = llvm::dyn_cast<llvm::CallBase>(&i)) {
    return call_instruction(s, *call);
  } else if (const auto* pad = llvm::dyn_cast<llvm::LandingPadInst>(&i)) {
    s.values[&i] = landed(s, *pad);
  } else {
    return step_on_numbers(s, i);
  }
  return true;
}

bool Executor::step_on_numbers(State& s, const llvm::Instruction& i) {
  ValuePtr& made = s.values[&i];
  if (const auto* b = llvm::dyn_cast<llvm::BinaryOperator>(&i)) {
    made = binary(s, *b);
  } else if (const auto* p = llvm::dyn_cast<llvm::ICmpInst>(&i)) {
    made = compared(s, *p);
  } else if (const auto* t = llvm::dyn_cast<llvm::CastInst>(&i)) {
    made = cast(s, *t);
  } else if (llvm::isa<llvm::SelectInst>(i)) {
    const ValuePtr when = numeric(s, i.getOperand(0), i);
    require_set(when, i, "a choice by a value that was never set");
    made = chosen(graph_, when->bits[0], value(s, i.getOperand(1), i), value(s, i.getOperand(2), i));
  } else if (const auto* e = llvm::dyn_cast<llvm::ExtractValueInst>(&i)) {
    ValuePtr v = value(s, e->getAggregateOperand(), i);
    for (const unsigned k : e->indices()) {
      if (v->kind != Value::Kind::parts) throw Unreadable(i, "a part of a value that is no struct");
      v = v->parts[k];
    }
    made = v;
  } else if (const auto* n = llvm::dyn_cast<llvm::InsertValueInst>(&i)) {
    if (n->getNumIndices() != 1) throw Unreadable(i, "a struct within a struct in a register");
    auto v = std::make_shared<Value>(*value(s, n->getAggregateOperand(), i));
    if (v->kind != Value::Kind::parts) throw Unreadable(i, "a part of a value that is no struct");
    v->parts[n->getIndices()[0]] = value(s, n->getInsertedValueOperand(), i);
    made = v;
  } else if (llvm::isa<llvm::FreezeInst>(i)) {
    made = value(s, i.getOperand(0), i);
    require_set(made, i, "a value that was never set");
  } else {
    throw Unreadable(i, std::string("the instruction ") + i.getOpcodeName());
  }
  return true;
}

void Executor::require_no_overflow(const llvm::BinaryOperator& i, const ValuePtr& a, const ValuePtr& b) {
  const std::size_t width = a->bits.size();
  const auto beyond = [&](bool with_sign) {
    const std::size_t wide = i.getOpcode() == I::Mul ? 2 * width : width + 1;
    const Word x = circuit::resized(a->bits, wide, with_sign), y = circuit::resized(b->bits, wide, with_sign);
    const Word whole = i.getOpcode() == I::Add   ? circuit::sum(graph_, x, y)
                       : i.getOpcode() == I::Sub ? circuit::difference(graph_, x, y)
                                                 : circuit::product(graph_, x, y);
    const Word kept =
        circuit::resized(Word(whole.begin(), whole.begin() + static_cast<long>(width)), wide, with_sign);
    return negated(circuit::equal(graph_, whole, kept));
  };
  if (i.getOpcode() == I::Shl) {
    const Word moved = circuit::shifted(graph_, circuit::Shift::left, a->bits, b->bits);
    const auto lost = [&](circuit::Shift back) {
      return negated(circuit::equal(graph_, circuit::shifted(graph_, back, moved, b->bits), a->bits));
    };
    if (i.hasNoSignedWrap())
      require_never(Duty::overflow, lost(circuit::Shift::right_with_sign), i, "a signed shift overflows");
    if (i.hasNoUnsignedWrap())
      require_never(Duty::overflow, lost(circuit::Shift::right), i, "a shift overflows");
    return;
  }
  if (i.hasNoSignedWrap()) require_never(Duty::overflow, beyond(true), i, "signed arithmetic overflows");
  if (i.hasNoUnsignedWrap()) require_never(Duty::overflow, beyond(false), i, "arithmetic overflows");
}

ValuePtr Executor::on_pointers(const llvm::BinaryOperator& i, const ValuePtr& a, const ValuePtr& b) {
  if (i.getOpcode() == I::Add && is_pointer(a) != is_pointer(b))
    return is_pointer(a) ? moved_by(a, b->bits) : moved_by(b, a->bits);
  if (i.getOpcode() == I::Sub && is_pointer(a) && !is_pointer(b))
    return moved_by(a, circuit::difference(graph_, circuit::constant(0, b->bits.size()), b->bits));
  if (i.getOpcode() != I::Sub || !is_pointer(b)) throw Unreadable(i, "arithmetic on a pointer's bits");
  Word distance(a->targets.front().offset.size(), never);
  for (const Target& x : a->targets)
    for (const Target& y : b->targets) {
      const Literal here = graph_.both(x.when, y.when);
      if (here == never) continue;
      if (x.object != y.object || x.object == number_object || x.object == unset_object)
        require_never(Duty::pointers, here, i, "the distance of pointers into different objects");
      else
        distance = circuit::chosen(graph_, here, circuit::difference(graph_, x.offset, y.offset), distance);
    }
  return number(std::move(distance));
}

ValuePtr Executor::binary(State& s, const llvm::BinaryOperator& i) {
  const ValuePtr a = value(s, i.getOperand(0), i), b = value(s, i.getOperand(1), i);
  if (is_pointer(a) || is_pointer(b)) return on_pointers(i, a, b);
  if (i.getType()->isFloatingPointTy()) throw Unreadable(i, "arithmetic of floating-point numbers");
  if (a->kind != Value::Kind::number || b->kind != Value::Kind::number)
    throw Unreadable(i, "arithmetic of vectors");
  Graph& g = graph_;
  if (llvm::isa<llvm::OverflowingBinaryOperator>(i)) require_no_overflow(i, a, b);
  switch (i.getOpcode()) {
    case I::Add: return number(circuit::sum(g, a->bits, b->bits), unset_above(g, *a, *b));
    case I::Sub:
      return number(circuit::sum(g, a->bits, circuit::inverted(b->bits),
                                 planted == Mistake::borrow_lost ? never : always),
                    unset_above(g, *a, *b));
    case I::Mul: return number(circuit::product(g, a->bits, b->bits), unset_above(g, *a, *b));
    case I::And:
      return number(bitwise(a->bits, b->bits, [&](Literal x, Literal y) { return g.both(x, y); }),
                    unset_in_logic(g, *a, *b, true));
    case I::Or:
      return number(bitwise(a->bits, b->bits, [&](Literal x, Literal y) { return g.either(x, y); }),
                    unset_in_logic(g, *a, *b, false));
    case I::Xor:
      return number(
          bitwise(a->bits, b->bits, [&](Literal x, Literal y) { return g.differ(x, y); }),
          bitwise(unset_bits(*a), unset_bits(*b), [&](Literal x, Literal y) { return g.either(x, y); }));
    case I::Shl:
    case I::LShr:
    case I::AShr: return shifted(i, a, b);
    default: return divided(i, a, b);
  }
}

ValuePtr Executor::shifted(const llvm::BinaryOperator& i, const ValuePtr& a, const ValuePtr& b) {
  const circuit::Shift shift = shift_of(i.getOpcode());
  const std::size_t width = a->bits.size();
  require_set(b, i, "a shift by a value that was never set");
  // Seven more bits hold the width itself.
  const Word amount = circuit::resized(b->bits, width + 7, false);
  require_never(Duty::shifts, negated(circuit::less(graph_, amount, circuit::constant(width, width + 7))), i,
                "a shift by the width of the number or more");
  return number(circuit::shifted(graph_, shift, a->bits, b->bits), unset_in_shift(graph_, shift, *a, *b));
}

ValuePtr Executor::divided(const llvm::BinaryOperator& i, const ValuePtr& a, const ValuePtr& b) {
  Graph& g = graph_;
  const std::size_t width = a->bits.size();
  const unsigned op = i.getOpcode();
  const bool with_sign = op == I::SDiv || op == I::SRem;
  require_set(b, i, "a division by a value that was never set");
  require_never(Duty::division, negated(circuit::not_zero(g, b->bits)), i, "a division by zero");
  if (with_sign) {
    const Word lowest = circuit::constant(std::uint64_t{1} << (width - 1), width), minus_one(width, always);
    require_never(Duty::overflow,
                  g.both(circuit::equal(g, a->bits, lowest), circuit::equal(g, b->bits, minus_one)), i,
                  "a signed division overflows");
  }
  const circuit::Division d =
      with_sign ? divided_signed(g, a->bits, b->bits) : circuit::divided(g, a->bits, b->bits);
  if (const auto* exact = llvm::dyn_cast<llvm::PossiblyExactOperator>(&i);
      exact != nullptr && exact->isExact())
    require_never(Duty::division, circuit::not_zero(g, d.remainder), i,
                  "a distance of pointers that is no whole number of elements");
  return number((op == I::UDiv || op == I::SDiv) != (planted == Mistake::remainder_for_quotient)
                    ? d.quotient
                    : d.remainder,
                unset_wholly(g, *a, *b));
}

ValuePtr Executor::compared(State& s, const llvm::ICmpInst& i) {
  const ValuePtr a = value(s, i.getOperand(0), i), b = value(s, i.getOperand(1), i);
  if (is_pointer(a) || is_pointer(b)) {
    if (is_pointer(a) && is_pointer(b)) return compared_pointers(s, i, a, b);
    throw Unreadable(i, "a pointer compared with a number");
  }
  if (a->kind != Value::Kind::number) throw Unreadable(i, "a comparison of vectors");
  return number({compare(graph_, i.getPredicate(), a->bits, b->bits)},
                a->unset.empty() && b->unset.empty() ? Word{} : Word{unset_wholly(graph_, *a, *b)[0]});
}

Literal Executor::in_order(const State& s, Predicate p, const Target& x, const Target& y) {
  const bool less = p == Predicate::ICMP_ULT || p == Predicate::ICMP_ULE;
  const Literal any = graph_.input();
  if (!llvm::CmpInst::isUnsigned(p)) return any;
  if (x.object == null_object || y.object == null_object)
    return less == (x.object == null_object) ? always : never;
  const Object *a = s.memory.find(x.object), *b = s.memory.find(y.object);
  if (a == nullptr || b == nullptr) return any;
  // A place behind an object's last byte may be another's first one, and memory is used again.
  const auto inside = [&](const Object& object, const Word& offset) {
    const Word size =
        object.size.empty() ? circuit::constant(object.cells.size(), pointer_bits) : object.size;
    return graph_.both(negated(object.gone), circuit::less(graph_, offset, size));
  };
  const auto [at, fresh] = orders_.emplace(std::minmax(x.object, y.object), never);
  if (fresh) at->second = graph_.input();
  return graph_.chosen(graph_.both(inside(*a, x.offset), inside(*b, y.offset)),
                       less == (x.object < y.object) ? at->second : negated(at->second), any);
}

ValuePtr Executor::compared_pointers(State& s, const llvm::ICmpInst& i, const ValuePtr& a,
                                     const ValuePtr& b) {
  Literal holds = never;
  for (const Target& x : a->targets)
    for (const Target& y : b->targets) {
      const Literal here = graph_.both(x.when, y.when);
      if (here == never) continue;
      if (x.object == unset_object || y.object == unset_object)
        require_never(Duty::unset, here, i, "a comparison of a pointer that was never set");
      else if (x.object == number_object || y.object == number_object)
        throw Unreadable(i, "a comparison of a pointer that was made of a part of another");
      else if (x.object == y.object)
        holds =
            graph_.either(holds, graph_.both(here, compare(graph_, i.getPredicate(), x.offset, y.offset)));
      else if (!stand_ins_.empty() && x.object > 0 && y.object > 0 &&
               !i.getFunction()->hasFnAttribute(law_attribute))
        // A code's two sequences are one memory there, and two here.
        throw Unreadable(i, "a comparison of pointers into different memory, in a proof by contract");
      else if (i.isEquality())
        holds = graph_.either(holds, i.getPredicate() == Predicate::ICMP_NE ? here : never);
      else if (i.getOperand(0)->getType()->isIntegerTy())
        holds = graph_.either(holds, graph_.both(here, in_order(s, i.getPredicate(), x, y)));
      else
        require_never(Duty::pointers, here, i, "the order of pointers into different objects");
    }
  return number({holds});
}

ValuePtr Executor::cast(State& s, const llvm::CastInst& i) {
  const ValuePtr v = value(s, i.getOperand(0), i);
  const llvm::Type& type = *i.getType();
  switch (i.getOpcode()) {
    case I::PtrToInt:
      if (type.isIntegerTy(64)) return v;
      throw Unreadable(i, "a pointer cut to a number of fewer bits");
    case I::IntToPtr:
      if (is_pointer(v)) return v;
      throw Unreadable(i, "a number taken for a pointer");
    case I::BitCast:
      if (is_pointer(v) || type.isIntegerTy()) return v;
      break;
    case I::Trunc:
    case I::ZExt:
    case I::SExt: {
      if (v->kind != Value::Kind::number || !type.isIntegerTy()) break;
      if (is_pointer(v)) throw Unreadable(i, "a pointer taken for a number");
      const std::size_t width = type.getIntegerBitWidth();
      if (width > 64) throw Unreadable(i, "a number of more than 64 bits");
      const bool with_sign = i.getOpcode() == I::SExt && planted != Mistake::sign_lost;
      return number(circuit::resized(v->bits, width, with_sign),
                    v->unset.empty() ? Word{} : circuit::resized(v->unset, width, with_sign));
    }
    default: break;
  }
  throw Unreadable(i, std::string("the conversion ") + i.getOpcodeName());
}

}  // namespace mmverify::source::executor
