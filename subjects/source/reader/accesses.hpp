// Guards accesses of variables and tables that may be out of bounds, so that LLVM's passes do not assume they
// are not.
#pragma once

#include <llvm/IR/Function.h>

#include <functional>

namespace mmverify::source {

/// Turns variables that are pointers into values.
void promote_pointers(llvm::Function& function);

/// Adds a guard to each access that may be outside its variable, table, row or member, or outside the
/// variable's lifetime: passes would assume that it never is. Refuses an access whose target is not known,
/// and accesses that C lets compilers assume to be distinct. `sroa`: runs LLVM's pass of that name.
/// Domain: a function without calls.
void guard_accesses(llvm::Function& function, const std::function<void()>& sroa);

}  // namespace mmverify::source
