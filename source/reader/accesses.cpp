#include "source/reader/accesses.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Transforms/Utils/Local.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include <algorithm>
#include <vector>

#include "source/reader/apart.hpp"
#include "source/reader/pointers.hpp"
#include "source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

using I = llvm::Instruction;

/// Whether a pointer may be loaded from the variable; SROA replaces such variables first.
bool is_holder(const llvm::Value* base) {
  const auto* call = llvm::dyn_cast<llvm::CallInst>(base);
  const auto* variable = llvm::dyn_cast<llvm::AllocaInst>(call != nullptr ? call->getArgOperand(0) : base);
  return variable != nullptr && holds_pointers(variable->getAllocatedType());
}

std::vector<I*> all_of(llvm::Function& function) {
  std::vector<I*> all;
  for (I& at : llvm::instructions(function)) all.push_back(&at);
  return all;
}

/// A variable of one bit that is 1 during the lifetime of `variable`; null if it has no lifetime marks. The
/// caller erases the marks: stores of the variable's content at each mark exist already.
llvm::AllocaInst* lifetime_of(llvm::AllocaInst& variable, const std::vector<llvm::IntrinsicInst*>& marks) {
  llvm::AllocaInst* alive = nullptr;
  for (llvm::IntrinsicInst* mark : marks) {
    if (mark->getArgOperand(1)->stripPointerCasts() != &variable) continue;
    llvm::IRBuilder<> build(&variable);
    if (alive == nullptr) {
      alive = build.CreateAlloca(build.getInt1Ty());
      build.CreateStore(build.getFalse(), alive);
    }
    build.SetInsertPoint(mark);
    build.CreateStore(build.getInt1(mark->getIntrinsicID() == llvm::Intrinsic::lifetime_start), alive);
  }
  return alive;
}

void hide_variables(llvm::Function& function) {
  std::vector<llvm::AllocaInst*> variables;
  std::vector<llvm::IntrinsicInst*> marks;
  for (I* at : all_of(function)) {
    if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(at)) variables.push_back(variable);
    if (at->isLifetimeStartOrEnd()) marks.push_back(llvm::cast<llvm::IntrinsicInst>(at));
  }
  std::vector<std::pair<llvm::AllocaInst*, llvm::AllocaInst*>> lives;
  for (llvm::AllocaInst* variable : variables) lives.emplace_back(variable, lifetime_of(*variable, marks));
  for (llvm::IntrinsicInst* mark : marks) mark->eraseFromParent();
  for (const auto& [variable, alive] : lives) {
    if (variable->isArrayAllocation()) continue;
    llvm::IRBuilder<> build(variable->getNextNode());
    auto* bit = llvm::Type::getInt1PtrTy(function.getContext());
    llvm::CallInst* call =
        hidden(build, variable,
               alive != nullptr ? static_cast<llvm::Value*>(alive) : llvm::ConstantPointerNull::get(bit));
    variable->replaceUsesWithIf(call, [&](const llvm::Use& use) { return use.getUser() != call; });
  }
}

void show_variables(llvm::Function& function, bool holders) {
  for (I* at : all_of(function)) {
    auto* call = llvm::dyn_cast<llvm::CallInst>(at);
    if (call == nullptr || guarded(*call) != Guarded::variable || is_holder(call) != holders) continue;
    call->replaceAllUsesWith(call->getArgOperand(0));
    call->eraseFromParent();
  }
}

class Guards {
 public:
  Guards(llvm::Function& function, bool holders)
      : function_(function),
        layout_(function.getParent()->getDataLayout()),
        pointers_(function),
        holders_(holders) {}

  void run() {
    const std::vector<I*> all = all_of(function_);
    if (!holders_) refuse_types(function_, pointers_);
    for (I* at : all) {
      if (auto* load = llvm::dyn_cast<llvm::LoadInst>(at))
        access(*at, load->getPointerOperand(), size_of(load->getType()));
      else if (auto* store = llvm::dyn_cast<llvm::StoreInst>(at); store != nullptr && !begins(*store))
        access(*at, store->getPointerOperand(), size_of(store->getValueOperand()->getType()));
      else if (auto* moved = llvm::dyn_cast<llvm::MemIntrinsic>(at)) {
        access(*at, moved->getRawDest(), moved->getLength());
        if (auto* copied = llvm::dyn_cast<llvm::MemTransferInst>(at))
          access(*at, copied->getRawSource(), copied->getLength());
      }
    }
  }

