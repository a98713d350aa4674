// Restores operations that no undefined value can reach.
#pragma once

#include <llvm/IR/Function.h>

namespace mmverify::source {

/// Turns guarded operations (undefined.hpp) that no undefined value can reach into plain instructions, and
/// drops their guards. The other ones stay calls, opaque to passes.
void make_certain_plain(llvm::Function& function);

}  // namespace mmverify::source
