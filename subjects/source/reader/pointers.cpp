#include "subjects/source/reader/pointers.hpp"

#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

/// An index beyond this leaves any variable, and sums of indices up to it do not overflow.
constexpr std::uint64_t farthest = std::uint64_t{1} << 40;

constexpr std::array members{&PointerExtent::offset, &PointerExtent::size,  &PointerExtent::in_whole,
                             &PointerExtent::whole,  &PointerExtent::wrong, &PointerExtent::base};

/// The kinds of pointers: `base`, a variable or table; `nowhere`, no variable; `same`, its operand; `other`,
/// the rest.
enum class Kind { base, nowhere, same, other };

Kind kind_of(llvm::Value* pointer) {
  if (auto* call = llvm::dyn_cast<llvm::CallInst>(pointer)) {
    switch (guarded(*call)) {
      case Guarded::variable: return Kind::base;
      case Guarded::unset: return Kind::nowhere;
      case Guarded::address: return Kind::same;
      default: return Kind::other;
    }
  }
  if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(pointer))
    return variable->isArrayAllocation() ? Kind::other : Kind::base;
  if (auto* table = llvm::dyn_cast<llvm::GlobalVariable>(pointer))
    return table->hasDefinitiveInitializer() ? Kind::base : Kind::other;
  if (llvm::isa<llvm::UndefValue>(pointer) || llvm::isa<llvm::ConstantPointerNull>(pointer))
    return Kind::nowhere;
  return llvm::isa<llvm::BitCastOperator>(pointer) ? Kind::same : Kind::other;
}

llvm::Type* type_of_base(llvm::Value* base) {
  if (auto* call = llvm::dyn_cast<llvm::CallInst>(base)) base = call->getArgOperand(0);
  if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(base)) return variable->getAllocatedType();
  return llvm::cast<llvm::GlobalVariable>(base)->getValueType();
}

Reach joined(const Reach& a, const Reach& b) {
  if (!a.reached) return b;
  if (!b.reached) return a;
  Reach both = a;
  both.bases.insert(b.bases.begin(), b.bases.end());
  both.known = a.known && b.known;
  if (a.bases.empty()) both.first = b.first, both.stride = b.stride;
  if (!a.bases.empty() && !b.bases.empty())
    both.stride =
        std::gcd(std::gcd(a.stride, b.stride), static_cast<std::uint64_t>(std::abs(a.first - b.first)));
  if (both.stride != 0) both.first %= static_cast<std::int64_t>(both.stride);
  return both;
}

}  // namespace

bool holds_pointers(const llvm::Type* t) {
  return t->isPointerTy() || std::any_of(t->subtype_begin(), t->subtype_end(),
                                         [](const auto* part) { return holds_pointers(part); });
}

bool overlap(const Reach& a, std::uint64_t bytes_of_a, const Reach& b, std::uint64_t bytes_of_b) {
  const std::uint64_t stride = std::gcd(a.stride, b.stride);
  const std::int64_t ahead = b.first - a.first;
  if (stride == 0)
    return ahead < static_cast<std::int64_t>(bytes_of_a) && -ahead < static_cast<std::int64_t>(bytes_of_b);
  const auto signed_stride = static_cast<std::int64_t>(stride);
  const auto rest = static_cast<std::uint64_t>((ahead % signed_stride + signed_stride) % signed_stride);
  return rest < bytes_of_a || stride - rest < bytes_of_b;
}

Pointers::Pointers(llvm::Function& function)
    : function_(function), layout_(function.getParent()->getDataLayout()) {
  std::vector<llvm::Instruction*> all;
  for (llvm::BasicBlock* block : llvm::ReversePostOrderTraversal<llvm::Function*>(&function))
    for (llvm::Instruction& at : *block)
      if (at.getType()->isPointerTy()) all.push_back(&at);
  for (bool again = true; again;) {
    again = false;
    for (llvm::Instruction* at : all) {
      const Reach before = reaches_[at];
      reaches_.erase(at);  // recomputed from the others as they are
      const Reach now = reach(at);
      again = again || !(now == before);
      reaches_[at] = now;
    }
  }
}

