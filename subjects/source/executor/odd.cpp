#include "subjects/source/executor/odd.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>

#include <vector>

namespace mmverify::source::executor {

void move_to_odd_addresses(llvm::Module& module) {
  std::vector<llvm::AllocaInst*> arrays;
  for (llvm::Function& function : module)
    for (llvm::Instruction& i : llvm::instructions(function))
      if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(&i))
        if (const auto* type = llvm::dyn_cast<llvm::ArrayType>(variable->getAllocatedType());
            type != nullptr && type->getElementType()->isIntegerTy(8))
          arrays.push_back(variable);
  constexpr std::uint64_t even = 16;  // any even number would do
  for (llvm::AllocaInst* array : arrays) {
    llvm::IRBuilder<> builder(array);
    const std::uint64_t bytes = array->getAllocatedType()->getArrayNumElements();
    llvm::AllocaInst* wide = builder.CreateAlloca(llvm::ArrayType::get(builder.getInt8Ty(), bytes + 1));
    wide->setAlignment(llvm::Align(even));
    llvm::Value* moved = builder.CreateConstInBoundsGEP2_64(wide->getAllocatedType(), wide, 0, 1);
    array->replaceAllUsesWith(builder.CreateBitCast(moved, array->getType()));
    array->eraseFromParent();
  }
}

}  // namespace mmverify::source::executor
