// Hides undefined behaviour from LLVM's passes: before any of them runs, each operation becomes an opaque
// call. Operations that cannot be undefined are made plain again (certain.hpp), so that loops have their
// counts.
#pragma once

#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstrTypes.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/Module.h>

#include <string>

namespace mmverify::source {

/// The kinds of opaque calls, with their arguments.
enum class Guarded {
  none,
  operation,    ///< (opcode, detail, operands...); detail: flags, predicate or intrinsic's number.
                ///< Opcode Load: a variable's value, which is poison if it was never set
  unset,        ///< the content of memory before it is set
  address,      ///< (pointer): of a table
  variable,     ///< (pointer, its lifetime bit): a variable, while no pass may look into it
  apart,        ///< (whether it is restricted, pointer, ...): the pointers of a call
  refused,      ///< (Refusal): the code there is not judged
  overflow,     ///< (opcode, flags, a, b): forbidden if a sum, difference or product of words overflows
  branch,       ///< (condition): forbidden if it is undefined
  outside,      ///< (condition, Outside): forbidden if it holds
  unreachable,  ///< a place that must not be reached
  assumption,   ///< (condition): forbidden if it does not hold
  argument,     ///< (value): forbidden if any bit of it is undefined
  pointer,      ///< (pointer, Required, number): forbidden if the pointer is another one
};
Guarded guarded(const llvm::CallInst& call);

/// The rule that an access breaks.
enum class Outside : unsigned {
  of_variable,
  of_table,
  of_lifetime,
  of_type,
  of_step,
  of_set,
  of_null,
  of_promise
};
/// A requirement on a pointer by itself: it is set, is not null, leads to so many bytes, is a multiple of
/// a number, lies within its variable or behind its last byte, or so in its row or member.
enum class Required : unsigned { set, not_null, bytes, aligned, in_whole, in_part };
/// The reason why an access is not judged.
enum class Refusal : unsigned { pointer, types, restricted, scopes, alignment };

/// Argument k of the call, a constant number.
unsigned word_of(const llvm::CallInst& call, unsigned k);

/// Replaces the operations of all functions of the module by opaque calls. Throws NotKnown for code that
/// passes may decide in another way than the compiled code does, such as whether the level is a constant.
void guard(llvm::Module& module);

/// A value that was never set: an opaque call.
llvm::CallInst* never_set(llvm::IRBuilder<>& build, llvm::Type* type);
/// Gives the opaque functions of such values bodies, so that the module can be run: any value will do.
void define_unset(llvm::Module& module);
void forbid_outside(llvm::IRBuilder<>& build, llvm::Value* condition, Outside what);
void refuse(llvm::IRBuilder<>& build, Refusal why);
void require(llvm::IRBuilder<>& build, llvm::Value* pointer, Required what, std::uint64_t number);
/// Requires a value that is no pointer to be set.
void require_set(llvm::IRBuilder<>& build, llvm::Value* value);
/// Hides a variable; `alive`: a variable of one bit that is 1 during its lifetime, or null.
llvm::CallInst* hidden(llvm::IRBuilder<>& build, llvm::Value* variable, llvm::Value* alive);

/// Whether it is a division or a remainder of words, which is undefined for some operands even if its value
/// is unused.
bool divides(unsigned opcode);

/// The instruction's flags, as in subjects/source/program.hpp.
unsigned flags_of(const llvm::Instruction& at);

/// The line; null if unknown. A variable's is that of its declaration, or else of its first use with one.
const llvm::DILocation* line_of(const llvm::Instruction& at);
/// The place, "mine.c:12", or the module's file.
std::string place_of(const llvm::Instruction& at);
std::string place_of(const llvm::Function& f);
std::string place_of(const llvm::GlobalValue& value);

}  // namespace mmverify::source
