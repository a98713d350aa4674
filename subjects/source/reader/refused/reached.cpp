#include <llvm/IR/Constants.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/InstIterator.h>

#include <set>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/refused/refused.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

/// Walks from a definition to all that its code or its initial value names.
class Walk {
 public:
  Reached from(llvm::Function& index) {
    meet(&index);
    while (!next_.empty()) {
      llvm::Constant* one = next_.back();
      next_.pop_back();
      visit(*one);
    }
    return std::move(found_);
  }

 private:
  void meet(llvm::Value* value) {
    auto* constant = llvm::dyn_cast<llvm::Constant>(value);
    if (constant != nullptr && !llvm::isa<llvm::ConstantData>(constant) && seen_.insert(constant).second)
      next_.push_back(constant);
  }

  void visit(llvm::Constant& one) {
    for (llvm::Value* operand : one.operand_values()) meet(operand);
    if (auto* variable = llvm::dyn_cast<llvm::GlobalVariable>(&one)) found_.variables.push_back(variable);
    auto* f = llvm::dyn_cast<llvm::Function>(&one);
    if (f == nullptr || f->isDeclaration()) return;
    found_.functions.push_back(f);
    for (llvm::Instruction& at : llvm::instructions(*f))
      for (llvm::Value* operand : at.operand_values()) meet(operand);
  }

  Reached found_;
  std::set<llvm::Constant*> seen_;
  std::vector<llvm::Constant*> next_;
};

/// Whether the file is in C++, where all definitions of an inline function are the same.
bool is_cpp(const llvm::Module& module) {
  for (const llvm::DICompileUnit* unit : module.debug_compile_units())
    if (llvm::dwarf::isCPlusPlus(static_cast<llvm::dwarf::SourceLanguage>(unit->getSourceLanguage())))
      return true;
  return false;
}

bool may_be_replaced(const llvm::GlobalValue& value) {
  return value.isInterposable() || (value.hasAvailableExternallyLinkage() && !is_cpp(*value.getParent()));
}

}  // namespace

Reached reached_from(llvm::Function& index) { return Walk().from(index); }

void refuse_replaceable(const llvm::Function& index, const Reached& reached) {
  constexpr const char* why = ", which another definition may replace (weak, or inline without static)";
  for (const llvm::Function* f : reached.functions)
    if (f != &index && may_be_replaced(*f))
      throw NotKnown(place_of(*f) + ": the function " + f->getName().str() + why);
  for (const llvm::GlobalVariable* variable : reached.variables)
    if (!variable->isDeclaration() && may_be_replaced(*variable))
      throw NotKnown(place_of(*variable) + ": " + variable->getName().str() + why);
}

void refuse_what_is_not_judged(llvm::Module& module, llvm::Function& index) {
  const Reached reached = reached_from(index);
  refuse_own_names(module, reached);
  refuse_replaceable(index, reached);
  for (llvm::Function* f : reached.functions) {
    refuse_attributes(*f);
    refuse_reordered(*f);
    refuse_metadata(*f);
  }
  refuse_underived(module, reached);
}

}  // namespace mmverify::source
