#include "subjects/source/executor/reasons.hpp"

#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/DebugLoc.h>
#include <llvm/IR/Function.h>

namespace mmverify::source::executor {

std::string place_of(const llvm::Instruction& at) {
  if (const llvm::DebugLoc& place = at.getDebugLoc())
    if (const auto* scope = llvm::dyn_cast<llvm::DIScope>(place.getScope()))
      return scope->getFilename().str() + ":" + std::to_string(place.getLine());
  return at.getFunction()->getName().str();
}

}  // namespace mmverify::source::executor
