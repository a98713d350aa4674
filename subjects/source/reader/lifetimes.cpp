#include "subjects/source/reader/lifetimes.hpp"

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/IR/CFG.h>
#include <llvm/IR/DebugInfo.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

#include <set>
#include <vector>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

/// The uses of a variable: instructions that set it, and others that read it or pass its address on.
struct Uses {
  std::vector<llvm::Instruction*> sets, others;
  bool marked = false;  ///< the bitcode marks its start

  void collect(llvm::Value& pointer) {
    for (llvm::User* user : pointer.users()) {
      auto* at = llvm::dyn_cast<llvm::Instruction>(user);
      if (at == nullptr) continue;
      const auto* call = llvm::dyn_cast<llvm::CallBase>(at);
      if (at->isLifetimeStartOrEnd())
        marked = true;
      else if (llvm::isa<llvm::BitCastInst>(at) || llvm::isa<llvm::GetElementPtrInst>(at))
        collect(*at);
      else if (const auto* store = llvm::dyn_cast<llvm::StoreInst>(at);
               store != nullptr && store->getPointerOperand() == &pointer)
        sets.push_back(at);
      else if (const auto* moved = llvm::dyn_cast<llvm::MemIntrinsic>(at);
               moved != nullptr && moved->getRawDest() == &pointer)
        sets.push_back(at);
      else if (call != nullptr && call->hasStructRetAttr() && call->getArgOperand(0) == &pointer)
        sets.push_back(at);
      else
        others.push_back(at);
    }
  }
};

/// Whether every path from the loop's head to the use passes an instruction that sets the variable.
bool is_set_before(const llvm::Instruction& use, const std::vector<llvm::Instruction*>& sets,
                   const llvm::Loop& loop) {
  std::set<const llvm::BasicBlock*> setting, seen;
  for (const llvm::Instruction* one : sets) {
    if (one->getParent() == use.getParent() && one->comesBefore(&use)) return true;
    setting.insert(one->getParent());
  }
  std::vector<const llvm::BasicBlock*> next{use.getParent()};
  while (!next.empty()) {
    const llvm::BasicBlock* block = next.back();
    next.pop_back();
    if (block == loop.getHeader()) return false;
    for (const llvm::BasicBlock* before : llvm::predecessors(block))
      if (setting.count(before) == 0 && seen.insert(before).second) next.push_back(before);
  }
  return true;
}

bool is_parameter(llvm::AllocaInst& variable) {
  for (const llvm::DbgVariableIntrinsic* declared : llvm::FindDbgAddrUses(&variable))
    if (declared->getVariable()->isParameter()) return true;
  return false;
}

}  // namespace

void check_lifetimes(llvm::Function& function) {
  // Other front ends, and clang without -O, mark no lifetimes.
  if (function.getParent()->getFunction("llvm.lifetime.start.p0i8") == nullptr) return;
  const llvm::DominatorTree tree(function);
  const llvm::LoopInfo loops(tree);
  if (loops.empty()) return;
  for (llvm::Instruction& at : llvm::instructions(function)) {
    auto* variable = llvm::dyn_cast<llvm::AllocaInst>(&at);
    if (variable == nullptr || is_parameter(*variable)) continue;
    Uses uses;
    uses.collect(*variable);
    if (uses.marked) continue;
    for (const llvm::Instruction* use : uses.others)
      for (const llvm::Loop* loop = loops.getLoopFor(use->getParent()); loop != nullptr;
           loop = loop->getParentLoop())
        if (!is_set_before(*use, uses.sets, *loop))
          throw NotKnown(place_of(*use) + ": " + use->getOpcodeName() +
                         ": a variable whose declaration is jumped past, in a loop");
  }
}

}  // namespace mmverify::source
