#include "source/reader/undefined.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>
#include <llvm/Support/raw_ostream.h>

#include <optional>
#include <vector>

#include "source/program.hpp"
#include "source/reader/module.hpp"

namespace mmverify::source {
namespace {

using I = llvm::Instruction;

constexpr const char* operation = "mmverify.operation";
constexpr const char* unset = "mmverify.unset";
constexpr const char* overflow = "mmverify.overflow";
constexpr const char* unreachable = "mmverify.unreachable";
constexpr const char* assumption = "mmverify.assumption";

std::string name_of(const llvm::Type* type) {
  std::string text;
  llvm::raw_string_ostream(text) << *type;
  return text;
}

bool is_number(const llvm::Type* t) {
  return t->isFloatTy() || t->isDoubleTy() || (t->isIntegerTy() && t->getIntegerBitWidth() <= 64);
}

/// Passes may drop it where nobody looks at its value, if it `only_gives` one; else they leave it where it is.
llvm::Function* opaque(llvm::Module& module, const std::string& name, llvm::Type* gives,
                       const std::vector<llvm::Type*>& takes, bool only_gives) {
  if (llvm::Function* known = module.getFunction(name)) return known;
  auto* f = llvm::Function::Create(llvm::FunctionType::get(gives, takes, false),
                                   llvm::Function::ExternalLinkage, name, module);
  f->addFnAttr(llvm::Attribute::NoUnwind);
  f->addFnAttr(llvm::Attribute::WillReturn);
  if (only_gives)
    f->addFnAttr(llvm::Attribute::ReadNone);
  else
    f->addFnAttr(llvm::Attribute::InaccessibleMemOnly);
  return f;
}

llvm::Value* what_was_never_set(llvm::IRBuilder<>& build, llvm::Type* type) {
  return build.CreateCall(
      opaque(*build.GetInsertBlock()->getModule(), std::string(unset) + "." + name_of(type), type, {}, true));
}

bool divides(unsigned opcode) {
  return opcode == I::UDiv || opcode == I::SDiv || opcode == I::URem || opcode == I::SRem;
}
bool shifts(unsigned opcode) { return opcode == I::Shl || opcode == I::LShr || opcode == I::AShr; }
bool wraps(unsigned opcode) { return opcode == I::Add || opcode == I::Sub || opcode == I::Mul; }
bool becomes_a_word(unsigned opcode) { return opcode == I::FPToUI || opcode == I::FPToSI; }

/// Whether it is defined whatever its other operand is.
bool is_safe(unsigned opcode, unsigned flags, const llvm::Value* by) {
  const auto* k = llvm::dyn_cast<llvm::ConstantInt>(by);
  if (k == nullptr || flags != 0) return false;
  if (shifts(opcode)) return k->getValue().ult(k->getBitWidth());
  if (divides(opcode)) return !k->isZero() && !((opcode == I::SDiv || opcode == I::SRem) && k->isMinusOne());
  return false;
}

void guard_operation(I& at) {
  const unsigned opcode = at.getOpcode(), flags = flags_of(at);
  llvm::IRBuilder<> build(&at);
  std::vector<llvm::Value*> given{build.getInt32(opcode), build.getInt32(flags)};
  std::vector<llvm::Type*> takes{build.getInt32Ty(), build.getInt32Ty()};
  for (llvm::Value* v : at.operand_values()) {
    given.push_back(v);
    takes.push_back(v->getType());
  }
  // A division by zero is undefined by itself, whoever looks at its value.
  const std::string name = std::string(operation) + (divides(opcode) ? ".division." : ".") +
                           name_of(at.getType()) + "." + name_of(at.getOperand(0)->getType());
  llvm::CallInst* call =
      build.CreateCall(opaque(*at.getModule(), name, at.getType(), takes, !divides(opcode)), given);
  at.replaceAllUsesWith(call);
  at.eraseFromParent();
}

void guard_overflow(I& at) {
  llvm::IRBuilder<> build(&at);
  llvm::Value *a = at.getOperand(0), *b = at.getOperand(1);
  llvm::Function* f =
      opaque(*at.getModule(), std::string(overflow) + "." + name_of(at.getType()), build.getVoidTy(),
             {build.getInt32Ty(), build.getInt32Ty(), a->getType(), b->getType()}, false);
  build.CreateCall(f, {build.getInt32(at.getOpcode()), build.getInt32(flags_of(at)), a, b});
  at.setHasNoUnsignedWrap(false);
  at.setHasNoSignedWrap(false);
}

constexpr unsigned most_numbers = 1 << 16;

/// Each number of a variable is what was never set, until it is set.
void guard_leaves(llvm::IRBuilder<>& build, llvm::Value* address, llvm::Type* type, unsigned& room) {
  if (is_number(type)) {
    if (room-- == 0) throw NotKnown("a variable of more than 65536 numbers");
    build.CreateStore(what_was_never_set(build, type), address);
    return;
  }
  const std::uint64_t parts = type->isStructTy()  ? type->getStructNumElements()
                              : type->isArrayTy() ? type->getArrayNumElements()
                                                  : 0;
  for (std::uint64_t k = 0; k < parts; ++k)
    guard_leaves(
        build, build.CreateGEP(type, address, {build.getInt32(0), build.getInt32(static_cast<unsigned>(k))}),
        llvm::GetElementPtrInst::getTypeAtIndex(type, k), room);
}

void guard_variable(llvm::AllocaInst& variable) {
  if (variable.isArrayAllocation()) return;
  llvm::IRBuilder<> build(variable.getNextNode());
  build.SetCurrentDebugLocation({});
  if (const auto* f = variable.getFunction()->getSubprogram())
    build.SetCurrentDebugLocation(
        llvm::DILocation::get(variable.getContext(), 0, 0, const_cast<llvm::DISubprogram*>(f)));
  unsigned room = most_numbers;
  guard_leaves(build, &variable, variable.getAllocatedType(), room);
}

void guard_end(llvm::UnreachableInst& at) {
  llvm::IRBuilder<> build(&at);
  build.CreateCall(opaque(*at.getModule(), unreachable, build.getVoidTy(), {}, false));
  llvm::Type* gives = at.getFunction()->getReturnType();
  if (gives->isVoidTy())
    build.CreateRetVoid();
  else if (is_number(gives))
    build.CreateRet(what_was_never_set(build, gives));
  else
    build.CreateRet(llvm::Constant::getNullValue(gives));
  at.eraseFromParent();
}

void guard_call(llvm::CallInst& call) {
  switch (call.getIntrinsicID()) {
    case llvm::Intrinsic::is_constant:
    case llvm::Intrinsic::objectsize:
      throw NotKnown(place_of(call) + ": call of " + call.getCalledFunction()->getName().str() +
                     ": whether a value is known before it runs");
    case llvm::Intrinsic::assume: {
      llvm::IRBuilder<> build(&call);
      build.CreateCall(opaque(*call.getModule(), assumption, build.getVoidTy(), {build.getInt1Ty()}, false),
                       {call.getArgOperand(0)});
      call.eraseFromParent();
      return;
    }
    case llvm::Intrinsic::lifetime_start: {
      // A loop's variable is not what it was the last time.
      auto* variable = llvm::dyn_cast<llvm::AllocaInst>(call.getArgOperand(1)->stripPointerCasts());
      if (variable == nullptr || variable->isArrayAllocation()) return;
      llvm::IRBuilder<> build(call.getNextNode());
      unsigned room = most_numbers;
      guard_leaves(build, variable, variable->getAllocatedType(), room);
      return;
    }
    default:
      return;
  }
}

/// What is undefined from the start is as what was never set.
void guard_operands(I& at) {
  auto* phi = llvm::dyn_cast<llvm::PHINode>(&at);
  for (unsigned k = 0; k < at.getNumOperands(); ++k) {
    llvm::Type* type = at.getOperand(k)->getType();
    if (!llvm::isa<llvm::UndefValue>(at.getOperand(k)) || !is_number(type)) continue;
    llvm::IRBuilder<> build(phi != nullptr ? phi->getIncomingBlock(k)->getTerminator() : &at);
    at.setOperand(k, what_was_never_set(build, type));
  }
}

void guard_instruction(I& at) {
  guard_operands(at);
  if (const auto* math = llvm::dyn_cast<llvm::FPMathOperator>(&at);
      math != nullptr && math->getFastMathFlags().any())
    throw NotKnown(place_of(at) + ": " + at.getOpcodeName() +
                   ": fast-math flags, which leave its value open");
  if (auto* step = llvm::dyn_cast<llvm::GetElementPtrInst>(&at)) return step->setIsInBounds(false);
  if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(&at)) return guard_variable(*variable);
  if (auto* end = llvm::dyn_cast<llvm::UnreachableInst>(&at)) return guard_end(*end);
  if (auto* call = llvm::dyn_cast<llvm::CallInst>(&at)) return guard_call(*call);
  if (llvm::isa<llvm::LoadInst>(at)) return at.dropUnknownNonDebugMetadata();
  if (!is_number(at.getType())) return;
  const unsigned opcode = at.getOpcode();
  if (wraps(opcode) && flags_of(at) != 0) return guard_overflow(at);
  if (becomes_a_word(opcode) ||
      ((divides(opcode) || shifts(opcode)) && !is_safe(opcode, flags_of(at), at.getOperand(1))))
    guard_operation(at);
}

/// The instruction that a call stands for, where its operands leave nothing undefined.
llvm::Value* plain_again(llvm::CallInst& call) {
  const auto word = [&](unsigned k) {
    return static_cast<unsigned>(llvm::cast<llvm::ConstantInt>(call.getArgOperand(k))->getZExtValue());
  };
  const unsigned opcode = word(0), flags = word(1);
  llvm::IRBuilder<> build(&call);
  if (becomes_a_word(opcode)) {
    const auto* x = llvm::dyn_cast<llvm::ConstantFP>(call.getArgOperand(2));
    if (x == nullptr) return nullptr;
    llvm::APSInt whole(call.getType()->getIntegerBitWidth(), opcode == I::FPToUI);
    bool same = false;
    if (x->getValueAPF().convertToInteger(whole, llvm::APFloat::rmTowardZero, &same) ==
        llvm::APFloat::opInvalidOp)
      return nullptr;
    return llvm::ConstantInt::get(call.getType(), whole);
  }
  llvm::Value *a = call.getArgOperand(2), *b = call.getArgOperand(3);
  if (is_safe(opcode, flags, b)) return build.CreateBinOp(static_cast<I::BinaryOps>(opcode), a, b);
  return nullptr;
}

}  // namespace

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

