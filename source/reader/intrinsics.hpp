// LLVM's intrinsics that are one operation each.
#pragma once

#include <llvm/IR/Intrinsics.h>

#include <optional>
#include <utility>

#include "source/program.hpp"

namespace mmverify::source {

/// The operation, and how many of the call's arguments are its operands.
std::optional<std::pair<Op, unsigned>> plain_intrinsic(llvm::Intrinsic::ID id);

}  // namespace mmverify::source
