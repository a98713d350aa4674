// A function's loops, the order of its blocks, and the values that each block needs.
#pragma once

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/IR/Dominators.h>

#include <map>
#include <set>

namespace mmverify::source::executor {

class Shape {
 public:
  explicit Shape(llvm::Function& function);

  const llvm::Loop* loop_of(const llvm::BasicBlock* block) const { return loops_.getLoopFor(block); }
  /// Every edge but those back to a loop's head rises.
  unsigned order(const llvm::BasicBlock* block) const { return order_.at(block); }
  bool is_live(const llvm::BasicBlock* block, const llvm::Value* value) const {
    return live_.at(block).contains(value);
  }

 private:
  llvm::DominatorTree dominators_;
  llvm::LoopInfo loops_;
  std::map<const llvm::BasicBlock*, unsigned> order_;
  std::map<const llvm::BasicBlock*, std::set<const llvm::Value*>> live_;
};

}  // namespace mmverify::source::executor
