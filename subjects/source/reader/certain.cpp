#include "subjects/source/reader/certain.hpp"

#include <llvm/Analysis/ConstantFolding.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>

#include <set>
#include <vector>

#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

using I = llvm::Instruction;

bool shifts(unsigned opcode) { return opcode == I::Shl || opcode == I::LShr || opcode == I::AShr; }
bool becomes_a_word(unsigned opcode) { return opcode == I::FPToUI || opcode == I::FPToSI; }

/// Whether the operation by `by` is defined for every other operand.
bool is_safe(unsigned opcode, unsigned flags, const llvm::Value* by) {
  const auto* k = llvm::dyn_cast<llvm::ConstantInt>(by);
  if (k == nullptr || flags != 0) return false;
  if (shifts(opcode)) return k->getValue().ult(k->getBitWidth());
  return !k->isZero() && !((opcode == I::SDiv || opcode == I::SRem) && k->isMinusOne());
}

/// Whether an operation on defined values may be undefined.
bool may_be_undefined(const llvm::CallInst& call) {
  const unsigned opcode = word_of(call, 0), detail = word_of(call, 1);
  if (divides(opcode) || shifts(opcode)) return !is_safe(opcode, detail, call.getArgOperand(3));
  if (opcode == I::Call) {
    const bool flagged =
        detail == llvm::Intrinsic::ctlz || detail == llvm::Intrinsic::cttz || detail == llvm::Intrinsic::abs;
    return flagged && !llvm::cast<llvm::ConstantInt>(call.getArgOperand(3))->isZero();
  }
  return becomes_a_word(opcode);
}

/// The integer of a constant float; null if it is none or does not fit.
llvm::Value* word_of_float(const llvm::CallInst& call) {
  const auto* x = llvm::dyn_cast<llvm::ConstantFP>(call.getArgOperand(2));
  if (x == nullptr) return nullptr;
  llvm::APSInt whole(call.getType()->getIntegerBitWidth(), word_of(call, 0) == I::FPToUI);
  bool same = false;
  if (x->getValueAPF().convertToInteger(whole, llvm::APFloat::rmTowardZero, &same) ==
      llvm::APFloat::opInvalidOp)
    return nullptr;
  return llvm::ConstantInt::get(call.getType(), whole);
}

/// The call of an LLVM intrinsic again. Known intrinsics have one type, or the types of the result and an
/// operand.
llvm::Value* intrinsic_again(llvm::IRBuilder<>& build, llvm::CallInst& call,
                             const std::vector<llvm::Value*>& of) {
  const auto id = static_cast<llvm::Intrinsic::ID>(word_of(call, 1));
  std::vector<llvm::Type*> types{of[0]->getType()}, takes;
  if (id == llvm::Intrinsic::fptoui_sat || id == llvm::Intrinsic::fptosi_sat)
    types.insert(types.begin(), call.getType());
  for (const llvm::Value* v : of) takes.push_back(v->getType());
  if (!llvm::Intrinsic::isOverloaded(id)) types.clear();
  llvm::Function* f = llvm::Intrinsic::getDeclaration(call.getModule(), id, types);
  if (f->getFunctionType() != llvm::FunctionType::get(call.getType(), takes, false)) return nullptr;
  return build.CreateCall(f, of);
}

/// The instruction that a guarded call stands for; null if it stays a call.
llvm::Value* plain(llvm::CallInst& call) {
  llvm::IRBuilder<> build(&call);
  const unsigned opcode = word_of(call, 0), detail = word_of(call, 1);
  const std::vector<llvm::Value*> of(call.arg_begin() + 2, call.arg_end());
  switch (opcode) {
    case I::Load:
    case I::Freeze: return of[0];
    case I::FNeg: return build.CreateFNeg(of[0]);
    case I::ICmp:
    case I::FCmp: return build.CreateCmp(static_cast<llvm::CmpInst::Predicate>(detail), of[0], of[1]);
    case I::Select: return build.CreateSelect(of[0], of[1], of[2]);
    case I::Call: return intrinsic_again(build, call, of);
    default:
      if (I::isBinaryOp(opcode)) return build.CreateBinOp(static_cast<I::BinaryOps>(opcode), of[0], of[1]);
      return build.CreateCast(static_cast<I::CastOps>(opcode), of[0], call.getType());
  }
}

/// The table of a pointer with constant steps within the table's rows; null if there is none.
const llvm::GlobalVariable* table_at(const llvm::Value* pointer, const llvm::DataLayout& layout,
                                     llvm::APInt& offset) {
  for (;; pointer = llvm::cast<llvm::User>(pointer)->getOperand(0)) {
    if (const auto* table = llvm::dyn_cast<llvm::GlobalVariable>(pointer)) return table;
    if (const auto* call = llvm::dyn_cast<llvm::CallInst>(pointer)) {
      if (guarded(*call) != Guarded::address) return nullptr;
    } else if (const auto* step = llvm::dyn_cast<llvm::GEPOperator>(pointer)) {
      if (!step->accumulateConstantOffset(layout, offset)) return nullptr;
      const llvm::Type* inside = nullptr;
      for (auto part = llvm::gep_type_begin(step); part != llvm::gep_type_end(step); ++part) {
        const auto& k = llvm::cast<llvm::ConstantInt>(part.getOperand())->getValue();
        if (inside != nullptr && inside->isArrayTy() && k.uge(inside->getArrayNumElements())) return nullptr;
        inside = part.getIndexedType();
      }
    } else if (!llvm::isa<llvm::BitCastOperator>(pointer)) {
      return nullptr;
    }
  }
}

