#include <llvm/Analysis/TargetLibraryInfo.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

#include <set>
#include <sstream>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/refused/refused.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

/// All functions that LLVM's code generators call by themselves, by LLVM's own list.
const std::set<std::string>& called_by_compilers() {
  static const std::set<std::string> all = [] {
    std::set<std::string> names;
    for (const char* name : {
#define HANDLE_LIBCALL(code, name) static_cast<const char*>(name),
#include <llvm/IR/RuntimeLibcalls.def>
#undef HANDLE_LIBCALL
         })
      if (name != nullptr) names.insert(name);
    // Passes make these of loops and of each other.
    for (const char* name :
         {"memcmp", "bcmp", "strlen", "mempcpy", "bzero", "memset_pattern16", "fabs", "fabsf", "fabsl"})
      names.insert(name);
    return names;
  }();
  return all;
}

/// A function of floats without its type's letter: "floor" for "floorf".
std::string without_type(const std::string& name) {
  const bool has = name.size() > 1 && (name.back() == 'f' || name.back() == 'l') &&
                   called_by_compilers().count(name.substr(0, name.size() - 1)) != 0;
  return has ? name.substr(0, name.size() - 1) : name;
}

/// The functions of floats that the intrinsics and remainders in the code may become calls of, without their
/// type's letter.
std::set<std::string> float_functions(const Reached& reached) {
  std::set<std::string> names;
  for (const llvm::Function* f : reached.functions)
    for (const llvm::Instruction& at : llvm::instructions(*f)) {
      if (at.getOpcode() == llvm::Instruction::FRem) names.insert("fmod");
      const auto* call = llvm::dyn_cast<llvm::IntrinsicInst>(&at);
      if (call == nullptr) continue;
      const llvm::StringRef name = llvm::Intrinsic::getBaseName(call->getIntrinsicID());
      const std::string plain = name.substr(name.rfind('.') + 1).str();
      names.insert(plain == "minnum"    ? "fmin"
                   : plain == "maxnum"  ? "fmax"
                   : plain == "fmuladd" ? "fma"
                                        : plain);
    }
  return names;
}

/// Whether compilers call it of functions of floats, and only for these.
bool is_of_floats(const std::string& name) {
  return name.rfind("__", 0) != 0 && name.rfind("mem", 0) != 0 && name != "bcmp" && name != "bzero" &&
         name != "strlen";
}

/// Assembly outside of functions may define any name. Names that it only declares are none.
bool declares_only(const std::string& assembly) {
  std::istringstream lines(assembly);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, other;
    words >> first >> other;
    const bool one_statement = line.find(';') == std::string::npos;
    if (!first.empty() && (!one_statement || (first != ".globl" && first != ".ident"))) return false;
  }
  return true;
}

/// Whether compilers take a call of the function for a call of the library function of its name.
bool is_taken_for_library(const llvm::Function& f) {
  static const llvm::TargetLibraryInfoImpl all{llvm::Triple()};
  llvm::LibFunc known{};
  return !f.hasLocalLinkage() && all.getLibFunc(f.getName(), known);
}

}  // namespace

void refuse_own_names(const llvm::Module& module, const Reached& reached) {
  if (!declares_only(module.getModuleInlineAsm()))
    throw NotKnown(module.getSourceFileName() + ": assembly outside of functions, which may define any name");
  const std::set<std::string> used = float_functions(reached);
  for (const llvm::GlobalValue& value : module.global_values()) {
    std::string name = value.getName().str();
    if (!name.empty() && name.front() == '\1') name.erase(0, 1);
    if (value.isDeclaration() || called_by_compilers().count(name) == 0) continue;
    if (is_of_floats(name) && used.count(without_type(name)) == 0) continue;
    throw NotKnown(place_of(value) + ": the file defines its own " + name + ", which compiled code calls");
  }
  for (const llvm::Function* f : reached.functions)
    if (f != reached.functions.front() && is_taken_for_library(*f))
      throw NotKnown(place_of(*f) + ": the file defines its own " + f->getName().str() +
                     ", which compilers take for the library's; make it static");
}

}  // namespace mmverify::source
