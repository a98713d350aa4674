#include <llvm/Analysis/CaptureTracking.h>
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

#include <algorithm>
#include <array>
#include <string>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/refused/refused.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

using Kind = llvm::Attribute::AttrKind;

/// Attributes with a name of their own that add no code: how a processor is used, and modes of floats, at
/// which the guards look (undefined.cpp).
bool adds_no_code(const llvm::Attribute& a) {
  static constexpr std::array harmless{"alloc-family",
                                       "approx-func-fp-math",
                                       "correctly-rounded-divide-sqrt-fp-math",
                                       "denormal-fp-math",
                                       "denormal-fp-math-f32",
                                       "disable-tail-calls",
                                       "frame-pointer",
                                       "less-precise-fpmad",
                                       "min-legal-vector-width",
                                       "no-builtins",
                                       "no-infs-fp-math",
                                       "no-inline-line-tables",
                                       "no-jump-tables",
                                       "no-nans-fp-math",
                                       "no-realign-stack",
                                       "no-signed-zeros-fp-math",
                                       "no-trapping-math",
                                       "prefer-vector-width",
                                       "reciprocal-estimates",
                                       "stack-protector-buffer-size",
                                       "stackrealign",
                                       "strict-float-cast-overflow",
                                       "strictfp",
                                       "target-cpu",
                                       "target-features",
                                       "tune-cpu",
                                       "uniform-work-group-size",
                                       "unsafe-fp-math",
                                       "use-soft-float"};
  const llvm::StringRef name = a.getKindAsString();
  if (name == "probe-stack") return a.getValueAsString() == "inline-asm";
  if (name.startswith("no-builtin-")) return true;
  return std::any_of(harmless.begin(), harmless.end(), [&](const char* one) { return name == one; });
}

/// Attributes of LLVM's by which code is put in, or a function is no function of its arguments.
constexpr std::array unjudged{Kind::Naked,          Kind::SanitizeAddress,      Kind::SanitizeHWAddress,
                              Kind::SanitizeMemTag, Kind::SanitizeMemory,       Kind::SanitizeThread,
                              Kind::SafeStack,      Kind::ShadowCallStack,      Kind::JumpTable,
                              Kind::InAlloca,       Kind::Preallocated,         Kind::SwiftError,
                              Kind::Speculatable,   Kind::DereferenceableOrNull};

void refuse_in(const llvm::AttributeSet& all, const std::string& place) {
  for (const llvm::Attribute& a : all) {
    const bool bad = a.isStringAttribute()
                         ? !adds_no_code(a)
                         : std::find(unjudged.begin(), unjudged.end(), a.getKindAsEnum()) != unjudged.end();
    if (bad)
      throw NotKnown(place + ": the attribute " + a.getAsString() + ", which the reader does not judge");
  }
}

void refuse_in(const llvm::AttributeList& lists, const std::string& place) {
  for (const unsigned k : lists.indexes()) refuse_in(lists.getAttributes(k), place);
}

/// Whether an address space other than the common one is in the constant, or is the value's own.
bool is_elsewhere(const llvm::Value* v) {
  const auto* pointer = llvm::dyn_cast<llvm::PointerType>(v->getType()->getScalarType());
  if (pointer != nullptr && pointer->getAddressSpace() != 0) return true;
  if (llvm::isa<llvm::GlobalValue>(v) || !llvm::isa<llvm::Constant>(v)) return false;
  const auto& constant = llvm::cast<llvm::Constant>(*v);
  return std::any_of(constant.op_begin(), constant.op_end(),
                     [](const llvm::Use& u) { return is_elsewhere(u); });
}

/// Whether an invariant load is of a constant table.
bool is_of_table(const llvm::Instruction& load) {
  const auto* table =
      llvm::dyn_cast<llvm::GlobalVariable>(llvm::getLoadStorePointerOperand(&load)->stripInBoundsOffsets());
  return table != nullptr && table->isConstant();
}

/// Metadata that no guard looks at and that promises something.
constexpr std::array promises{llvm::LLVMContext::MD_fpmath,
                              llvm::LLVMContext::MD_mem_parallel_loop_access,
                              llvm::LLVMContext::MD_dereferenceable_or_null,
                              llvm::LLVMContext::MD_make_implicit,
                              llvm::LLVMContext::MD_invariant_group,
                              llvm::LLVMContext::MD_access_group,
                              llvm::LLVMContext::MD_callees};

