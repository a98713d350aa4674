// Accesses of variables and tables, kept from LLVM's passes where they may lie outside.
#pragma once

#include <llvm/IR/Function.h>

#include <functional>

namespace mmverify::source {

/// Makes values of variables that hold pointers.
void promote_pointers(llvm::Function& function);

/// Forbids, in so many words, each access of a variable, a table or a row or member of either that may lie outside, or may
/// come when the variable is no more: passes would take it for none.  Refuses those that are not known to have none of
/// that, and those that C lets compilers take for apart.  `sroa`: runs LLVM's pass of that name.
/// Domain: a function without calls.
void guard_accesses(llvm::Function& function, const std::function<void()>& sroa);

}  // namespace mmverify::source
