// Accesses of variables, kept from LLVM's passes where they may lie outside.
#pragma once

#include <llvm/IR/Function.h>

namespace mmverify::source {

/// Makes values of variables that hold pointers.
void promote_pointers(llvm::Function& function);

/// Forbids, in so many words, each access of a variable or its row that may lie outside: passes would take it for none.
void guard_accesses(llvm::Function& function);

}  // namespace mmverify::source
