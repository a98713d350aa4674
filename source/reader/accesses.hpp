// Accesses of variables, kept from LLVM's passes where they may lie outside.
#pragma once

#include <llvm/IR/Function.h>

#include <vector>

namespace mmverify::source {

/// Calls that keep variables without pointers out of passes' reach, until they are erased: the others become values first, so
/// that it is known which variable a pointer leads to.
std::vector<llvm::Instruction*> keep_variables(llvm::Function& function);

/// Forbids, in so many words, each access of a variable or its row that may lie outside: passes would take it for none.
/// Throws NotKnown: a number taken for one of another type.
void guard_accesses(llvm::Function& function);

}  // namespace mmverify::source
