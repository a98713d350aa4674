#include "subjects/source/reader/promises.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/IRBuilder.h>

#include <algorithm>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

using I = llvm::Instruction;

/// Whether a load or store in the same block uses the step: the guard of that access is stricter.
bool is_read_at_once(const llvm::GetElementPtrInst& step) {
  return !step.use_empty() && std::all_of(step.user_begin(), step.user_end(), [&](const llvm::User* user) {
    const auto* at = llvm::dyn_cast<I>(user);
    return at != nullptr && at->getParent() == step.getParent() &&
           llvm::getLoadStorePointerOperand(at) == &step;
  });
}

/// The attributes of one argument, or of the result.
struct Said {
  bool not_null, set;
  std::uint64_t bytes, alignment;
};

void require_all(llvm::IRBuilder<>& build, llvm::Value* value, const Said& said) {
  if (!value->getType()->isPointerTy()) {
    // C lets characters that were never set be passed on.
    const bool character = value->getType()->isIntegerTy(8);
    if (said.set && !character && value->getType()->isSingleValueType() && !llvm::isa<llvm::Constant>(value))
      require_set(build, value);
    return;
  }
  if (said.not_null) require(build, value, Required::not_null, 0);
  if (said.bytes != 0) require(build, value, Required::bytes, said.bytes);
  if (said.alignment > 1) require(build, value, Required::aligned, said.alignment);
  if (said.set) require(build, value, Required::set, 0);
}

Said said_by(const llvm::AttributeSet& a, const llvm::AttributeSet& b) {
  const auto either = [&](llvm::Attribute::AttrKind kind) {
    return a.hasAttribute(kind) || b.hasAttribute(kind);
  };
  const auto alignment = std::max(a.getAlignment().valueOrOne(), b.getAlignment().valueOrOne());
  return {either(llvm::Attribute::NonNull), either(llvm::Attribute::NoUndef),
          std::max(a.getDereferenceableBytes(), b.getDereferenceableBytes()), alignment.value()};
}

/// The place behind a call; null if there is none of its own.
I* behind(llvm::CallBase& call) {
  if (auto* invoked = llvm::dyn_cast<llvm::InvokeInst>(&call)) {
    llvm::BasicBlock* next = invoked->getNormalDest();
    return next->getSinglePredecessor() == nullptr ? nullptr : &*next->getFirstInsertionPt();
  }
  return call.getNextNode();
}

}  // namespace

void guard_step(llvm::GetElementPtrInst& step) {
  if (!step.isInBounds() || !step.getType()->isPointerTy() || is_read_at_once(step)) return;
  llvm::IRBuilder<> build(step.getNextNode());
  build.SetCurrentDebugLocation(step.getDebugLoc());
  // Characters may walk over all of a variable, and other numbers over the array that they are in.
  const bool by_bytes = step.getSourceElementType()->isIntegerTy(8);
  require(build, &step, by_bytes ? Required::in_whole : Required::in_part, 0);
}

void guard_pointers_read(I& at) {
  if (auto* load = llvm::dyn_cast<llvm::LoadInst>(&at)) {
    if (!load->getType()->isPointerTy() || !llvm::isa<llvm::AllocaInst>(load->getPointerOperand())) return;
    llvm::IRBuilder<> build(load->getNextNode());
    build.SetCurrentDebugLocation(load->getDebugLoc());
    return require(build, load, Required::set, 0);
  }
  if (!llvm::isa<llvm::ICmpInst>(at) && !llvm::isa<llvm::PtrToIntInst>(at)) return;
  llvm::IRBuilder<> build(&at);
  for (llvm::Value* of : at.operand_values())
    if (of->getType()->isPointerTy() && !llvm::isa<llvm::Constant>(of)) require(build, of, Required::set, 0);
}

void guard_pointer_loaded(I& at) {
  auto* load = llvm::dyn_cast<llvm::LoadInst>(&at);
  if (load == nullptr || !load->getType()->isPointerTy()) return;
  const auto number = [&](unsigned kind) -> std::uint64_t {
    const llvm::MDNode* node = load->getMetadata(kind);
    return node == nullptr ? 0
                           : llvm::mdconst::extract<llvm::ConstantInt>(node->getOperand(0))->getZExtValue();
  };
  using K = llvm::LLVMContext;
  const auto has = [&](unsigned kind) { return load->getMetadata(kind) != nullptr; };
  llvm::IRBuilder<> build(load->getNextNode());
  build.SetCurrentDebugLocation(load->getDebugLoc());
  require_all(build, load,
              {has(K::MD_nonnull), has(K::MD_noundef), number(K::MD_dereferenceable), number(K::MD_align)});
}

void guard_promises(llvm::CallBase& call) {
  const auto* to = llvm::dyn_cast<llvm::Function>(call.getCalledOperand()->stripPointerCasts());
  const llvm::AttributeList of_call = call.getAttributes(),
                            of_callee = to != nullptr ? to->getAttributes() : llvm::AttributeList();
  llvm::IRBuilder<> build(&call);
  for (unsigned k = 0; k < call.arg_size(); ++k)
    require_all(build, call.getArgOperand(k), said_by(of_call.getParamAttrs(k), of_callee.getParamAttrs(k)));
  if (call.getType()->isVoidTy()) return;
  const Said said = said_by(of_call.getRetAttrs(), of_callee.getRetAttrs());
  if (!said.not_null && !said.set && said.bytes == 0 && said.alignment <= 1) return;
  I* next = behind(call);
  if (next == nullptr)
    throw NotKnown(place_of(call) + ": call: a promise about a result that may be thrown past");
  build.SetInsertPoint(next);
  build.SetCurrentDebugLocation(call.getDebugLoc());
  require_all(build, &call, said);
}

void guard_moved(llvm::MemIntrinsic& moved) {
  const auto* length = llvm::dyn_cast<llvm::ConstantInt>(moved.getLength());
  if (length != nullptr && !length->isZero()) return;  // the guard of the access is stricter
  llvm::IRBuilder<> build(&moved);
  require(build, moved.getRawDest(), Required::not_null, 0);
  if (auto* copied = llvm::dyn_cast<llvm::MemTransferInst>(&moved))
    require(build, copied->getRawSource(), Required::not_null, 0);
}

void guard_assumed_pointers(llvm::IntrinsicInst& assumption) {
  llvm::IRBuilder<> build(&assumption);
  for (unsigned k = 0; k < assumption.getNumOperandBundles(); ++k) {
    const llvm::OperandBundleUse said = assumption.getOperandBundleAt(k);
    const llvm::StringRef name = said.getTagName();
    const auto* number =
        said.Inputs.size() == 2 ? llvm::dyn_cast<llvm::ConstantInt>(said.Inputs[1].get()) : nullptr;
    if (name == "nonnull" && said.Inputs.size() == 1)
      require(build, said.Inputs[0], Required::not_null, 0);
    else if (name == "align" && number != nullptr)
      require(build, said.Inputs[0], Required::aligned, number->getZExtValue());
    else if (name == "dereferenceable" && number != nullptr)
      require(build, said.Inputs[0], Required::bytes, number->getZExtValue());
    else
      throw NotKnown(place_of(assumption) + ": an assumption of another kind: " + name.str());
  }
}

}  // namespace mmverify::source
