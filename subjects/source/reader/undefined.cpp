#include "subjects/source/reader/undefined.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/DebugInfo.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>
#include <vector>

#include "subjects/source/program.hpp"
#include "subjects/source/reader/lifetimes.hpp"
#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/promises.hpp"

namespace mmverify::source {
namespace {

using I = llvm::Instruction;

constexpr const char* operation = "mmverify.operation";
constexpr const char* unset = "mmverify.unset";
constexpr const char* address = "mmverify.address";
constexpr const char* variable_of = "mmverify.variable";
constexpr const char* apart = "mmverify.apart";
constexpr const char* refused = "mmverify.refused";
constexpr const char* overflow = "mmverify.overflow";
constexpr const char* branch = "mmverify.branch";
constexpr const char* outside = "mmverify.outside";
constexpr const char* unreachable = "mmverify.unreachable";
constexpr const char* assumption = "mmverify.assumption";
constexpr const char* argument = "mmverify.argument";
constexpr const char* pointer_of = "mmverify.pointer";

/// Whether the type is words, floats or vectors of them, of any width. The translator reports those that it
/// does not know.
bool is_value(const llvm::Type* t) { return t->isIntOrIntVectorTy() || t->isFPOrFPVectorTy(); }

/// Calls a function that passes cannot look into. If it `only_gives` a value, they may drop the call when the
/// value is unused; otherwise they leave it in its place and never merge two.
llvm::CallInst* call_opaque(llvm::IRBuilder<>& build, const std::string& kind, llvm::Type* gives,
                            const std::vector<llvm::Value*>& given, bool only_gives) {
  std::vector<llvm::Type*> takes;
  for (const llvm::Value* v : given) takes.push_back(v->getType());
  auto* type = llvm::FunctionType::get(gives, takes, false);
  std::string name = kind + " ";
  llvm::raw_string_ostream(name) << *type;
  llvm::Module& module = *build.GetInsertBlock()->getModule();
  llvm::Function* f = module.getFunction(name);
  if (f == nullptr) {
    f = llvm::Function::Create(type, llvm::Function::ExternalLinkage, name, module);
    f->addFnAttr(llvm::Attribute::NoUnwind);
    if (only_gives) {
      f->addFnAttr(llvm::Attribute::WillReturn);
      f->addFnAttr(llvm::Attribute::ReadNone);
    } else {
      f->addFnAttr(llvm::Attribute::InaccessibleMemOnly);
    }
  }
  llvm::CallInst* call = build.CreateCall(f, given);
  if (!only_gives) call->addFnAttr(llvm::Attribute::NoMerge);
  return call;
}

bool wraps(unsigned opcode) { return opcode == I::Add || opcode == I::Sub || opcode == I::Mul; }
/// Replaces an operation by an opaque call: of its opcode, its detail (flags, a predicate, an intrinsic's
/// number), and its operands.
void hold(I& at) {
  unsigned detail = flags_of(at);
  if (const auto* compare = llvm::dyn_cast<llvm::CmpInst>(&at)) detail = compare->getPredicate();
  llvm::IRBuilder<> build(&at);
  std::vector<llvm::Value*> given{build.getInt32(at.getOpcode()), nullptr};
  if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&at)) {
    detail = call->getIntrinsicID();
    given.insert(given.end(), call->arg_begin(), call->arg_end());
  } else {
    given.insert(given.end(), at.value_op_begin(), at.value_op_end());
  }
  given[1] = build.getInt32(detail);
  // A division by zero is undefined even if its value is unused.
  const bool divided = divides(at.getOpcode());
  llvm::CallInst* held = call_opaque(build, operation, at.getType(), given, !divided);
  at.replaceAllUsesWith(held);
  at.eraseFromParent();
}

/// Wraps a load of a variable: in C, reading one that was never set is undefined, even if its value does not
/// matter.
void hold_read(llvm::LoadInst& load) {
  llvm::IRBuilder<> build(load.getNextNode());
  build.SetCurrentDebugLocation(load.getDebugLoc());
  llvm::CallInst* held = call_opaque(build, operation, load.getType(),
                                     {build.getInt32(I::Load), build.getInt32(0), &load}, true);
  load.replaceUsesWithIf(held, [&](const llvm::Use& use) { return use.getUser() != held; });
}

