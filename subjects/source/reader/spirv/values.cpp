#include "subjects/source/reader/spirv/values.hpp"

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/spirv/decorations.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {

using I = llvm::Intrinsic::IndependentIntrinsics;

/// The value of an id. OpUndef gives a new opaque value at each use, so that no builder or pass can fold it.
Scalars Values::value(Id id) {
  Scalars all = constant_or_value(id);
  for (llvm::Value*& v : all)
    if (llvm::isa<llvm::UndefValue>(v) && !v->getType()->isPointerTy()) v = never_set(build_, v->getType());
  return all;
}

Scalars Values::constant_or_value(Id id) const {
  if (const auto known = values_.find(id); known != values_.end()) return known->second;
  if (types_.is_constant(id)) return types_.constant(id);
  const auto outside = module_.globals.find(id);
  if (outside == module_.globals.end() || outside->second.opcode != spv::Variable)
    invalid("there is no value " + std::to_string(id));
  const auto name = module_.names.find(id);
  throw NotKnown("memory that is no constant table: " + (name != module_.names.end() && !name->second.empty()
                                                             ? name->second
                                                             : "a variable outside of functions"));
}

Id Values::type_of(Id id) const {
  const auto known = kinds_.find(id);
  return known != kinds_.end() ? known->second : types_.global(id).type;
}

llvm::Value* Values::one(Id id) {
  const Scalars all = value(id);
  if (all.size() != 1) invalid("a scalar is due");
  return all[0];
}
llvm::Value* Values::word(Id id) {
  const Scalars all = checked(id, Sort::words);
  if (all.size() != 1) invalid("a scalar is due");
  return all[0];
}
llvm::Value* Values::number(Id id) {
  const Scalars all = checked(id, Sort::floats);
  if (all.size() != 1) invalid("a scalar is due");
  return all[0];
}

void Values::set(const Instruction& i, Scalars all) { set(i.result, i.type, std::move(all)); }
void Values::set(Id id, Id type, Scalars all) {
  if (all.size() != (types_.is_pointer(type) ? 1 : types_.scalars(type)))
    invalid("a result of another count of parts");
  values_[id] = std::move(all);
  kinds_[id] = type;
}

Scalars Values::checked(Id id, Sort sort) {
  Scalars all = value(id);
  for (const llvm::Value* v : all)
    if (sort == Sort::floats ? !v->getType()->isFloatingPointTy() : !v->getType()->isIntegerTy())
      invalid("a value is of another type");
  return all;
}

void Values::each(const Instruction& i, std::size_t at, Sort sort, const Unary& make) {
  Scalars all = checked(operand(i, at), sort);
  for (llvm::Value*& v : all) v = make(v);
  set(i, std::move(all));
}

void Values::pairs(const Instruction& i, std::size_t at, Sort sort, const Binary& make) {
  Scalars a = checked(operand(i, at), sort);
  const Scalars b = checked(operand(i, at + 1), sort);
  if (a.size() != b.size()) invalid("operands of different sizes");
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k]->getType() != b[k]->getType()) invalid("operands of different types");
    a[k] = make(a[k], b[k]);
  }
  set(i, std::move(a));
}

/// Shifts; the amount may have another width.
void Values::shifts(const Instruction& i, llvm::Instruction::BinaryOps how) {
  Scalars a = checked(operand(i, 0), Sort::words);
  const Scalars by = checked(operand(i, 1), Sort::words);
  if (a.size() != by.size()) invalid("operands of different sizes");
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (by[k]->getType()->getIntegerBitWidth() > a[k]->getType()->getIntegerBitWidth())
      throw NotKnown("a shift of a narrow word by a wide one");
    llvm::Value* amount = build_.CreateZExt(by[k], a[k]->getType());
    if (module_.shifts_wrap)
      amount = build_.CreateAnd(amount, whole(amount, a[k]->getType()->getIntegerBitWidth() - 1));
    a[k] = build_.CreateBinOp(how, a[k], amount);
  }
  set(i, std::move(a));
}