Reach Pointers::reach(llvm::Value* pointer) const {
  if (const auto known = reaches_.find(pointer); known != reaches_.end()) return known->second;
  Reach all;
  all.reached = true;
  switch (kind_of(pointer)) {
    case Kind::base: all.bases.insert(pointer); return all;
    case Kind::nowhere: return all;
    case Kind::same: return reach(llvm::cast<llvm::User>(pointer)->getOperand(0));
    default: break;
  }
  if (auto* step = llvm::dyn_cast<llvm::GEPOperator>(pointer)) {
    all = reach(step->getPointerOperand());
    if (all.bases.empty()) return all;  // an offset from nowhere would grow with each turn of a loop
    llvm::APInt by(64, 0);
    llvm::MapVector<llvm::Value*, llvm::APInt> open;
    if (!step->collectOffset(layout_, 64, open, by)) all.known = false;
    all.first += by.getSExtValue();
    for (const auto& [index, size] : open) all.stride = std::gcd(all.stride, size.getZExtValue());
    return all;
  }
  if (auto* choice = llvm::dyn_cast<llvm::SelectInst>(pointer))
    return joined(reach(choice->getTrueValue()), reach(choice->getFalseValue()));
  if (auto* phi = llvm::dyn_cast<llvm::PHINode>(pointer)) {
    all = {};
    for (llvm::Value* one : phi->incoming_values()) {
      const auto known = reaches_.find(one);
      if (known != reaches_.end())
        all = joined(all, known->second);
      else if (!llvm::isa<llvm::Instruction>(one))
        all = joined(all, reach(one));
    }
    return all;
  }
  all.known = false;
  return all;
}

llvm::ConstantInt* Pointers::number(llvm::Value* base) {
  const auto k = numbers_.emplace(base, static_cast<std::uint32_t>(numbers_.size() + 1)).first->second;
  return llvm::ConstantInt::get(llvm::Type::getInt32Ty(function_.getContext()), k);
}

llvm::Value* Pointers::beyond(llvm::IRBuilder<>& build, llvm::Value* offset, llvm::Value* bytes,
                              llvm::Value* size) {
  return build.CreateOr(build.CreateICmpUGT(bytes, size),
                        build.CreateICmpUGT(offset, build.CreateSub(size, bytes)));
}

llvm::ConstantInt* Pointers::never_set(llvm::IRBuilder<>& build) { return build.getInt32(~0u); }

llvm::Value* Pointers::nowhere(llvm::IRBuilder<>& build, const PointerExtent& place) {
  return build.CreateOr(build.CreateICmpEQ(place.base, build.getInt32(0)),
                        build.CreateICmpEQ(place.base, never_set(build)));
}

llvm::Value* Pointers::left(llvm::IRBuilder<>& build, const PointerExtent& place, bool of_whole) {
  llvm::Value* beyond = of_whole ? build.CreateICmpUGT(place.in_whole, place.whole)
                                 : build.CreateICmpUGT(place.offset, place.size);
  llvm::Value *outside = build.CreateOr(place.wrong, beyond),
              *moved = build.CreateICmpNE(place.in_whole, build.getInt64(0)),
              *is_null = build.CreateICmpEQ(place.base, build.getInt32(0));
  if (const auto* known = llvm::dyn_cast<llvm::ConstantInt>(is_null)) return known->isOne() ? moved : outside;
  return build.CreateSelect(is_null, moved, outside);
}

const PointerExtent& Pointers::place(llvm::Value* pointer) {
  if (const auto known = places_.find(pointer); known != places_.end()) return known->second;
  llvm::IRBuilder<> build(function_.getContext());
  llvm::Value *zero = build.getInt64(0), *no = build.getFalse();
  const auto keep = [&](const PointerExtent& at) -> const PointerExtent& {
    return places_.emplace(pointer, at).first->second;
  };
  switch (kind_of(pointer)) {
    case Kind::base: {
      llvm::Value* size = build.getInt64(layout_.getTypeAllocSize(type_of_base(pointer)));
      return keep({zero, size, zero, size, no, number(pointer)});
    }
    case Kind::nowhere:
      return keep({zero, zero, zero, zero, no,
                   llvm::isa<llvm::CallInst>(pointer) ? never_set(build) : build.getInt32(0)});
    case Kind::same: {
      PointerExtent at = place(llvm::cast<llvm::User>(pointer)->getOperand(0));
      // A cast may turn a pointer to the first member into one to the struct, or to bytes.
      if (llvm::isa<llvm::BitCastOperator>(pointer)) at.offset = at.in_whole, at.size = at.whole;
      return keep(at);
    }
    default: break;
  }
  if (auto* step = llvm::dyn_cast<llvm::GEPOperator>(pointer)) return keep(moved(*step));
  if (auto* choice = llvm::dyn_cast<llvm::SelectInst>(pointer)) return keep(chosen(*choice));
  return merged(llvm::cast<llvm::PHINode>(*pointer));
}