void guard_overflow(I& at) {
  llvm::IRBuilder<> build(&at);
  call_opaque(
      build, overflow, build.getVoidTy(),
      {build.getInt32(at.getOpcode()), build.getInt32(flags_of(at)), at.getOperand(0), at.getOperand(1)},
      false);
  at.setHasNoUnsignedWrap(false);
  at.setHasNoSignedWrap(false);
}

constexpr unsigned most_numbers = 1 << 16;

/// Fills a variable with values never set: each number, and the padding between them.
void guard_leaves(llvm::IRBuilder<>& build, llvm::Value* address_of, llvm::Type* type, unsigned& room) {
  const llvm::DataLayout& layout = build.GetInsertBlock()->getModule()->getDataLayout();
  if (is_value(type) || type->isPointerTy()) {
    if (room-- == 0) throw NotKnown("a variable of more than 65536 numbers");
    build.CreateStore(never_set(build, type), address_of);
    return;
  }
  const std::uint64_t parts = type->isStructTy()  ? type->getStructNumElements()
                              : type->isArrayTy() ? type->getArrayNumElements()
                                                  : 0;
  if (auto* record = llvm::dyn_cast<llvm::StructType>(type)) {
    llvm::Value* bytes = build.CreateBitCast(address_of, build.getInt8PtrTy());
    std::vector<bool> covered(layout.getTypeAllocSize(record), false);
    for (unsigned k = 0; k < parts; ++k) {
      const std::uint64_t from = layout.getStructLayout(record)->getElementOffset(k),
                          size = layout.getTypeAllocSize(record->getElementType(k));
      std::fill_n(covered.begin() + static_cast<std::ptrdiff_t>(from), size, true);
    }
    for (std::uint64_t k = 0; k < covered.size(); ++k)
      if (!covered[k])
        build.CreateStore(never_set(build, build.getInt8Ty()),
                          build.CreateConstGEP1_64(build.getInt8Ty(), bytes, k));
  }
  for (std::uint64_t k = 0; k < parts; ++k)
    guard_leaves(
        build,
        build.CreateGEP(type, address_of, {build.getInt32(0), build.getInt32(static_cast<unsigned>(k))}),
        llvm::GetElementPtrInst::getTypeAtIndex(type, k), room);
}

/// The line of the variable's declaration, or else of its function.
llvm::DebugLoc declared_at(llvm::AllocaInst& variable) {
  for (const llvm::DbgVariableIntrinsic* declared : llvm::FindDbgAddrUses(&variable))
    return declared->getDebugLoc();
  if (variable.getDebugLoc()) return variable.getDebugLoc();
  const auto* f = variable.getFunction()->getSubprogram();
  if (f == nullptr) return {};
  return llvm::DILocation::get(variable.getContext(), 0, 0, const_cast<llvm::DISubprogram*>(f));
}

void guard_variable_from(I* next, llvm::AllocaInst& variable) {
  llvm::IRBuilder<> build(next);
  build.SetCurrentDebugLocation(declared_at(variable));
  unsigned room = most_numbers;
  guard_leaves(build, &variable, variable.getAllocatedType(), room);
}

void guard_variable(llvm::AllocaInst& variable) {
  if (!variable.isArrayAllocation()) guard_variable_from(variable.getNextNode(), variable);
}

void guard_end(llvm::UnreachableInst& at) {
  llvm::IRBuilder<> build(&at);
  call_opaque(build, unreachable, build.getVoidTy(), {}, false);
  llvm::Type* gives = at.getFunction()->getReturnType();
  if (gives->isVoidTy())
    build.CreateRetVoid();
  else if (is_value(gives))
    build.CreateRet(never_set(build, gives));
  else
    build.CreateRet(llvm::Constant::getNullValue(gives));
  at.eraseFromParent();
}

