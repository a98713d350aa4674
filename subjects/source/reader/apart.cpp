#include "subjects/source/reader/apart.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

#include <algorithm>
#include <vector>

#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

using I = llvm::Instruction;

/// An access with its type, a node of TBAA metadata.
struct Typed {
  I* at;
  Reach reach;
  std::uint64_t bytes;
  const llvm::MDNode* type;
};

/// The type accessed by a TBAA tag, with or without a struct path.
const llvm::MDNode* type_of(const llvm::MDNode& tag) {
  const bool has_path = tag.getNumOperands() >= 3 && llvm::isa<llvm::MDNode>(tag.getOperand(0));
  return has_path ? llvm::dyn_cast<llvm::MDNode>(tag.getOperand(1)) : &tag;
}
const llvm::MDNode* parent_of(const llvm::MDNode& type) {
  return type.getNumOperands() < 2 ? nullptr : llvm::dyn_cast_or_null<llvm::MDNode>(type.getOperand(1));
}
bool is_within(const llvm::MDNode* type, const llvm::MDNode* other) {
  for (; type != nullptr; type = parent_of(*type))
    if (type == other) return true;
  return false;
}

/// A copy of a struct accesses each of its members.
void add_members(I& at, llvm::Value* pointer, const Pointers& pointers, std::vector<Typed>& all) {
  const llvm::MDNode* members = at.getMetadata(llvm::LLVMContext::MD_tbaa_struct);
  for (unsigned k = 0; members != nullptr && k + 2 < members->getNumOperands(); k += 3) {
    const auto number = [&](unsigned of) {
      return llvm::mdconst::extract<llvm::ConstantInt>(members->getOperand(of))->getZExtValue();
    };
    Reach reach = pointers.reach(pointer);
    reach.first += static_cast<std::int64_t>(number(k));
    if (const auto* tag = llvm::dyn_cast<llvm::MDNode>(members->getOperand(k + 2)))
      all.push_back({&at, reach, number(k + 1), type_of(*tag)});
  }
}

std::vector<Typed> typed_accesses(llvm::Function& function, const Pointers& pointers) {
  const llvm::DataLayout& layout = function.getParent()->getDataLayout();
  std::vector<Typed> all;
  for (I& at : llvm::instructions(function)) {
    if (auto* moved = llvm::dyn_cast<llvm::MemTransferInst>(&at)) {
      add_members(at, moved->getRawDest(), pointers, all);
      add_members(at, moved->getRawSource(), pointers, all);
    } else if (const llvm::MDNode* tag = at.getMetadata(llvm::LLVMContext::MD_tbaa)) {
      llvm::Value* pointer = llvm::getLoadStorePointerOperand(&at);
      if (pointer == nullptr) continue;
      all.push_back({&at, pointers.reach(pointer),
                     layout.getTypeStoreSize(llvm::getLoadStoreType(&at)).getFixedSize(), type_of(*tag)});
    }
  }
  return all;
}

/// Whether both may reach the same variable; constant tables do not count, as they are never written.
bool have_a_common_variable(const Reach& a, const Reach& b) {
  return std::any_of(a.bases.begin(), a.bases.end(), [&](llvm::Value* base) {
    return !llvm::isa<llvm::GlobalVariable>(base) && b.bases.count(base) != 0;
  });
}

void refuse_two_types(llvm::Function& function, const Pointers& pointers) {
  const std::vector<Typed> all = typed_accesses(function, pointers);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Typed& b = all[k];
    const bool any =
        std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k), [&](const Typed& a) {
          return a.type != b.type && !is_within(a.type, b.type) && !is_within(b.type, a.type) &&
                 have_a_common_variable(a.reach, b.reach) && overlap(a.reach, a.bytes, b.reach, b.bytes);
        });
    if (!any) continue;
    llvm::IRBuilder<> build(b.at);
    refuse(build, Refusal::types);
  }
}

/// Whether a restricted pointer of the call may reach a variable that another pointer reaches.
bool may_meet(const llvm::CallInst& call, const Pointers& pointers) {
  for (unsigned k = 0; k < call.arg_size(); k += 2) {
    if (!llvm::cast<llvm::ConstantInt>(call.getArgOperand(k))->isOne()) continue;
    const Reach one = pointers.reach(call.getArgOperand(k + 1));
    for (unsigned other = 0; other < call.arg_size(); other += 2) {
      if (other == k) continue;
      const Reach reach = pointers.reach(call.getArgOperand(other + 1));
      if (!one.known || !reach.known || have_a_common_variable(one, reach) ||
          holds_pointers(call.getArgOperand(other + 1)->getType()->getPointerElementType()))
        return true;
    }
  }
  return false;
}

}  // namespace

void refuse_types(llvm::Function& function, const Pointers& pointers) {
  refuse_two_types(function, pointers);
  std::vector<llvm::CallInst*> calls;
  for (I& at : llvm::instructions(function))
    if (auto* call = llvm::dyn_cast<llvm::CallInst>(&at); call != nullptr && guarded(*call) == Guarded::apart)
      calls.push_back(call);
  for (llvm::CallInst* call : calls) {
    llvm::IRBuilder<> build(call);
    if (may_meet(*call, pointers)) refuse(build, Refusal::restricted);
    call->eraseFromParent();
  }
  for (I& at : llvm::instructions(function)) {
    at.setMetadata(llvm::LLVMContext::MD_tbaa, nullptr);
    at.setMetadata(llvm::LLVMContext::MD_tbaa_struct, nullptr);
  }
}

}  // namespace mmverify::source
