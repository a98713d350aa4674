// Buffers of bytes at odd addresses: a run then shows whether a codec reads words at any address.
#pragma once

#include <llvm/IR/Module.h>

namespace mmverify::source::executor {

/// Moves each variable that is an array of bytes to an odd address, with one more byte before it.
void move_to_odd_addresses(llvm::Module& module);

}  // namespace mmverify::source::executor
