// Requirements of C and of the bitcode's attributes on pointers and arguments, whether or not anybody reads through them:
// a pointer stays within its variable, an argument is not null, and the like.
#pragma once

#include <llvm/IR/InstrTypes.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>

namespace mmverify::source {

/// Guards a step of a pointer: it must not leave what it points into.
void guard_step(llvm::GetElementPtrInst& step);
/// Guards pointers that an instruction reads from a variable, compares or converts: they must be set.
void guard_pointers_read(llvm::Instruction& at);
/// Guards what a load's metadata says of the pointer that it loads. Call it before the metadata is dropped.
void guard_pointer_loaded(llvm::Instruction& at);
/// Guards the attributes of a call's arguments and of its result.
void guard_promises(llvm::CallBase& call);
/// Guards the pointers of a copy or fill whose length may be 0: C forbids null pointers even then (C17, 7.24.1).
void guard_moved(llvm::MemIntrinsic& moved);
/// Guards what an assumption says of pointers. Throws NotKnown for what is not known.
void guard_assumed_pointers(llvm::IntrinsicInst& assumption);

}  // namespace mmverify::source