/// An operation on words. One that is decorated not to wrap is no constant, even of constants: it is undefined
/// where it wraps.
llvm::Value* Values::of_words(const Instruction& i, llvm::Instruction::BinaryOps how, llvm::Value* a,
                              llvm::Value* b) {
  const unsigned flags = wrap_flags(module_, i.result);
  if (flags == 0) return build_.CreateBinOp(how, a, b);
  auto* made = llvm::BinaryOperator::Create(how, a, b);
  made->setHasNoUnsignedWrap((flags & no_unsigned_wrap) != 0);
  made->setHasNoSignedWrap((flags & no_signed_wrap) != 0);
  return build_.Insert(made);
}

bool Values::arithmetic(const Instruction& i) {
  using P = llvm::CmpInst::Predicate;
  using O = llvm::Instruction::BinaryOps;
  static const std::map<std::uint16_t, O> word_operations{
      {spv::IAdd, O::Add},     {spv::ISub, O::Sub},       {spv::IMul, O::Mul},
      {spv::UDiv, O::UDiv},    {spv::SDiv, O::SDiv},      {spv::UMod, O::URem},
      {spv::BitwiseOr, O::Or}, {spv::BitwiseXor, O::Xor}, {spv::BitwiseAnd, O::And},
      {spv::LogicalOr, O::Or}, {spv::LogicalAnd, O::And}, {spv::LogicalNotEqual, O::Xor}};
  static const std::map<std::uint16_t, O> shifted{{spv::ShiftRightLogical, O::LShr},
                                                  {spv::ShiftRightArithmetic, O::AShr},
                                                  {spv::ShiftLeftLogical, O::Shl}};
  static const std::map<std::uint16_t, O> of_floats{
      {spv::FAdd, O::FAdd}, {spv::FSub, O::FSub}, {spv::FMul, O::FMul}};
  static const std::map<std::uint16_t, P> word_comparisons{{spv::IEqual, P::ICMP_EQ},
                                                           {spv::LogicalEqual, P::ICMP_EQ},
                                                           {spv::INotEqual, P::ICMP_NE},
                                                           {spv::UGreaterThan, P::ICMP_UGT},
                                                           {spv::SGreaterThan, P::ICMP_SGT},
                                                           {spv::UGreaterThanEqual, P::ICMP_UGE},
                                                           {spv::SGreaterThanEqual, P::ICMP_SGE},
                                                           {spv::ULessThan, P::ICMP_ULT},
                                                           {spv::SLessThan, P::ICMP_SLT},
                                                           {spv::ULessThanEqual, P::ICMP_ULE},
                                                           {spv::SLessThanEqual, P::ICMP_SLE}};
  static const std::map<std::uint16_t, P> float_comparisons{{spv::FOrdEqual, P::FCMP_OEQ},
                                                            {spv::FUnordEqual, P::FCMP_UEQ},
                                                            {spv::FOrdNotEqual, P::FCMP_ONE},
                                                            {spv::FUnordNotEqual, P::FCMP_UNE},
                                                            {spv::FOrdLessThan, P::FCMP_OLT},
                                                            {spv::FUnordLessThan, P::FCMP_ULT},
                                                            {spv::FOrdGreaterThan, P::FCMP_OGT},
                                                            {spv::FUnordGreaterThan, P::FCMP_UGT},
                                                            {spv::FOrdLessThanEqual, P::FCMP_OLE},
                                                            {spv::FUnordLessThanEqual, P::FCMP_ULE},
                                                            {spv::FOrdGreaterThanEqual, P::FCMP_OGE},
                                                            {spv::FUnordGreaterThanEqual, P::FCMP_UGE}};
  if (const auto f = word_operations.find(i.opcode); f != word_operations.end()) {
    pairs(i, 0, Sort::words, [&](auto* a, auto* b) { return of_words(i, f->second, a, b); });
  } else if (const auto f = of_floats.find(i.opcode); f != of_floats.end()) {
    pairs(i, 0, Sort::floats, [&](auto* a, auto* b) { return build_.CreateBinOp(f->second, a, b); });
  } else if (const auto f = shifted.find(i.opcode); f != shifted.end()) {
    shifts(i, f->second);
  } else if (const auto f = word_comparisons.find(i.opcode); f != word_comparisons.end()) {
    pairs(i, 0, Sort::words, [&](auto* a, auto* b) { return build_.CreateICmp(f->second, a, b); });
  } else if (const auto f = float_comparisons.find(i.opcode); f != float_comparisons.end()) {
    pairs(i, 0, Sort::floats, [&](auto* a, auto* b) { return build_.CreateFCmp(f->second, a, b); });
  } else {
    return false;
  }
  return true;
}

