// The functions of a module as LLVM functions, each declared at its first call, and the source lines of their
// instructions.
#pragma once

#include <llvm/IR/DIBuilder.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Module.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "subjects/source/reader/spirv/module.hpp"
#include "subjects/source/reader/spirv/types.hpp"

namespace mmverify::source {

/// Writes files and lines as LLVM debug information.
class Lines {
 public:
  Lines(llvm::Module& into, const SpirvModule& module, const std::string& file)
      : module_(module), build_(into), file_(file) {
    into.addModuleFlag(llvm::Module::Warning, "Debug Info Version", llvm::DEBUG_METADATA_VERSION);
    unit_ = build_.createCompileUnit(llvm::dwarf::DW_LANG_C99, build_.createFile(file, ""), "SPIR-V", true,
                                     "", 0);
  }
  void begin(llvm::Function& f) {
    llvm::DIFile* file = build_.createFile(file_, "");
    program_ = build_.createFunction(unit_, f.getName(), f.getName(), file, 0,
                                     build_.createSubroutineType(build_.getOrCreateTypeArray({})), 0,
                                     llvm::DINode::FlagZero, llvm::DISubprogram::SPFlagDefinition);
    f.setSubprogram(program_);
  }
  llvm::DebugLoc at(const Instruction& i) {
    llvm::DIScope* scope = program_;
    if (const auto name = module_.strings.find(i.file); name != module_.strings.end())
      scope = build_.createLexicalBlockFile(program_, build_.createFile(name->second, ""));
    return llvm::DILocation::get(program_->getContext(), i.line, 0, scope);
  }
  std::string text(const Instruction& i) const {
    const auto name = module_.strings.find(i.file);
    if (i.line == 0) return file_;
    return (name != module_.strings.end() ? name->second : file_) + ":" + std::to_string(i.line);
  }
  void finish() { build_.finalize(); }

 private:
  const SpirvModule& module_;
  llvm::DIBuilder build_;
  std::string file_;
  llvm::DICompileUnit* unit_ = nullptr;
  llvm::DISubprogram* program_ = nullptr;
};

/// The functions of a module, each declared at its first call.
class Functions {
 public:
  Functions(const SpirvModule& module, const Types& types, llvm::Module& into)
      : module_(module), types_(types), into_(into) {}

  const SpirvFunction& of(Id id) const {
    for (const SpirvFunction& f : module_.functions)
      if (f.head.result == id) return f;
    invalid("a call of no function");
  }
  std::size_t arguments(Id type) const { return types_.is_pointer(type) ? 1 : types_.scalars(type); }
  /// Whether a function returns through a last pointer parameter: a value of several numbers does.
  bool by_pointer(Id returned) const { return !types_.is_void(returned) && types_.parts(returned) != 0; }

  llvm::Function& declared(Id id) {
    llvm::Function*& f = made_[id];
    if (f != nullptr) return *f;
    const SpirvFunction& from = of(id);
    std::vector<llvm::Type*> takes;
    for (const Instruction& p : from.parameters) {
      if (types_.is_pointer(p.type))
        takes.push_back(types_.llvm_type(p.type));
      else
        for (const llvm::Value* one : types_.filled(p.type, false)) takes.push_back(one->getType());
    }
    llvm::Type* returned = types_.llvm_type(from.head.type);
    if (by_pointer(from.head.type)) {
      takes.push_back(returned->getPointerTo());
      returned = llvm::Type::getVoidTy(into_.getContext());
    }
    const auto name = module_.names.find(id);
    f = llvm::Function::Create(
        llvm::FunctionType::get(returned, takes, false), llvm::Function::InternalLinkage,
        "spirv." + (name != module_.names.end() ? name->second : std::to_string(id)), into_);
    wanted_.push_back(id);
    return *f;
  }

  /// The next called function without a body.
  std::optional<Id> next() {
    if (wanted_.empty()) return std::nullopt;
    const Id id = wanted_.back();
    wanted_.pop_back();
    return id;
  }

 private:
  const SpirvModule& module_;
  const Types& types_;
  llvm::Module& into_;
  std::map<Id, llvm::Function*> made_;
  std::vector<Id> wanted_;
};

}  // namespace mmverify::source
