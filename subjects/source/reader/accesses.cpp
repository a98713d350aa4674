#include "subjects/source/reader/accesses.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Transforms/Utils/Local.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include <algorithm>
#include <vector>

#include "subjects/source/reader/apart.hpp"
#include "subjects/source/reader/pointers.hpp"
#include "subjects/source/reader/undefined.hpp"

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
      } else if (auto* call = llvm::dyn_cast<llvm::CallInst>(at);
                 call != nullptr && guarded(*call) == Guarded::pointer) {
        required(*call);
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
    if (holders_ ? !all_holders(reach) : shown(reach)) return;
    llvm::IRBuilder<> build(&at);
    if (!reach.known || some_shown(reach)) return refuse(build, Refusal::pointer);
    const PointerExtent& place = pointers_.place(pointer);
    const bool moves = llvm::isa<llvm::MemIntrinsic>(at);
    bytes = build.CreateZExtOrTrunc(bytes, build.getInt64Ty());
    llvm::Value* outside = Pointers::beyond(build, moves ? place.in_whole : place.offset, bytes,
                                            moves ? place.whole : place.size);
    forbid_outside(build, build.CreateOr(place.wrong, outside),
                   std::any_of(reach.bases.begin(), reach.bases.end(), is_table) ? Outside::of_table
                                                                                 : Outside::of_variable);
    forbid_outside(build, ended(build, reach, place), Outside::of_lifetime);
  }

  /// Whether the lifetime of the variable that a pointer leads to has ended, or not begun.
  llvm::Value* ended(llvm::IRBuilder<>& build, const Reach& reach, const PointerExtent& place) {
    llvm::Value* any = build.getFalse();
    for (llvm::Value* base : reach.bases) {
      const auto* call = llvm::dyn_cast<llvm::CallInst>(base);
      auto* alive = call == nullptr ? nullptr : llvm::dyn_cast<llvm::AllocaInst>(call->getArgOperand(1));
      if (alive == nullptr) continue;
      llvm::Value* gone = build.CreateNot(build.CreateLoad(build.getInt1Ty(), alive));
      if (reach.bases.size() > 1)
        gone = build.CreateAnd(gone, build.CreateICmpEQ(place.base, pointers_.number(base)));
      any = build.CreateOr(any, gone);
    }
    return any;
  }

  /// Guards what is required of a pointer, and erases the call once that is written.
  void required(llvm::CallInst& call) {
    const Reach reach = pointers_.reach(call.getArgOperand(0));
    if (holders_ && !all_holders(reach)) return;
    llvm::IRBuilder<> build(&call);
    if (!holders_ && shown(reach)) {
      // The first run has guarded it.
    } else if (!reach.known || some_shown(reach)) {
      refuse(build, Refusal::pointer);
    } else {
      required(build, reach, pointers_.place(call.getArgOperand(0)), static_cast<Required>(word_of(call, 1)),
               llvm::cast<llvm::ConstantInt>(call.getArgOperand(2))->getZExtValue());
    }
    call.eraseFromParent();
  }

  void required(llvm::IRBuilder<>& build, const Reach& reach, const PointerExtent& place, Required what,
                std::uint64_t number) {
    switch (what) {
      case Required::set:
        return forbid_outside(build, build.CreateICmpEQ(place.base, Pointers::never_set(build)),
                              Outside::of_set);
      case Required::not_null:
        return forbid_outside(build, Pointers::nowhere(build, place), Outside::of_null);
      case Required::bytes:
        forbid_outside(build,
                       build.CreateOr(place.wrong, Pointers::beyond(build, place.in_whole,
                                                                    build.getInt64(number), place.whole)),
                       Outside::of_promise);
        return forbid_outside(build, ended(build, reach, place), Outside::of_lifetime);
      case Required::aligned:
        if (!std::all_of(reach.bases.begin(), reach.bases.end(),
                         [&](llvm::Value* base) { return alignment_of(base) >= number; }))
          return refuse(build, Refusal::alignment);
        return forbid_outside(build,
                              build.CreateICmpNE(build.CreateAnd(place.in_whole, build.getInt64(number - 1)),
                                                 build.getInt64(0)),
                              Outside::of_promise);
      default:
        return forbid_outside(build, Pointers::left(build, place, what == Required::in_whole),
                              Outside::of_step);
    }
  }

  std::uint64_t alignment_of(llvm::Value* base) const {
    if (const auto* call = llvm::dyn_cast<llvm::CallInst>(base)) base = call->getArgOperand(0);
    if (const auto* variable = llvm::dyn_cast<llvm::AllocaInst>(base)) return variable->getAlign().value();
    return llvm::cast<llvm::GlobalVariable>(base)->getPointerAlignment(layout_).value();
  }

  static bool all_holders(const Reach& reach) {
    return reach.known && !reach.bases.empty() &&
           std::all_of(reach.bases.begin(), reach.bases.end(), is_holder);
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
