#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Transforms/Utils/Cloning.h>

#include <array>
#include <memory>
#include <string>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/passes.hpp"
#include "subjects/source/reader/refused/refused.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

using Kind = llvm::Attribute::AttrKind;

/// Attributes of a function, a parameter or a result that say what memory it reads and writes, where its pointers
/// go and what it returns. clang's come of __attribute__((const)) and the like; passes take them for true.
constexpr std::array of_functions{Kind::ReadNone,
                                  Kind::ReadOnly,
                                  Kind::WriteOnly,
                                  Kind::ArgMemOnly,
                                  Kind::InaccessibleMemOnly,
                                  Kind::InaccessibleMemOrArgMemOnly};
constexpr std::array of_parameters{Kind::ReadNone, Kind::ReadOnly, Kind::WriteOnly, Kind::NoCapture,
                                   Kind::Returned};
constexpr std::array of_results{Kind::NoAlias};

template <std::size_t count>
llvm::AttributeMask mask_of(const std::array<Kind, count>& kinds) {
  llvm::AttributeMask mask;
  for (const Kind kind : kinds) mask.addAttribute(kind);
  return mask;
}

/// Strips the attributes of a function or a call.
template <class Attributed>
void strip(Attributed& of, unsigned parameters) {
  for (const Kind kind : of_functions) of.removeFnAttr(kind);
  for (unsigned k = 0; k < parameters; ++k) of.removeParamAttrs(k, mask_of(of_parameters));
  of.removeRetAttrs(mask_of(of_results));
}

bool calls_a_body(const llvm::CallBase& call) {
  const llvm::Function* to = call.getCalledFunction();
  return to != nullptr && !to->isDeclaration();
}

/// The module with no such attribute but those that LLVM derives from the functions' bodies.
std::unique_ptr<llvm::Module> derived_anew(const llvm::Module& module, llvm::ValueToValueMapTy& twins) {
  std::unique_ptr<llvm::Module> anew = llvm::CloneModule(module, twins);
  for (llvm::Function& f : *anew) {
    if (f.isDeclaration()) continue;
    strip(f, static_cast<unsigned>(f.arg_size()));
    // LLVM derives nothing of what may be replaced, is not to be optimized, or is local and nobody calls.
    f.setComdat(nullptr);
    f.setVisibility(llvm::GlobalValue::DefaultVisibility);
    f.setLinkage(llvm::GlobalValue::ExternalLinkage);
    f.removeFnAttr(Kind::OptimizeNone);
    for (llvm::Instruction& at : llvm::instructions(f))
      if (auto* call = llvm::dyn_cast<llvm::CallBase>(&at); call != nullptr && calls_a_body(*call))
        strip(*call, call->arg_size());
  }
  run_passes(*anew, "function(sroa),cgscc(function-attrs),rpo-function-attrs");
  return anew;
}

bool has_any(const llvm::AttributeSet& of, std::initializer_list<Kind> kinds) {
  return std::any_of(kinds.begin(), kinds.end(), [&](Kind kind) { return of.hasAttribute(kind); });
}

/// Whether the derived attributes imply one that is stated. `whole`: the derived ones of the whole function,
/// which hold for its parameters, too.
bool follows(Kind stated, const llvm::AttributeSet& derived, const llvm::AttributeSet& whole) {
  if (stated == Kind::NoCapture || stated == Kind::Returned || stated == Kind::NoAlias)
    return derived.hasAttribute(stated);
  if (has_any(derived, {stated, Kind::ReadNone}) || whole.hasAttribute(Kind::ReadNone)) return true;
  if (stated == Kind::ReadOnly || stated == Kind::WriteOnly) return whole.hasAttribute(stated);
  return stated == Kind::InaccessibleMemOrArgMemOnly &&
         has_any(derived, {Kind::ArgMemOnly, Kind::InaccessibleMemOnly});
}

template <std::size_t count>
void refuse_unfollowed(const std::array<Kind, count>& kinds, const llvm::AttributeSet& stated,
                       const llvm::AttributeSet& derived, const llvm::AttributeSet& whole,
                       const std::string& place) {
  for (const Kind kind : kinds)
    if (stated.hasAttribute(kind) && !follows(kind, derived, whole))
      throw NotKnown(place + ": the attribute " + stated.getAttribute(kind).getAsString() +
                     ", which does not follow from the function's body");
}

void refuse_unfollowed(const llvm::AttributeList& stated, const llvm::Function& derived,
                       const std::string& place) {
  const llvm::AttributeList of = derived.getAttributes();
  const llvm::AttributeSet whole = of.getFnAttrs();
  refuse_unfollowed(of_functions, stated.getFnAttrs(), whole, whole, place);
  refuse_unfollowed(of_results, stated.getRetAttrs(), of.getRetAttrs(), whole, place);
  for (unsigned k = 0; k < derived.arg_size(); ++k)
    refuse_unfollowed(of_parameters, stated.getParamAttrs(k), of.getParamAttrs(k), whole, place);
}

}  // namespace

void refuse_underived(const llvm::Module& module, const Reached& reached) {
  llvm::ValueToValueMapTy twins;
  const std::unique_ptr<llvm::Module> anew = derived_anew(module, twins);
  const auto twin = [&](const llvm::Function& f) -> const llvm::Function& {
    return *llvm::cast<llvm::Function>(twins.lookup(&f));
  };
  for (const llvm::Function* f : reached.functions) {
    refuse_unfollowed(f->getAttributes(), twin(*f), place_of(*f));
    for (const llvm::Instruction& at : llvm::instructions(*f))
      if (const auto* call = llvm::dyn_cast<llvm::CallBase>(&at); call != nullptr && calls_a_body(*call))
        refuse_unfollowed(call->getAttributes(), twin(*call->getCalledFunction()), place_of(at));
  }
}

}  // namespace mmverify::source
