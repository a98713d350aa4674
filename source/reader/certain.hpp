// Makes operations plain again that nothing undefined can reach.
#pragma once

#include <llvm/IR/Function.h>

namespace mmverify::source {

/// Makes plain instructions of the function's guarded ones (undefined.hpp) that nothing undefined comes into, and drops what
/// guards them.  The rest stay calls, whatever passes do.
void make_certain_plain(llvm::Function& function);

}  // namespace mmverify::source