llvm::Type* Values::scalar_type(Id type) const {
  while (types_.parts(type) != 0) type = types_.part(type, 0);
  return types_.llvm_type(type);
}

bool Values::conversion(const Instruction& i) {
  using C = llvm::Instruction::CastOps;
  static const std::map<std::uint16_t, std::pair<C, Sort>> casts{
      {spv::ConvertFToU, {C::FPToUI, Sort::floats}},
      {spv::ConvertFToS, {C::FPToSI, Sort::floats}},
      {spv::ConvertSToF, {C::SIToFP, Sort::words}},
      {spv::ConvertUToF, {C::UIToFP, Sort::words}}};
  const bool is_cast = casts.count(i.opcode) != 0;
  if (!is_cast && i.opcode != spv::UConvert && i.opcode != spv::SConvert && i.opcode != spv::FConvert &&
      i.opcode != spv::Bitcast)
    return false;
  llvm::Type* to = scalar_type(i.type);
  if (is_cast) {
    auto [how, from] = casts.at(i.opcode);
    if (planted_ == Planted::signed_numbers && how == C::UIToFP) how = C::SIToFP;
    if (from == Sort::floats ? !to->isIntegerTy() : !to->isFloatingPointTy())
      invalid("a conversion to another type");
    each(i, 0, from, [&, how = how](auto* a) { return build_.CreateCast(how, a, to); });
  } else if (i.opcode == spv::Bitcast) {
    Scalars all = value(operand(i, 0));
    for (llvm::Value*& v : all) {
      if (v->getType()->getPrimitiveSizeInBits() != to->getPrimitiveSizeInBits())
        throw NotKnown("OpBitcast between numbers of different sizes");
      v = build_.CreateBitCast(v, to);
    }
    set(i, std::move(all));
  } else if (i.opcode == spv::FConvert) {
    if (!to->isFloatingPointTy()) invalid("a conversion to another type");
    each(i, 0, Sort::floats, [&](auto* a) { return build_.CreateFPCast(a, to); });
  } else {
    if (!to->isIntegerTy()) invalid("a conversion to another type");
    each(i, 0, Sort::words, [&](auto* a) {
      return i.opcode == spv::SConvert ? build_.CreateSExtOrTrunc(a, to) : build_.CreateZExtOrTrunc(a, to);
    });
  }
  return true;
}

/// The number of scalars before a part of a value; sets `type` to the part's type.
std::size_t Values::place(Id& type, const Instruction& i, std::size_t from) const {
  std::size_t at = 0;
  for (std::size_t k = from; k < i.operands.size(); ++k) {
    const std::uint32_t index = i.operands[k];
    if (index >= types_.parts(type)) invalid("there is no such part of a value");
    for (std::uint32_t before = 0; before < index; ++before) at += types_.scalars(types_.part(type, before));
    type = types_.part(type, index);
  }
  return at;
}