/// Whether a call may use the caller's variables by their addresses.
bool may_use_variables(const llvm::CallBase& call) {
  for (const llvm::Value* given : call.args())
    if (given->getType()->isPointerTy() && llvm::isa<llvm::AllocaInst>(llvm::getUnderlyingObject(given)))
      return true;
  for (const llvm::Instruction& at : llvm::instructions(*call.getFunction()))
    if (llvm::isa<llvm::AllocaInst>(at) && llvm::PointerMayBeCaptured(&at, false, true)) return true;
  return false;
}

/// Whether the tag of an access says that nothing ever writes there.
bool is_of_constant(const llvm::MDNode& tag) {
  const auto* constant =
      tag.getNumOperands() < 4 ? nullptr : llvm::mdconst::dyn_extract<llvm::ConstantInt>(tag.getOperand(3));
  return constant != nullptr && !constant->isZero();
}

/// Whether a pragma lets compilers put the turns of a loop side by side, and so sum in another order.
bool may_be_reordered(const llvm::Loop& loop) {
  for (const char* name : {"llvm.loop.vectorize.enable", "llvm.loop.vectorize.width",
                           "llvm.loop.vectorize.scalable.enable", "llvm.loop.interleave.count"})
    if (llvm::findOptionMDForLoop(&loop, name) != nullptr) return true;
  return false;
}

bool is_of_floats(const llvm::Instruction& at) {
  return at.getType()->isFPOrFPVectorTy() && (at.isBinaryOp() || llvm::isa<llvm::CallBase>(at));
}

}  // namespace

void refuse_reordered(llvm::Function& f) {
  const llvm::DominatorTree tree(f);
  const llvm::LoopInfo loops(tree);
  for (const llvm::Loop* loop : loops.getLoopsInPreorder())
    for (const llvm::BasicBlock* block : loop->blocks())
      for (const llvm::Instruction& at : *block)
        if (is_of_floats(at) && may_be_reordered(*loop))
          throw NotKnown(place_of(at) +
                         ": an operation of floats in a loop whose pragma lets compilers reorder it");
}

void refuse_attributes(const llvm::Function& f) {
  const std::string place = place_of(f);
  refuse_in(f.getAttributes(), place);
  if (f.hasPrologueData() || f.hasPrefixData())
    throw NotKnown(place + ": " + f.getName().str() +
                   " has bytes of its own before its code (prologue, prefix)");
  if (f.hasGC()) throw NotKnown(place + ": " + f.getName().str() + " calls a garbage collector");
  for (const llvm::Instruction& at : llvm::instructions(f))
    if (const auto* call = llvm::dyn_cast<llvm::CallBase>(&at);
        call != nullptr && !llvm::isa<llvm::IntrinsicInst>(at))
      refuse_in(call->getAttributes(), place_of(at));
    else if (call != nullptr && call->hasFnAttr("trap-func-name"))
      throw NotKnown(place_of(at) + ": a trap that calls " +
                     call->getFnAttr("trap-func-name").getValueAsString().str());
}

void refuse_metadata(const llvm::Function& f) {
  llvm::SmallVector<llvm::StringRef, 40> names;
  f.getContext().getMDKindNames(names);
  for (const llvm::Instruction& at : llvm::instructions(f)) {
    for (const unsigned kind : promises)
      if (at.getMetadata(kind) != nullptr)
        throw NotKnown(place_of(at) + ": the promise !" + names[kind].str() + ", which nothing checks");
    if (at.getMetadata(llvm::LLVMContext::MD_invariant_load) != nullptr && !is_of_table(at))
      throw NotKnown(place_of(at) + ": !invariant.load of what may change");
    if (const llvm::MDNode* tag = at.getMetadata(llvm::LLVMContext::MD_tbaa);
        tag != nullptr && is_of_constant(*tag))
      throw NotKnown(place_of(at) + ": a !tbaa tag that says that memory is constant");
    if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&at); call != nullptr && call->isTailCall() &&
                                                                !llvm::isa<llvm::IntrinsicInst>(call) &&
                                                                may_use_variables(*call))
      throw NotKnown(place_of(at) + ": a tail call that may use variables of its caller");
    if (llvm::isa<llvm::InvokeInst>(at) && at.getMetadata(llvm::LLVMContext::MD_range) != nullptr)
      throw NotKnown(place_of(at) + ": a promise about a result that may be thrown past");
    const bool any = is_elsewhere(&at) || std::any_of(at.op_begin(), at.op_end(),
                                                      [](const llvm::Use& u) { return is_elsewhere(u); });
    if (any) throw NotKnown(place_of(at) + ": a pointer of another address space");
  }
}

}  // namespace mmverify::source