 private:
  llvm::Value* size_of(llvm::Type* t) const {
    return llvm::ConstantInt::get(llvm::Type::getInt64Ty(function_.getContext()),
                                  layout_.getTypeStoreSize(t));
  }
  /// Whether the store sets a variable's initial content (undefined.cpp), or its lifetime.
  static bool begins(const llvm::StoreInst& store) {
    const auto* set = llvm::dyn_cast<llvm::CallInst>(store.getValueOperand());
    return (set != nullptr && guarded(*set) == Guarded::unset) ||
           llvm::isa<llvm::AllocaInst>(store.getPointerOperand());
  }

  void access(I& at, llvm::Value* pointer, llvm::Value* bytes) {
    const Reach reach = pointers_.reach(pointer);
    llvm::IRBuilder<> build(&at);
    const bool all_holders =
        reach.known && !reach.bases.empty() && std::all_of(reach.bases.begin(), reach.bases.end(), is_holder);
    // The first run handles accesses of holders only. The second skips accesses that the first has guarded,
    // and lifetimes.
    if (holders_ ? !all_holders : shown(reach)) return;
    if (!reach.known || some_shown(reach)) return refuse(build, Refusal::pointer);
    if (is_plain(pointer)) return;
    const Place& place = pointers_.place(pointer);
    const bool moves = llvm::isa<llvm::MemIntrinsic>(at);
    bytes = build.CreateZExtOrTrunc(bytes, build.getInt64Ty());
    forbid_outside(build,
                   build.CreateOr(place.wrong, Pointers::beyond(build, moves ? place.in_whole : place.offset,
                                                                bytes, moves ? place.whole : place.size)),
                   std::any_of(reach.bases.begin(), reach.bases.end(), is_table) ? Outside::of_table
                                                                                 : Outside::of_variable);
    llvm::Value* ended = build.getFalse();
    for (llvm::Value* base : reach.bases) {
      const auto* call = llvm::dyn_cast<llvm::CallInst>(base);
      auto* alive = call == nullptr ? nullptr : llvm::dyn_cast<llvm::AllocaInst>(call->getArgOperand(1));
      if (alive == nullptr) continue;
      llvm::Value* gone = build.CreateNot(build.CreateLoad(build.getInt1Ty(), alive));
      if (reach.bases.size() > 1)
        gone = build.CreateAnd(gone, build.CreateICmpEQ(place.base, pointers_.number(base)));
      ended = build.CreateOr(ended, gone);
    }
    forbid_outside(build, ended, Outside::of_lifetime);
  }

  static bool is_table(const llvm::Value* base) { return llvm::isa<llvm::GlobalVariable>(base); }
  static bool is_shown(const llvm::Value* base) { return llvm::isa<llvm::AllocaInst>(base); }
  static bool shown(const Reach& reach) {
    return reach.known && !reach.bases.empty() &&
           std::all_of(reach.bases.begin(), reach.bases.end(), is_shown);
  }
  static bool some_shown(const Reach& reach) {
    return std::any_of(reach.bases.begin(), reach.bases.end(), is_shown);
  }
  /// Whether the pointer is one step from a table's start: the translator checks the bounds of each row.
  static bool is_plain(llvm::Value* pointer) {
    auto* step = llvm::dyn_cast<llvm::GEPOperator>(pointer);
    if (step == nullptr) return false;
    llvm::Value* from = step->getPointerOperand();
    if (auto* call = llvm::dyn_cast<llvm::CallInst>(from);
        call != nullptr && guarded(*call) == Guarded::address)
      from = call->getArgOperand(0);
    const auto* none = llvm::dyn_cast<llvm::ConstantInt>(step->idx_begin()->get());
    return llvm::isa<llvm::GlobalVariable>(from) && none != nullptr && none->isZero();
  }

  llvm::Function& function_;
  const llvm::DataLayout& layout_;
  Pointers pointers_;
  bool holders_;
};

}  // namespace

void promote_pointers(llvm::Function& function) {
  std::vector<llvm::AllocaInst*> all;
  for (I& at : llvm::instructions(function))
    if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(&at); variable != nullptr &&
                                                                variable->getAllocatedType()->isPointerTy() &&
                                                                llvm::isAllocaPromotable(variable))
      all.push_back(variable);
  llvm::DominatorTree tree(function);
  llvm::PromoteMemToReg(all, tree);
}

void guard_accesses(llvm::Function& function, const std::function<void()>& sroa) {
  llvm::removeUnreachableBlocks(function);
  hide_variables(function);
  Guards(function, true).run();
  show_variables(function, true);
  sroa();
  Guards(function, false).run();
  show_variables(function, false);
}

}  // namespace mmverify::source
