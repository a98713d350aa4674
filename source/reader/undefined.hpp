// Undefined behaviour, kept from LLVM's passes: each operation becomes a call that they know nothing of, before any of them
// runs.  What cannot be undefined is made plain again (certain.hpp), so that loops have their counts.
#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstrTypes.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/Module.h>

#include <string>

namespace mmverify::source {

/// What such a call stands for.
enum class Guarded {
  none,
  operation,  ///< (opcode, detail, operands...): an instruction; detail: flags, a comparison's predicate, an intrinsic's number.
              ///< Of opcode Load: a variable's value, which is poison where it was never set
  unset,      ///< what memory holds before it is set
  address,    ///< (pointer): of a table
  variable,   ///< (pointer, its Lifetime): of a variable, as long as no pass may look into it
  apart,      ///< (whether it is restricted, pointer, ...): a call's pointers
  refused,    ///< (Refusal): what stands there is not judged
  overflow,   ///< (opcode, flags, a, b): forbidden where a sum, difference or product of words does not fit
  branch,     ///< (condition): forbidden where it is undefined
  outside,    ///< (condition, Outside): forbidden
  unreachable,  ///< a place that must not be reached
  assumption,   ///< (condition)
};
Guarded guarded(const llvm::CallInst& call);

/// The rule that an access breaks.
enum class Outside : unsigned { of_variable, of_table, of_lifetime, of_type };
/// Why an access is not judged.
enum class Refusal : unsigned { pointer, types, restricted, scopes };

/// An argument that is a constant number.
unsigned word_of(const llvm::CallInst& call, unsigned k);

/// Makes them, in all functions of the module.  Throws NotKnown: what passes would decide in another way than the compiled
/// code does, such as whether the level is a constant.
void guard(llvm::Module& module);

/// A value that nobody has set: an opaque call.
llvm::CallInst* never_set(llvm::IRBuilder<>& build, llvm::Type* type);
void forbid_outside(llvm::IRBuilder<>& build, llvm::Value* condition, Outside what);
void refuse(llvm::IRBuilder<>& build, Refusal why);
/// Hides a variable; `alive`: a variable of one bit that says whether its lifetime is on, or null.
llvm::CallInst* hidden(llvm::IRBuilder<>& build, llvm::Value* variable, llvm::Value* alive);

/// Whether it is a division or a remainder of words, which is undefined by itself.
bool divides(unsigned opcode);

/// Flags of source/program.hpp.
unsigned flags_of(const llvm::Instruction& at);

/// "mine.c:12", or the module's file.
std::string place_of(const llvm::Instruction& at);
std::string place_of(const llvm::Function& f);

}  // namespace mmverify::source
