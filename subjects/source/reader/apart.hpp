// Accesses that C lets compilers assume to be distinct: one variable by two types, or two pointers of which
// one is restricted.
#pragma once

#include <llvm/IR/Function.h>

#include "subjects/source/reader/pointers.hpp"

namespace mmverify::source {

/// Refuses such accesses unless they are known to be distinct, and drops the metadata that would let passes
/// assume it.
void refuse_types(llvm::Function& function, const Pointers& pointers);

}  // namespace mmverify::source