/// A constant table's element at a constant offset; null for another load.
llvm::Constant* looked_up(const llvm::LoadInst& load) {
  const llvm::DataLayout& layout = load.getModule()->getDataLayout();
  llvm::APInt offset(64, 0);
  const llvm::GlobalVariable* table = table_at(load.getPointerOperand(), layout, offset);
  if (table == nullptr || !load.isSimple() || !table->isConstant() || !table->hasDefinitiveInitializer())
    return nullptr;
  const std::uint64_t size = layout.getTypeAllocSize(table->getValueType()),
                      read = layout.getTypeStoreSize(load.getType());
  if (read > size || offset.ugt(size - read)) return nullptr;
  auto* found = llvm::ConstantFoldLoadFromConst(const_cast<llvm::Constant*>(table->getInitializer()),
                                                load.getType(), offset, layout);
  return found == nullptr || found->containsUndefOrPoisonElement() || llvm::isa<llvm::UndefValue>(found)
             ? nullptr
             : found;
}

/// Whether an instruction may introduce an undefined value.
bool is_source(const I& at) {
  for (const llvm::Value* v : at.operand_values())
    if (llvm::isa<llvm::UndefValue>(v)) return true;
  if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&at)) {
    const Guarded what = guarded(*call);
    if (what == Guarded::operation) return may_be_undefined(*call);
    return what != Guarded::address && !call->getType()->isVoidTy() &&
           call->getIntrinsicID() == llvm::Intrinsic::not_intrinsic;
  }
  const auto* load = llvm::dyn_cast<llvm::LoadInst>(&at);
  if (load == nullptr) return false;
  // Memory that is written: passes will turn it into values.
  const llvm::Value* from = load->getPointerOperand();
  while (llvm::isa<llvm::GEPOperator>(from) || llvm::isa<llvm::BitCastOperator>(from))
    from = llvm::cast<llvm::User>(from)->getOperand(0);
  const auto* call = llvm::dyn_cast<llvm::CallInst>(from);
  return call == nullptr || guarded(*call) != Guarded::address;
}

/// All instructions that an undefined value may reach through operands.
std::set<const I*> open_in(const llvm::Function& f) {
  std::set<const I*> all;
  std::vector<const I*> next;
  for (const I& at : llvm::instructions(f))
    if (is_source(at)) next.push_back(&at);
  while (!next.empty()) {
    const I* at = next.back();
    next.pop_back();
    if (!all.insert(at).second) continue;
    for (const llvm::User* user : at->users())
      if (const auto* i = llvm::dyn_cast<I>(user)) next.push_back(i);
  }
  return all;
}

/// The replacement of an instruction that is certain; the instruction itself if it can be removed; null if it
/// stays.
llvm::Value* settled(I& at, const std::set<const I*>& open) {
  if (const auto* load = llvm::dyn_cast<llvm::LoadInst>(&at)) return looked_up(*load);
  auto* call = llvm::dyn_cast<llvm::CallInst>(&at);
  if (call == nullptr) return nullptr;
  switch (guarded(*call)) {
    case Guarded::operation:
      if (open.count(call) == 0) return plain(*call);
      return becomes_a_word(word_of(*call, 0)) ? word_of_float(*call) : nullptr;
    case Guarded::unset:
    case Guarded::address: return call->use_empty() ? call : nullptr;
    case Guarded::argument:
    case Guarded::branch: {
      const llvm::Value* on = call->getArgOperand(0);
      const auto* i = llvm::dyn_cast<I>(on);
      return llvm::isa<llvm::UndefValue>(on) || (i != nullptr && open.count(i) != 0) ? nullptr : call;
    }
    case Guarded::outside: {
      const auto* k = llvm::dyn_cast<llvm::ConstantInt>(call->getArgOperand(0));
      return k != nullptr && k->isZero() ? call : nullptr;
    }
    default: return nullptr;
  }
}

/// Settles every instruction once; returns whether any was settled, since that may settle more.
bool once(llvm::Function& f) {
  const std::set<const I*> open = open_in(f);
  std::vector<I*> all;
  for (I& at : llvm::instructions(f)) all.push_back(&at);
  bool any = false;
  for (I* at : all) {
    llvm::Value* by = settled(*at, open);
    if (by == nullptr) continue;
    if (by != at) at->replaceAllUsesWith(by);
    at->eraseFromParent();
    any = true;
  }
  return any;
}

}  // namespace

void make_certain_plain(llvm::Function& function) {
  while (once(function)) {
  }
}

}  // namespace mmverify::source
