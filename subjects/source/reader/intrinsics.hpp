// LLVM's intrinsics that are one operation.
#pragma once

#include <llvm/IR/Intrinsics.h>

#include <optional>
#include <utility>

#include "subjects/source/program.hpp"

namespace mmverify::source {

/// The operation of an intrinsic, and the number of its operands among the call's arguments.
std::optional<std::pair<Op, unsigned>> plain_intrinsic(llvm::Intrinsic::ID id);

}  // namespace mmverify::source
