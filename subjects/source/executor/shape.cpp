#include "subjects/source/executor/shape.hpp"

#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/IR/CFG.h>
#include <llvm/IR/Instructions.h>

namespace mmverify::source::executor {
namespace {

bool is_register(const llvm::Value* v) {
  return llvm::isa<llvm::Instruction>(v) || llvm::isa<llvm::Argument>(v);
}

using Live = std::set<const llvm::Value*>;

/// Values that the block needs or makes in its phis, given what its successors need.
Live needed_by(const llvm::BasicBlock& block, std::map<const llvm::BasicBlock*, Live>& live) {
  Live all;
  for (const llvm::BasicBlock* next : llvm::successors(&block)) {
    Live here = live[next];
    for (const llvm::PHINode& phi : next->phis()) here.erase(&phi);
    for (const llvm::PHINode& phi : next->phis())
      if (const llvm::Value* v = phi.getIncomingValueForBlock(&block); is_register(v)) here.insert(v);
    all.insert(here.begin(), here.end());
  }
  for (auto at = block.rbegin(); at != block.rend(); ++at) {
    all.erase(&*at);
    if (llvm::isa<llvm::PHINode>(*at)) continue;
    for (const llvm::Use& use : at->operands())
      if (is_register(use.get())) all.insert(use.get());
  }
  for (const llvm::PHINode& phi : block.phis()) all.insert(&phi);
  return all;
}

}  // namespace

Shape::Shape(llvm::Function& function) {
  dominators_.recalculate(function);
  loops_.analyze(dominators_);
  unsigned number = 0;
  for (const llvm::BasicBlock* block : llvm::ReversePostOrderTraversal<llvm::Function*>(&function))
    order_[block] = number++;
  for (bool changed = true; changed;) {
    changed = false;
    for (const llvm::BasicBlock& block : function) {
      Live here = needed_by(block, live_);
      if (here == live_[&block]) continue;
      live_[&block] = std::move(here);
      changed = true;
    }
  }
}

}  // namespace mmverify::source::executor