/// Records the pointers of a call if its callee may assume that one of them is distinct from all others.
void guard_restricted(llvm::CallBase& call) {
  llvm::IRBuilder<> build(&call);
  std::vector<llvm::Value*> pointers;
  bool any = false;
  for (unsigned k = 0; k < call.arg_size(); ++k) {
    if (!call.getArgOperand(k)->getType()->isPointerTy()) continue;
    const bool restricted =
        call.paramHasAttr(k, llvm::Attribute::NoAlias) && !call.paramHasAttr(k, llvm::Attribute::StructRet);
    pointers.insert(pointers.end(), {build.getInt1(restricted), call.getArgOperand(k)});
    any = any || restricted;
  }
  if (any) call_opaque(build, apart, build.getVoidTy(), pointers, false);
}

void guard_call(llvm::CallInst& call) {
  switch (call.getIntrinsicID()) {
    case llvm::Intrinsic::is_constant:
    case llvm::Intrinsic::objectsize:
      throw NotKnown(place_of(call) + ": call of " + call.getCalledFunction()->getName().str() +
                     ": whether a value is known before it runs");
    case llvm::Intrinsic::assume: {
      llvm::IRBuilder<> build(&call);
      guard_assumed_pointers(llvm::cast<llvm::IntrinsicInst>(call));
      call_opaque(build, assumption, build.getVoidTy(), {call.getArgOperand(0)}, false);
      call.eraseFromParent();
      return;
    }
    case llvm::Intrinsic::lifetime_start:
    case llvm::Intrinsic::lifetime_end: {
      // A variable loses its value where its lifetime begins, as in each turn of a loop, and where it ends.
      auto* variable = llvm::dyn_cast<llvm::AllocaInst>(call.getArgOperand(1)->stripPointerCasts());
      if (variable != nullptr && !variable->isArrayAllocation())
        guard_variable_from(call.getNextNode(), *variable);
      return;
    }
    default:
      guard_restricted(call);
      if (!llvm::isa<llvm::IntrinsicInst>(call)) guard_promises(call);
      if (auto* moved = llvm::dyn_cast<llvm::MemIntrinsic>(&call)) guard_moved(*moved);
  }
}

/// Hides an address in a table; one beyond the table is undefined.
llvm::CallInst* guard_address(llvm::IRBuilder<>& build, llvm::Constant& constant) {
  llvm::CallInst* hidden = call_opaque(build, address, constant.getType(), {&constant}, true);
  const auto* step = llvm::dyn_cast<llvm::GEPOperator>(constant.stripPointerCasts());
  if (step != nullptr && step->isInBounds()) require(build, hidden, Required::in_whole, 0);
  return hidden;
}

/// Replaces constant operands: an undefined one by a value never set, an address in a table by an opaque one.
void guard_operands(I& at) {
  auto* phi = llvm::dyn_cast<llvm::PHINode>(&at);
  for (unsigned k = 0; k < at.getNumOperands(); ++k) {
    auto* constant = llvm::dyn_cast<llvm::Constant>(at.getOperand(k));
    if (constant == nullptr) continue;
    llvm::Type* type = constant->getType();
    llvm::IRBuilder<> build(phi != nullptr ? phi->getIncomingBlock(k)->getTerminator() : &at);
    build.SetCurrentDebugLocation(at.getDebugLoc());
    if (llvm::isa<llvm::UndefValue>(constant) && (is_value(type) || type->isPointerTy()))
      at.setOperand(k, never_set(build, type));
    else if (llvm::isa<llvm::GlobalVariable>(constant->stripInBoundsOffsets()))
      at.setOperand(k, guard_address(build, *constant));
  }
}

/// Whether the instruction only computes a value from values.
bool is_operation(const I& at) {
  if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&at)) {
    const llvm::Intrinsic::ID id = call->getIntrinsicID();
    if (id == llvm::Intrinsic::not_intrinsic || id == llvm::Intrinsic::is_constant ||
        !call->doesNotAccessMemory() || call->getType()->isVoidTy() || call->arg_empty())
      return false;
    return std::all_of(call->arg_begin(), call->arg_end(),
                       [](const auto& v) { return is_value(v->getType()); });
  }
  const bool known = at.isBinaryOp() || at.isUnaryOp() || at.isCast() || llvm::isa<llvm::CmpInst>(at) ||
                     llvm::isa<llvm::SelectInst>(at) || llvm::isa<llvm::FreezeInst>(at);
  return known && is_value(at.getType()) && is_value(at.getOperand(0)->getType());
}

