#include "source/reader/accesses.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>

#include <vector>

#include "source/reader/module.hpp"
#include "source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

using I = llvm::Instruction;

class Access {
 public:
  explicit Access(I& at) : build_(&at), layout_(at.getModule()->getDataLayout()) {}

  /// Whether `bytes` bytes at the pointer, of a variable, are not all in it, or in another row than is said.
  llvm::Value* lies_outside(llvm::Value* pointer, llvm::Value* bytes) {
    llvm::Value *offset = build_.getInt64(0), *any = build_.getFalse();
    while (!llvm::isa<llvm::AllocaInst>(pointer)) {
      if (auto* step = llvm::dyn_cast<llvm::GEPOperator>(pointer))
        offset = build_.CreateAdd(offset, moved(*step, any));
      else if (!llvm::isa<llvm::BitCastOperator>(pointer))
        return build_.getFalse();  // of no variable, or of one of several
      pointer = llvm::cast<llvm::User>(pointer)->getOperand(0);
    }
    const auto size = llvm::cast<llvm::AllocaInst>(pointer)->getAllocationSizeInBits(layout_);
    if (!size || size->isScalable()) return build_.getFalse();
    llvm::Value* whole = build_.getInt64(size->getFixedSize() / 8);
    llvm::Value* last = build_.CreateSub(whole, bytes);
    llvm::Value* beyond =
        build_.CreateOr(build_.CreateICmpUGT(bytes, whole), build_.CreateICmpUGT(offset, last));
    return build_.CreateOr(any, beyond);
  }
  llvm::IRBuilder<>& build() { return build_; }

 private:
  /// Bytes; `any`: or whether a place is none of its row.
  llvm::Value* moved(llvm::GEPOperator& step, llvm::Value*& any) {
    llvm::Value* sum = build_.getInt64(0);
    const llvm::Type* inside = nullptr;
    for (auto part = llvm::gep_type_begin(step); part != llvm::gep_type_end(step); ++part) {
      if (llvm::StructType* record = part.getStructTypeOrNull()) {
        const auto field = llvm::cast<llvm::ConstantInt>(part.getOperand())->getZExtValue();
        sum = build_.CreateAdd(
            sum,
            build_.getInt64(layout_.getStructLayout(record)->getElementOffset(static_cast<unsigned>(field))));
      } else {
        llvm::Value* k = build_.CreateSExtOrTrunc(part.getOperand(), build_.getInt64Ty());
        if (inside != nullptr && inside->isArrayTy())
          any = build_.CreateOr(any, build_.CreateICmpUGE(k, build_.getInt64(inside->getArrayNumElements())));
        sum = build_.CreateAdd(
            sum, build_.CreateMul(k, build_.getInt64(layout_.getTypeAllocSize(part.getIndexedType()))));
      }
      inside = part.getIndexedType();
    }
    return sum;
  }

  llvm::IRBuilder<> build_;
  const llvm::DataLayout& layout_;
};

bool holds_pointers(const llvm::Type* type) {
  if (type->isPointerTy()) return true;
  for (const llvm::Type* part : type->subtypes())
    if (holds_pointers(part)) return true;
  return false;
}

/// A variable of one number that is read or written as a number of another kind, by a pointer to such: C forbids it, the
/// compiled code may go on with the old number.
void check_alias(const I& at, const llvm::Value* pointer, const llvm::Type* as) {
  const auto* variable = llvm::dyn_cast<llvm::AllocaInst>(pointer->stripPointerCasts());
  const llvm::MDNode* tag = at.getMetadata(llvm::LLVMContext::MD_tbaa);
  if (variable == nullptr || tag == nullptr || tag->getNumOperands() < 2) return;
  const llvm::Type* is = variable->getAllocatedType();
  if (is->isAggregateType() || is->isPointerTy() || as->isPointerTy() ||
      (is->isFloatingPointTy() == as->isFloatingPointTy() &&
       is->getPrimitiveSizeInBits() == as->getPrimitiveSizeInBits()))
    return;
  const auto* kind = llvm::dyn_cast<llvm::MDNode>(tag->getOperand(1));
  const auto* name = kind == nullptr ? nullptr : llvm::dyn_cast<llvm::MDString>(kind->getOperand(0));
  if (name == nullptr || name->getString() != "omnipotent char")
    throw NotKnown(
        place_of(at) +
        ": a number taken for one of another type by a pointer, which C leaves undefined; use memcpy "
        "or a union");
}

void guard_access(I& at, llvm::Value* pointer, llvm::Value* bytes) {
  Access access(at);
  llvm::Value* outside = access.lies_outside(pointer, bytes);
  if (const auto* known = llvm::dyn_cast<llvm::ConstantInt>(outside); known == nullptr || !known->isZero())
    forbid_outside(access.build(), outside);
}

}  // namespace

std::vector<llvm::Instruction*> keep_variables(llvm::Function& function) {
  std::vector<I*> all, kept;
  for (I& at : llvm::instructions(function)) all.push_back(&at);
  for (I* at : all)
    if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(at);
        variable != nullptr && !holds_pointers(variable->getAllocatedType())) {
      llvm::IRBuilder<> build(variable->getNextNode());
      kept.push_back(hold_variable(build, variable));
    }
  return kept;
}

void guard_accesses(llvm::Function& function) {
  const llvm::DataLayout& layout = function.getParent()->getDataLayout();
  std::vector<I*> all;
  for (I& at : llvm::instructions(function)) all.push_back(&at);
  for (I* at : all) {
    const auto size_of = [&](llvm::Type* t) {
      return llvm::ConstantInt::get(llvm::Type::getInt64Ty(function.getContext()),
                                    layout.getTypeStoreSize(t));
    };
    if (auto* load = llvm::dyn_cast<llvm::LoadInst>(at)) {
      check_alias(*at, load->getPointerOperand(), load->getType());
      guard_access(*at, load->getPointerOperand(), size_of(load->getType()));
    } else if (auto* store = llvm::dyn_cast<llvm::StoreInst>(at)) {
      check_alias(*at, store->getPointerOperand(), store->getValueOperand()->getType());
      guard_access(*at, store->getPointerOperand(), size_of(store->getValueOperand()->getType()));
    } else if (auto* moved = llvm::dyn_cast<llvm::MemIntrinsic>(at)) {
      guard_access(*at, moved->getRawDest(), moved->getLength());
      if (auto* copied = llvm::dyn_cast<llvm::MemTransferInst>(at))
        guard_access(*at, copied->getRawSource(), copied->getLength());
    }
  }
}

}  // namespace mmverify::source
