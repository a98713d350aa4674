// Variables whose declaration is jumped over: LLVM's bitcode does not say when they begin.
#pragma once

#include <llvm/IR/Function.h>

namespace mmverify::source {

/// Throws NotKnown, with the line of a use, if such a variable is used in a loop, where it may keep its value
/// of an earlier iteration.
/// Domain: a function as the front end made it.
void check_lifetimes(llvm::Function& function);

}  // namespace mmverify::source