PointerExtent Pointers::moved(llvm::GEPOperator& step) {
  PointerExtent at = place(step.getPointerOperand());
  auto* here = llvm::dyn_cast<llvm::Instruction>(&step);
  llvm::IRBuilder<> build(here != nullptr ? here : function_.getEntryBlock().getTerminator());
  const auto add = [&](llvm::Value*& to, llvm::Value* bytes) { to = build.CreateAdd(to, bytes); };
  llvm::Type* inside = nullptr;
  for (auto part = llvm::gep_type_begin(step); part != llvm::gep_type_end(step); ++part) {
    const std::uint64_t size = layout_.getTypeAllocSize(part.getIndexedType());
    if (llvm::StructType* record = part.getStructTypeOrNull()) {
      const auto field = llvm::cast<llvm::ConstantInt>(part.getOperand())->getZExtValue();
      llvm::Value* ahead =
          build.getInt64(layout_.getStructLayout(record)->getElementOffset(static_cast<unsigned>(field)));
      add(at.offset, ahead);
      add(at.in_whole, ahead);
      at.wrong = build.CreateOr(
          at.wrong,
          beyond(build, at.offset, build.getInt64(layout_.getTypeStoreSize(part.getIndexedType())), at.size));
      at.offset = build.getInt64(0);
      at.size = build.getInt64(size);
    } else {
      if (inside != nullptr) {
        llvm::Value* row = build.getInt64(layout_.getTypeAllocSize(inside));
        at.wrong = build.CreateOr(at.wrong, beyond(build, at.offset, row, at.size));
        at.offset = build.getInt64(0);
        at.size = row;
      }
      llvm::Value* k = build.CreateSExtOrTrunc(part.getOperand(), build.getInt64Ty());
      const std::uint64_t most = farthest / std::max<std::uint64_t>(size, 1);
      at.wrong = build.CreateOr(
          at.wrong, build.CreateICmpUGT(build.CreateAdd(k, build.getInt64(most)), build.getInt64(2 * most)));
      llvm::Value* ahead = build.CreateMul(k, build.getInt64(size));
      add(at.offset, ahead);
      add(at.in_whole, ahead);
    }
    inside = part.getIndexedType();
  }
  return at;
}

PointerExtent Pointers::chosen(llvm::SelectInst& choice) {
  const PointerExtent a = place(choice.getTrueValue()), b = place(choice.getFalseValue());
  llvm::IRBuilder<> build(&choice);
  PointerExtent at{};
  for (const auto member : members)
    at.*member =
        a.*member == b.*member ? a.*member : build.CreateSelect(choice.getCondition(), a.*member, b.*member);
  return at;
}

const PointerExtent& Pointers::merged(llvm::PHINode& phi) {
  llvm::IRBuilder<> build(&phi);
  PointerExtent at{};
  for (const auto member : members) {
    llvm::Type* type = member == &PointerExtent::wrong  ? build.getInt1Ty()
                       : member == &PointerExtent::base ? build.getInt32Ty()
                                                        : build.getInt64Ty();
    at.*member = build.CreatePHI(type, phi.getNumIncomingValues());
  }
  const PointerExtent& kept = places_.emplace(&phi, at).first->second;
  for (unsigned k = 0; k < phi.getNumIncomingValues(); ++k) {
    const PointerExtent one = place(phi.getIncomingValue(k));
    for (const auto member : members)
      llvm::cast<llvm::PHINode>(at.*member)->addIncoming(one.*member, phi.getIncomingBlock(k));
  }
  return kept;
}

}  // namespace mmverify::source
