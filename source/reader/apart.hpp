// Accesses that C lets compilers take for apart: of one variable by two types, and by two pointers of which one is restricted.
#pragma once

#include <llvm/IR/Function.h>

#include "source/reader/pointers.hpp"

namespace mmverify::source {

/// Refuses those of which it is not known that they are apart, or that nobody is told so.
void refuse_types(llvm::Function& function, const Pointers& pointers);

}  // namespace mmverify::source
