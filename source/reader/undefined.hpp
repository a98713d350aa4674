// Undefined behaviour, kept from LLVM's passes: what may be undefined becomes a call that they know nothing of, so that
// none of them can take it for what never happens.
#pragma once

#include <llvm/IR/InstrTypes.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/Module.h>

#include <string>

namespace mmverify::source {

/// What such a call stands for.
enum class Guarded {
  none,
  operation,  ///< (opcode, flags, operands...): an instruction whose value may be poison, or that may be undefined itself
  unset,        ///< what a variable holds before it is set
  overflow,     ///< (opcode, flags, a, b): forbidden where a sum, difference or product of words does not fit
  unreachable,  ///< a place that must not be reached
  assumption,   ///< (condition)
};
Guarded guarded(const llvm::CallInst& call);

/// Makes them, in all functions of the module.  Throws NotKnown: what passes would decide in another way than the compiled
/// code does, such as whether the level is a constant.
void guard(llvm::Module& module);

/// Takes back those that constants have decided, and those that nobody looks at.  Returns whether there were some.
bool decided(llvm::Module& module);

/// Flags of source/program.hpp.
unsigned flags_of(const llvm::Instruction& at);

/// "mine.c:12", or the module's file.
std::string place_of(const llvm::Instruction& at);

}  // namespace mmverify::source