/// Guards a branch against an undefined condition.
void guard_branch(I& at) {
  const auto* way = llvm::dyn_cast<llvm::BranchInst>(&at);
  llvm::Value* on = way == nullptr         ? llvm::cast<llvm::SwitchInst>(at).getCondition()
                    : way->isConditional() ? way->getCondition()
                                           : nullptr;
  llvm::IRBuilder<> build(&at);
  if (on != nullptr && !llvm::isa<llvm::Constant>(on))
    call_opaque(build, branch, build.getVoidTy(), {on}, false);
}

/// Guards the range of a value that is loaded or returned: a bool's byte is 0 or 1.
void guard_range(I& at, const llvm::MDNode& range) {
  llvm::IRBuilder<> build(at.getNextNode());
  build.SetCurrentDebugLocation(at.getDebugLoc());
  llvm::Value* none = build.getTrue();
  for (unsigned k = 0; k + 1 < range.getNumOperands(); k += 2) {
    const auto number = [&](unsigned of) {
      return llvm::mdconst::extract<llvm::ConstantInt>(range.getOperand(of))->getValue();
    };
    const llvm::APInt first = number(k), size = number(k + 1) - first;
    none = build.CreateAnd(
        none, build.CreateICmpUGE(build.CreateSub(&at, llvm::ConstantInt::get(at.getType(), first)),
                                  llvm::ConstantInt::get(at.getType(), size)));
  }
  forbid_outside(build, none, Outside::of_type);
}

void guard_load(llvm::LoadInst& load) {
  const auto* variable = llvm::dyn_cast<llvm::AllocaInst>(load.getPointerOperand());
  if (variable != nullptr && variable->getAllocatedType() == load.getType() && is_value(load.getType()))
    hold_read(load);
}

void guard_instruction(I& at) {
  const llvm::MDNode* range = at.getMetadata(llvm::LLVMContext::MD_range);
  if (at.getMetadata(llvm::LLVMContext::MD_noalias) != nullptr ||
      at.getMetadata(llvm::LLVMContext::MD_alias_scope) != nullptr) {
    llvm::IRBuilder<> build(&at);
    refuse(build, Refusal::scopes);
  }
  guard_pointer_loaded(at);
  // apart.hpp checks types after calls are inlined.
  at.dropUnknownNonDebugMetadata({llvm::LLVMContext::MD_tbaa, llvm::LLVMContext::MD_tbaa_struct});
  if (llvm::isa<llvm::DbgInfoIntrinsic>(at)) return;
  if (!llvm::isa<llvm::IntrinsicInst>(at) || llvm::isa<llvm::MemTransferInst>(at) || is_operation(at))
    guard_operands(at);
  if (const auto* math = llvm::dyn_cast<llvm::FPMathOperator>(&at);
      math != nullptr && math->getFastMathFlags().any())
    throw NotKnown(place_of(at) + ": " + at.getOpcodeName() +
                   ": fast-math flags, which leave its value open");
  if (range != nullptr) guard_range(at, *range);
  guard_pointers_read(at);
  if (auto* step = llvm::dyn_cast<llvm::GetElementPtrInst>(&at)) {
    guard_step(*step);
    return step->setIsInBounds(false);
  }
  if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(&at)) return guard_variable(*variable);
  if (auto* end = llvm::dyn_cast<llvm::UnreachableInst>(&at)) return guard_end(*end);
  if (auto* load = llvm::dyn_cast<llvm::LoadInst>(&at)) {
    return guard_load(*load);
  }
  if (llvm::isa<llvm::BranchInst>(at) || llvm::isa<llvm::SwitchInst>(at)) return guard_branch(at);
  if (auto* call = llvm::dyn_cast<llvm::CallInst>(&at); call != nullptr && !is_operation(at))
    return guard_call(*call);
  if (auto* invoked = llvm::dyn_cast<llvm::InvokeInst>(&at)) {
    guard_restricted(*invoked);
    return guard_promises(*invoked);
  }
  if (!is_operation(at)) return;
  if (wraps(at.getOpcode()) && flags_of(at) != 0) guard_overflow(at);
  hold(at);
}