std::string place_of(const llvm::Instruction& at) {
  const llvm::DILocation* line = at.getDebugLoc();
  if (line == nullptr || line->getLine() == 0) return at.getModule()->getSourceFileName();
  return line->getFilename().str() + ":" + std::to_string(line->getLine());
}

Guarded guarded(const llvm::CallInst& call) {
  const llvm::Function* to = call.getCalledFunction();
  if (to == nullptr) return Guarded::none;
  const llvm::StringRef name = to->getName();
  if (name.startswith(operation)) return Guarded::operation;
  if (name.startswith(unset)) return Guarded::unset;
  if (name.startswith(overflow)) return Guarded::overflow;
  if (name == unreachable) return Guarded::unreachable;
  if (name == assumption) return Guarded::assumption;
  return Guarded::none;
}

void guard(llvm::Module& module) {
  for (llvm::Function& f : module) {
    if (f.isDeclaration()) continue;
    std::vector<I*> all;
    for (I& at : llvm::instructions(f)) all.push_back(&at);
    for (I* at : all) guard_instruction(*at);
  }
}

bool decided(llvm::Module& module) {
  bool any = false;
  for (llvm::Function& f : module) {
    std::vector<llvm::CallInst*> calls;
    for (I& at : llvm::instructions(f))
      if (auto* call = llvm::dyn_cast<llvm::CallInst>(&at)) calls.push_back(call);
    for (llvm::CallInst* call : calls) {
      const Guarded what = guarded(*call);
      llvm::Value* plain = what == Guarded::operation ? plain_again(*call) : nullptr;
      if (plain != nullptr)
        call->replaceAllUsesWith(plain);
      else if (what != Guarded::unset || !call->use_empty())
        continue;
      call->eraseFromParent();
      any = true;
    }
  }
  return any;
}

}  // namespace mmverify::source