void Values::extract(const Instruction& i) {
  const Scalars all = value(operand(i, 0));
  Id type = type_of(operand(i, 0));
  const std::size_t at = place(type, i, 1), count = types_.scalars(type);
  if (at + count > all.size()) invalid("there is no such part of a value");
  const auto from = all.begin() + static_cast<std::ptrdiff_t>(at);
  set(i, Scalars(from, from + static_cast<std::ptrdiff_t>(count)));
}

void Values::insert(const Instruction& i) {
  const Scalars part = value(operand(i, 0));
  Scalars all = value(operand(i, 1));
  Id type = type_of(operand(i, 1));
  const std::size_t at = place(type, i, 2);
  if (at + part.size() > all.size()) invalid("there is no such part of a value");
  std::copy(part.begin(), part.end(), all.begin() + static_cast<std::ptrdiff_t>(at));
  set(i, std::move(all));
}

void Values::shuffle(const Instruction& i) {
  Scalars both = value(operand(i, 0));
  append(both, value(operand(i, 1)));
  Scalars all;
  for (std::size_t k = 2; k < i.operands.size(); ++k) {
    std::uint32_t from = i.operands[k];
    if (planted_ == Planted::shuffled_otherwise && from == 1) from = 0;
    if (from != 0xffffffff && from >= both.size()) invalid("there is no such component");
    all.push_back(from == 0xffffffff ? never_set(build_, both.at(0)->getType()) : both[from]);
  }
  set(i, std::move(all));
}

void Values::select(const Instruction& i) {
  const Scalars yes = value(operand(i, 0)), a = value(operand(i, 1)), b = value(operand(i, 2));
  if (a.size() != b.size() || (yes.size() != 1 && yes.size() != a.size()))
    invalid("operands of different sizes");
  Scalars all;
  for (std::size_t k = 0; k < a.size(); ++k) {
    llvm::Value* condition = yes[yes.size() == 1 ? 0 : k];
    if (a[k]->getType() != b[k]->getType() || !condition->getType()->isIntegerTy(1))
      invalid("operands of different types");
    all.push_back(build_.CreateSelect(condition, a[k], b[k]));
  }
  set(i, std::move(all));
}

bool Values::composite(const Instruction& i) {
  switch (i.opcode) {
    case spv::CompositeConstruct: {
      Scalars all;
      for (const Id part : i.operands) {
        append(all, value(part));
      }
      set(i, std::move(all));
      return true;
    }
    case spv::CompositeExtract: return extract(i), true;
    case spv::CompositeInsert: return insert(i), true;
    case spv::VectorShuffle: return shuffle(i), true;
    case spv::VectorExtractDynamic: {
      const Scalars all = value(operand(i, 0));
      llvm::Value* index = word(operand(i, 1));
      llvm::Value* found = llvm::PoisonValue::get(all.at(0)->getType());
      for (std::size_t k = 0; k < all.size(); ++k)
        found = build_.CreateSelect(build_.CreateICmpEQ(index, whole(index, k)), all[k], found);
      set(i, {found});
      return true;
    }
    case spv::VectorTimesScalar: {
      llvm::Value* by = number(operand(i, 1));
      each(i, 0, Sort::floats, [&](auto* a) { return build_.CreateFMul(a, by); });
      return true;
    }
    case spv::Any:
    case spv::All: {
      const Scalars all = checked(operand(i, 0), Sort::words);
      llvm::Value* sum = all.at(0);
      for (std::size_t k = 1; k < all.size(); ++k)
        sum = i.opcode == spv::Any ? build_.CreateOr(sum, all[k]) : build_.CreateAnd(sum, all[k]);
      set(i, {sum});
      return true;
    }
    case spv::Select: return select(i), true;
    default: return false;
  }
}