/// Throws NotKnown if the function's attributes select float modes other than IEEE 754's.
void check_floats(const llvm::Function& f) {
  const auto said = [&](const char* name) { return f.getFnAttribute(name).getValueAsString(); };
  for (const char* mode : {"denormal-fp-math", "denormal-fp-math-f32"})
    if (const llvm::StringRef is = said(mode); !is.empty() && is != "ieee" && is != "ieee,ieee")
      throw NotKnown(place_of(f) + ": " + mode + " " + is.str() + ": subnormal numbers are flushed");
  for (const char* mode : {"unsafe-fp-math", "no-nans-fp-math", "no-infs-fp-math", "no-signed-zeros-fp-math",
                           "approx-func-fp-math", "less-precise-fpmad"})
    if (said(mode) == "true")
      throw NotKnown(place_of(f) + ": " + mode + ": fast-math, which leaves floats open");
  if (f.hasFnAttribute(llvm::Attribute::StrictFP))
    throw NotKnown(place_of(f) + ": strictfp: another rounding may be set");
  llvm::SmallVector<llvm::StringRef, 32> features;
  said("target-features").split(features, ',');
  for (const llvm::StringRef feature : features)
    if (feature == "-sse" || feature == "-sse2" || feature == "+soft-float")
      throw NotKnown(place_of(f) + ": the target feature " + feature.str() +
                     ": floats are computed with other precision than their types'");
}

/// Drops attributes from which passes would conclude: the function returns, pointers are distinct and not
/// null.
void drop_promises(llvm::Function& f) {
  for (const auto promise :
       {llvm::Attribute::MustProgress, llvm::Attribute::WillReturn, llvm::Attribute::ReadNone,
        llvm::Attribute::ReadOnly, llvm::Attribute::ArgMemOnly, llvm::Attribute::Speculatable})
    f.removeFnAttr(promise);
  f.addFnAttr(llvm::Attribute::NullPointerIsValid);
  llvm::AttributeMask of_values;
  for (const auto promise :
       {llvm::Attribute::NoAlias, llvm::Attribute::NonNull, llvm::Attribute::NoUndef,
        llvm::Attribute::Dereferenceable, llvm::Attribute::DereferenceableOrNull, llvm::Attribute::ReadOnly,
        llvm::Attribute::ReadNone, llvm::Attribute::WriteOnly, llvm::Attribute::NoCapture,
        llvm::Attribute::Returned, llvm::Attribute::Alignment})
    of_values.addAttribute(promise);
  for (unsigned k = 0; k < f.arg_size(); ++k) f.removeParamAttrs(k, of_values);
  f.removeRetAttrs(of_values);
}

}  // namespace

bool divides(unsigned opcode) {
  return opcode == I::UDiv || opcode == I::SDiv || opcode == I::URem || opcode == I::SRem;
}

unsigned flags_of(const I& at) {
  unsigned flags = 0;
  if (const auto* wraps = llvm::dyn_cast<llvm::OverflowingBinaryOperator>(&at)) {
    if (wraps->hasNoUnsignedWrap()) flags |= no_unsigned_wrap;
    if (wraps->hasNoSignedWrap()) flags |= no_signed_wrap;
  }
  if (const auto* whole = llvm::dyn_cast<llvm::PossiblyExactOperator>(&at);
      whole != nullptr && whole->isExact())
    flags |= exact;
  return flags;
}

const llvm::DILocation* line_of(const llvm::Instruction& at) {
  const llvm::DILocation* line = at.getDebugLoc();
  const auto* variable = llvm::dyn_cast<llvm::AllocaInst>(&at);
  if (line == nullptr && variable != nullptr) line = declared_at(const_cast<llvm::AllocaInst&>(*variable));
  if (line != nullptr && line->getLine() != 0) return line;
  if (variable == nullptr) return nullptr;
  for (const llvm::User* user : variable->users())
    if (const auto* use = llvm::dyn_cast<I>(user); use != nullptr && !llvm::isa<llvm::AllocaInst>(use))
      if (line = use->getDebugLoc(); line != nullptr && line->getLine() != 0) return line;
  return nullptr;
}

std::string place_of(const llvm::Instruction& at) {
  const llvm::DILocation* line = line_of(at);
  if (line == nullptr) return at.getModule()->getSourceFileName();
  return line->getFilename().str() + ":" + std::to_string(line->getLine());
}

