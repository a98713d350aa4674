// LLVM's passes, by their names.
#pragma once

#include <llvm/IR/Module.h>

#include <string>

namespace mmverify::source {

/// Runs a pipeline, written as for `opt -passes=`.
void run_passes(llvm::Module& module, const std::string& pipeline);

}  // namespace mmverify::source
