#include "subjects/source/reader/module.hpp"

#include <llvm/ADT/SmallVector.h>
#include <llvm/Analysis/CFG.h>
#include <llvm/Demangle/Demangle.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Verifier.h>
#include <llvm/IRReader/IRReader.h>
#include <llvm/Support/SourceMgr.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/Transforms/Utils/Local.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "subjects/source/reader/accesses.hpp"
#include "subjects/source/reader/certain.hpp"
#include "subjects/source/reader/passes.hpp"
#include "subjects/source/reader/spirv/module.hpp"
#include "subjects/source/reader/spirv/spirv.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

constexpr const char* exported = "mmverify_source_index";
constexpr const char* asked = "mmverify_source_at_level";

/// The name in the source, with a C++ function's parameters: "ns::index_of(unsigned int, float, float)".
std::string full_name(const llvm::Function& f) { return llvm::demangle(f.getName().str()); }

/// The name without parameters.
std::string plain_name(const llvm::Function& f) {
  const std::string full = full_name(f);
  return full.substr(0, full.find('('));
}

std::string text_of(const llvm::Type* type) {
  std::string text;
  llvm::raw_string_ostream(text) << *type;
  return text;
}

bool is_float(const llvm::Type* t) { return t->isFloatTy() || t->isDoubleTy(); }

/// The number of the level's parameter, 0 or 2; -1 for a function of another form.
int place_of_level(const llvm::Function& f) {
  // An index of more bits would be truncated; so would the level if it had fewer.
  if (f.arg_size() != 3 || f.isVarArg() || !f.getReturnType()->isIntegerTy() ||
      f.getReturnType()->getIntegerBitWidth() > 32)
    return -1;
  const auto type = [&](unsigned k) { return f.getArg(k)->getType(); };
  const auto is_level = [&](unsigned k) {
    return type(k)->isIntegerTy() && type(k)->getIntegerBitWidth() >= 8;
  };
  if (is_level(0) && is_float(type(1)) && is_float(type(2))) return 0;
  if (is_float(type(0)) && is_float(type(1)) && is_level(2)) return 2;
  return -1;
}

/// A new function that calls `index`; if `level` is null, the level is the new function's first parameter.
llvm::Function& calling(llvm::Module& module, llvm::Function& index, const char* name,
                        llvm::Constant* level) {
  llvm::LLVMContext& context = module.getContext();
  llvm::Type *word = llvm::Type::getInt32Ty(context), *number = llvm::Type::getFloatTy(context);
  std::vector<llvm::Type*> takes{number, number};
  if (level == nullptr) takes.insert(takes.begin(), word);
  llvm::Function* f = llvm::Function::Create(llvm::FunctionType::get(word, takes, false),
                                             llvm::Function::ExternalLinkage, name, module);
  llvm::IRBuilder<> build(llvm::BasicBlock::Create(context, "", f));
  const unsigned u = level == nullptr ? 1 : 0;
  llvm::Value* of_level = level == nullptr ? static_cast<llvm::Value*>(f->getArg(0)) : level;
  std::vector<llvm::Value*> given{f->getArg(u), f->getArg(u + 1)};
  given.insert(given.begin() + place_of_level(index), of_level);
  for (unsigned k = 0; k < 3; ++k) {
    llvm::Type* wanted = index.getArg(k)->getType();
    given[k] = wanted->isIntegerTy() ? build.CreateZExtOrTrunc(given[k], wanted)
                                     : build.CreateFPCast(given[k], wanted);
  }
  // A narrow result is extended as the function declares: int16_t with its sign.
  const bool with_sign = index.hasRetAttribute(llvm::Attribute::SExt);
  llvm::CallInst* call = build.CreateCall(&index, given);
  call->setCallingConv(index.getCallingConv());
  call->setAttributes(index.getAttributes());
  build.CreateRet(with_sign ? build.CreateSExtOrTrunc(call, word) : build.CreateZExtOrTrunc(call, word));
  return *f;
}

void hide_all_but(llvm::Module& module, const llvm::Function& shown) {
  for (llvm::GlobalValue& value : module.global_values()) {
    if (value.isDeclaration() || &value == &shown || value.getName().startswith("llvm.")) continue;
    value.setLinkage(llvm::GlobalValue::InternalLinkage);
    value.setVisibility(llvm::GlobalValue::DefaultVisibility);
    if (auto* object = llvm::dyn_cast<llvm::GlobalObject>(&value)) object->setComdat(nullptr);
  }
}

/// Throws NotKnown for a thread_local variable that the index function uses: it keeps values between calls, and
/// no shared library can have it as the front end wrote it.
void refuse_thread_locals(llvm::Module& module) {
  const auto of_threads = [](const llvm::GlobalVariable& g) { return g.isThreadLocal(); };
  if (std::none_of(module.global_begin(), module.global_end(), of_threads)) return;
  run_passes(module, "globaldce");
  const auto found = std::find_if(module.global_begin(), module.global_end(), of_threads);
  if (found == module.global_end()) return;
  throw NotKnown(place_of(*found) + ": " + found->getName().str() + " is thread_local");
}

}  // namespace