bool Values::of_bits(const Instruction& i) {
  switch (i.opcode) {
    case spv::SNegate:
      each(i, 0, Sort::words, [&](auto* a) { return of_words(i, llvm::Instruction::Sub, whole(a, 0), a); });
      return true;
    case spv::FNegate: return each(i, 0, Sort::floats, [&](auto* a) { return build_.CreateFNeg(a); }), true;
    case spv::LogicalNot:
    case spv::Not: return each(i, 0, Sort::words, [&](auto* a) { return build_.CreateNot(a); }), true;
    case spv::IsNan:
      return each(i, 0, Sort::floats, [&](auto* a) { return build_.CreateFCmpUNO(a, a); }), true;
    case spv::IsInf:
      each(i, 0, Sort::floats, [&](auto* a) {
        return build_.CreateFCmpOEQ(of_one(I::fabs, a), llvm::ConstantFP::getInfinity(a->getType()));
      });
      return true;
    case spv::BitReverse:
      return each(i, 0, Sort::words, [&](auto* a) { return of_one(I::bitreverse, a); }), true;
    case spv::BitCount: return each(i, 0, Sort::words, [&](auto* a) { return of_one(I::ctpop, a); }), true;
    case spv::SRem:
    case spv::SMod:
      // Vulkan leaves negative operands open; for others, signed and unsigned remainders agree.
      pairs(i, 0, Sort::words, [&](auto* a, auto* b) {
        llvm::Value* negative = build_.CreateICmpSLT(build_.CreateOr(a, b), whole(a, 0));
        return unless(negative, build_.CreateSRem(a, b));
      });
      return true;
    case spv::BitFieldInsert:
    case spv::BitFieldSExtract:
    case spv::BitFieldUExtract: return field(i), true;
    default: return false;
  }
}

/// Extracts or inserts bits offset..offset+count-1: undefined beyond the word, no bits if count is 0.
void Values::field(const Instruction& i) {
  const bool inserts = i.opcode == spv::BitFieldInsert;
  const std::size_t at = inserts ? 2 : 1;
  llvm::Value *offset = word(operand(i, at)), *count = word(operand(i, at + 1));
  Scalars all = checked(operand(i, 0), Sort::words);
  const Scalars put = inserts ? checked(operand(i, 1), Sort::words) : all;
  if (put.size() != all.size()) invalid("operands of different sizes");
  for (std::size_t k = 0; k < all.size(); ++k) {
    llvm::Type* type = all[k]->getType();
    if (offset->getType() != type || count->getType() != type) throw NotKnown("a bit field by other words");
    const auto width = type->getIntegerBitWidth();
    llvm::Value* beyond =
        build_.CreateOr(build_.CreateICmpUGT(count, whole(count, width)),
                        build_.CreateICmpUGT(offset, build_.CreateSub(whole(count, width), count)));
    llvm::Value *none = build_.CreateICmpEQ(count, whole(count, 0)),
                *rest = build_.CreateSub(whole(count, width), count);
    // A shift by the whole width is poison, so count 0 shifts by 0; its result is not selected.
    llvm::Value* safe = build_.CreateSelect(none, whole(rest, 0), rest);
    if (inserts) {
      llvm::Value* mask =
          build_.CreateShl(build_.CreateLShr(llvm::Constant::getAllOnesValue(type), safe), offset);
      llvm::Value* with = build_.CreateOr(build_.CreateAnd(all[k], build_.CreateNot(mask)),
                                          build_.CreateAnd(build_.CreateShl(put[k], offset), mask));
      all[k] = unless(beyond, build_.CreateSelect(none, all[k], with));
    } else {
      llvm::Value* left = build_.CreateShl(all[k], build_.CreateSub(safe, offset));
      llvm::Value* found =
          i.opcode == spv::BitFieldSExtract ? build_.CreateAShr(left, safe) : build_.CreateLShr(left, safe);
      all[k] = unless(beyond, build_.CreateSelect(none, whole(all[k], 0), found));
    }
  }
  set(i, std::move(all));
}

}  // namespace mmverify::source
