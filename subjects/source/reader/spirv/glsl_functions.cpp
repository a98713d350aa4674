// GLSL.std.450: the built-in functions of shading languages.
#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/spirv/names.hpp"
#include "subjects/source/reader/spirv/values.hpp"

namespace mmverify::source {

using I = llvm::Intrinsic::IndependentIntrinsics;

/// Clamps values. `orders`: NaN is ordered, so its result is defined; otherwise that is open. So is the
/// result for a range with its ends in the wrong order.
void Values::clamp(const Instruction& i, Sort sort, llvm::Intrinsic::ID most, llvm::Intrinsic::ID least,
                   bool orders) {
  Scalars all = checked(operand(i, 2), sort);
  const Scalars low = checked(operand(i, 3), sort), high = checked(operand(i, 4), sort);
  if (low.size() != all.size() || high.size() != all.size()) invalid("operands of different sizes");
  for (std::size_t k = 0; k < all.size(); ++k) {
    llvm::Value *x = all[k], *a = low[k], *b = high[k];
    if (x->getType() != a->getType() || x->getType() != b->getType()) invalid("operands of different types");
    llvm::Value* clamped = planted_ == Planted::clamped_above_alone ? x : of_two(most, x, a);
    clamped = of_two(least, clamped, b);
    if (!orders) clamped = unless(build_.CreateFCmpUNO(x, x), clamped);
    all[k] = unless(sort == Sort::floats ? build_.CreateNot(build_.CreateFCmpOLE(a, b))
                    : most == I::umax    ? build_.CreateICmpUGT(a, b)
                                         : build_.CreateICmpSGT(a, b),
                    clamped);
  }
  set(i, std::move(all));
}

/// The number of the lowest or highest set bit; all ones if there is none.
void Values::first_bit(const Instruction& i, std::uint32_t which) {
  each(i, 2, Sort::words, [&](auto* a) {
    const auto top = a->getType()->getIntegerBitWidth() - 1;
    if (which == spv::FindILsb || planted_ == Planted::lowest_for_highest)
      return build_.CreateSelect(build_.CreateICmpEQ(a, whole(a, 0)),
                                 llvm::Constant::getAllOnesValue(a->getType()),
                                 of_two(I::cttz, a, build_.getFalse()));
    llvm::Value* of = which == spv::FindSMsb ? build_.CreateXor(a, build_.CreateAShr(a, whole(a, top))) : a;
    // 0 has top + 1 leading zeros: the difference is -1.
    return build_.CreateSub(whole(of, top), of_two(I::ctlz, of, build_.getFalse()));
  });
}

llvm::Value* Values::sign_of_float(llvm::Value* a) {
  llvm::Value *zero = llvm::ConstantFP::get(a->getType(), 0), *up = llvm::ConstantFP::get(a->getType(), 1),
              *down = llvm::ConstantFP::get(a->getType(), -1);
  return build_.CreateSelect(build_.CreateFCmpOLT(a, zero), down,
                             build_.CreateSelect(build_.CreateFCmpOGT(a, zero), up, zero));
}

llvm::Value* Values::sign_of_word(llvm::Value* a) {
  llvm::Value* up = build_.CreateZExt(build_.CreateICmpSGT(a, whole(a, 0)), a->getType());
  return build_.CreateSelect(build_.CreateICmpSLT(a, whole(a, 0)),
                             llvm::Constant::getAllOnesValue(a->getType()), up);
}

void Values::extended(const Instruction& i) {
  const auto named = module_.sets.find(operand(i, 0));
  const std::string set_name = named != module_.sets.end() ? named->second : "";
  if (set_name.rfind("NonSemantic.", 0) == 0) return;
  const std::uint32_t which = operand(i, 1);
  if (set_name != "GLSL.std.450") throw NotKnown("OpExtInst of " + set_name);
  using How = std::pair<llvm::Intrinsic::ID, Sort>;
  static const std::map<std::uint32_t, How> unary{{spv::RoundEven, {I::roundeven, Sort::floats}},
                                                  {spv::Trunc, {I::trunc, Sort::floats}},
                                                  {spv::FAbs, {I::fabs, Sort::floats}},
                                                  {spv::Floor, {I::floor, Sort::floats}},
                                                  {spv::Ceil, {I::ceil, Sort::floats}}};
  static const std::map<std::uint32_t, How> binary{
      {spv::NMin, {I::minnum, Sort::floats}}, {spv::NMax, {I::maxnum, Sort::floats}},
      {spv::UMin, {I::umin, Sort::words}},    {spv::UMax, {I::umax, Sort::words}},
      {spv::SMin, {I::smin, Sort::words}},    {spv::SMax, {I::smax, Sort::words}}};
  if (const auto f = unary.find(which); f != unary.end())
    return each(i, 2, f->second.second, [&](auto* a) { return of_one(f->second.first, a); });
  if (const auto f = binary.find(which); f != binary.end())
    return pairs(i, 2, f->second.second, [&](auto* a, auto* b) { return of_two(f->second.first, a, b); });
  switch (which) {
    case spv::FMin:
    case spv::FMax:
      // If an operand is NaN, SPIR-V leaves open which one is the result.
      return pairs(i, 2, Sort::floats, [&](auto* a, auto* b) {
        return unless(build_.CreateFCmpUNO(a, b), of_two(which == spv::FMin ? I::minnum : I::maxnum, a, b));
      });
    case spv::FClamp: return clamp(i, Sort::floats, I::maxnum, I::minnum, false);
    case spv::NClamp: return clamp(i, Sort::floats, I::maxnum, I::minnum, true);
    case spv::UClamp: return clamp(i, Sort::words, I::umax, I::umin, true);
    case spv::SClamp: return clamp(i, Sort::words, I::smax, I::smin, true);
    case spv::Fract:
      return each(i, 2, Sort::floats, [&](auto* a) { return build_.CreateFSub(a, of_one(I::floor, a)); });
    case spv::SAbs:
      return each(i, 2, Sort::words, [&](auto* a) { return of_two(I::abs, a, build_.getFalse()); });
    case spv::FSign: return each(i, 2, Sort::floats, [&](auto* a) { return sign_of_float(a); });
    case spv::SSign: return each(i, 2, Sort::words, [&](auto* a) { return sign_of_word(a); });
    case spv::Step:
      return pairs(i, 2, Sort::floats, [&](auto* edge, auto* x) {
        return build_.CreateSelect(build_.CreateFCmpOLT(x, edge), llvm::ConstantFP::get(x->getType(), 0),
                                   llvm::ConstantFP::get(x->getType(), 1));
      });
    case spv::FindILsb:
    case spv::FindUMsb:
    case spv::FindSMsb: return first_bit(i, which);
    default: throw NotKnown(extended_name(which) + " of GLSL.std.450");
  }
}

}  // namespace mmverify::source