std::string place_of(const llvm::Function& f) {
  const llvm::DISubprogram* at = f.getSubprogram();
  return at == nullptr ? f.getParent()->getSourceFileName()
                       : at->getFilename().str() + ":" + std::to_string(at->getLine());
}

std::string place_of(const llvm::GlobalValue& value) {
  if (const auto* f = llvm::dyn_cast<llvm::Function>(&value)) return place_of(*f);
  llvm::SmallVector<llvm::DIGlobalVariableExpression*, 1> declared;
  if (const auto* variable = llvm::dyn_cast<llvm::GlobalVariable>(&value)) variable->getDebugInfo(declared);
  if (declared.empty()) return value.getParent()->getSourceFileName();
  const llvm::DIGlobalVariable& at = *declared[0]->getVariable();
  return at.getFilename().str() + ":" + std::to_string(at.getLine());
}

Guarded guarded(const llvm::CallInst& call) {
  const llvm::Function* to = call.getCalledFunction();
  if (to == nullptr) return Guarded::none;
  static const std::pair<const char*, Guarded> kinds[] = {
      {operation, Guarded::operation},     {unset, Guarded::unset},           {address, Guarded::address},
      {overflow, Guarded::overflow},       {branch, Guarded::branch},         {outside, Guarded::outside},
      {variable_of, Guarded::variable},    {apart, Guarded::apart},           {refused, Guarded::refused},
      {unreachable, Guarded::unreachable}, {assumption, Guarded::assumption}, {argument, Guarded::argument},
      {pointer_of, Guarded::pointer}};
  const llvm::StringRef name = to->getName();
  for (const auto& [prefix, kind] : kinds)
    if (name.startswith(prefix)) return kind;
  return Guarded::none;
}

llvm::CallInst* never_set(llvm::IRBuilder<>& build, llvm::Type* type) {
  return call_opaque(build, unset, type, {}, true);
}

void define_unset(llvm::Module& module) {
  for (llvm::Function& f : module) {
    if (!f.isDeclaration() || !f.getName().startswith(unset)) continue;
    llvm::IRBuilder<> build(llvm::BasicBlock::Create(module.getContext(), "", &f));
    build.CreateRet(build.CreateFreeze(llvm::UndefValue::get(f.getReturnType())));
    f.setLinkage(llvm::GlobalValue::InternalLinkage);
  }
}

void forbid_outside(llvm::IRBuilder<>& build, llvm::Value* condition, Outside what) {
  if (const auto* known = llvm::dyn_cast<llvm::ConstantInt>(condition); known != nullptr && known->isZero())
    return;
  call_opaque(build, outside, build.getVoidTy(), {condition, build.getInt32(static_cast<unsigned>(what))},
              false);
}

void refuse(llvm::IRBuilder<>& build, Refusal why) {
  call_opaque(build, refused, build.getVoidTy(), {build.getInt32(static_cast<unsigned>(why))}, false);
}

void require(llvm::IRBuilder<>& build, llvm::Value* pointer, Required what, std::uint64_t number) {
  call_opaque(build, pointer_of, build.getVoidTy(),
              {pointer, build.getInt32(static_cast<unsigned>(what)), build.getInt64(number)}, false);
}

void require_set(llvm::IRBuilder<>& build, llvm::Value* value) {
  call_opaque(build, argument, build.getVoidTy(), {value}, false);
}

llvm::CallInst* hidden(llvm::IRBuilder<>& build, llvm::Value* variable, llvm::Value* alive) {
  return call_opaque(build, variable_of, variable->getType(), {variable, alive}, true);
}

unsigned word_of(const llvm::CallInst& call, unsigned k) {
  return static_cast<unsigned>(llvm::cast<llvm::ConstantInt>(call.getArgOperand(k))->getZExtValue());
}

void guard(llvm::Module& module) {
  for (llvm::Function& f : module) {
    if (f.isDeclaration()) continue;
    check_floats(f);
    check_lifetimes(f);
    std::vector<I*> all;
    for (I& at : llvm::instructions(f)) all.push_back(&at);
    for (I* at : all) guard_instruction(*at);
  }
  for (llvm::Function& f : module)
    if (!f.isDeclaration()) drop_promises(f);
}

}  // namespace mmverify::source