std::unique_ptr<llvm::Module> read_module(const std::string& file, const std::string& function,
                                          llvm::LLVMContext& context, Planted planted, bool shifts_wrap) {
  std::ifstream in(file, std::ios::binary);
  if (const std::string bytes{std::istreambuf_iterator<char>(in), {}}; is_spirv(bytes))
    return read_spirv(bytes, file, function, context, planted, shifts_wrap);
  llvm::SMDiagnostic error;
  std::unique_ptr<llvm::Module> module = llvm::parseIRFile(file, error, context);
  if (!module) throw CannotRead(file + ": " + error.getMessage().str());
  std::string why;
  llvm::raw_string_ostream out(why);
  if (llvm::verifyModule(*module, &out)) throw CannotRead(file + ": " + out.str());
  for (const llvm::GlobalValue& value : module->global_values())
    if (value.getName().contains("mmverify."))
      throw NotKnown(module->getSourceFileName() + ": a name that the reader gives, " +
                     value.getName().str());
  return module;
}

std::vector<std::string> functions_of(const llvm::Module& module) {
  std::vector<std::string> names;
  for (const llvm::Function& f : module)
    if (!f.isDeclaration()) names.push_back(full_name(f));
  std::sort(names.begin(), names.end());
  return names;
}

llvm::Function& index_function(llvm::Module& module, const std::string& name) {
  std::vector<llvm::Function*> found, fit;
  for (llvm::Function& f : module)
    if (!f.isDeclaration() && (f.getName() == name || plain_name(f) == name || full_name(f) == name)) {
      found.push_back(&f);
      if (place_of_level(f) >= 0) fit.push_back(&f);
    }
  if (found.empty()) {
    std::string names;
    // Headers may have hundreds of functions: those of the right form are listed alone, if there are any.
    std::vector<std::string> all;
    for (const llvm::Function& f : module)
      if (!f.isDeclaration() && place_of_level(f) >= 0) all.push_back(full_name(f));
    if (all.empty()) all = functions_of(module);
    std::sort(all.begin(), all.end());
    for (std::size_t k = 0; k < all.size() && k < 20; ++k) names += (k == 0 ? "" : ", ") + all[k];
    if (all.size() > 20) names += ", and " + std::to_string(all.size() - 20) + " more";
    throw CannotRead("no function is called '" + name + "'; there " +
                     (all.empty() ? "is none" : "are: " + names));
  }
  if (fit.empty()) {
    const llvm::Type* gives = found.front()->getReturnType();
    const bool wide = gives->isIntegerTy() && gives->getIntegerBitWidth() > 32;
    throw CannotRead("'" + name + "' is " + text_of(found.front()->getFunctionType()) +
                     "; due is uint32_t (uint32_t level, float u, float v), or the level last" +
                     (wide ? ": its result has " + std::to_string(gives->getIntegerBitWidth()) +
                                 " bits, of which an index has 32"
                           : ""));
  }
  if (fit.size() > 1)
    throw CannotRead("'" + name + "' is " + full_name(*fit[0]) + " and " + full_name(*fit[1]));
  return *fit.front();
}

void export_index(llvm::Module& module, llvm::Function& index) {
  if (llvm::GlobalValue* other = module.getNamedValue(exported)) other->setName("other");
  hide_all_but(module, calling(module, index, exported, nullptr));
  refuse_thread_locals(module);
  define_unset(module);
}

llvm::Function& at_level(llvm::Module& module, llvm::Function& index, unsigned level) {
  if (llvm::GlobalValue* other = module.getNamedValue(asked)) other->setName("other");
  llvm::Function& f = calling(module, index, asked,
                              llvm::ConstantInt::get(llvm::Type::getInt32Ty(module.getContext()), level));
  hide_all_but(module, f);
  for (llvm::Function& g : module) {
    if (g.isDeclaration() || &g == &f) continue;
    g.removeFnAttr(llvm::Attribute::NoInline);
    g.removeFnAttr(llvm::Attribute::OptimizeNone);
    g.addFnAttr(llvm::Attribute::AlwaysInline);
    // At -O1 clang forbids unrolling in each loop's metadata.
    for (llvm::BasicBlock& block : g)
      if (llvm::Instruction* end = block.getTerminator())
        end->setMetadata(llvm::LLVMContext::MD_loop, nullptr);
  }
  // Passes assume that undefined behaviour never happens, so guard() hides it first. Then variables become
  // values, and loops are unrolled if there are any.
  run_passes(module, "globaldce");
  guard(module);
  run_passes(module, "always-inline,globaldce");
  promote_pointers(*module.getFunction(asked));
  guard_accesses(*module.getFunction(asked), [&] { run_passes(module, "function(sroa)"); });
  const auto round = [&](const char* passes) {
    run_passes(module, passes);
    llvm::Function& alone = *module.getFunction(asked);
    make_certain_plain(alone);
    // Folds branches that the level decides.
    for (llvm::BasicBlock& block : alone) llvm::ConstantFoldTerminator(&block);
    llvm::removeUnreachableBlocks(alone);
    llvm::SmallVector<std::pair<const llvm::BasicBlock*, const llvm::BasicBlock*>, 4> loops;
    llvm::FindFunctionBackedges(alone, loops);
    return !loops.empty();
  };
  round("function(sroa)");
  bool loops = round("function(sroa,instsimplify,sccp,sroa)");
  for (int k = 0; loops && k < 4; ++k)
    loops = round(
        "function(sroa,early-cse,simplifycfg,sccp,loop-simplify,lcssa,loop-mssa(loop-rotate),loop(indvars,"
        "loop-unroll-full),sroa,early-cse,sccp,simplifycfg,adce)");
  round("function(sroa,instsimplify,adce)");
  return *module.getFunction(asked);
}

}  // namespace mmverify::source
