#include "subjects/source/reader/passes.hpp"

#include <llvm/Analysis/CGSCCPassManager.h>
#include <llvm/Analysis/LoopAnalysisManager.h>
#include <llvm/IR/PassManager.h>
#include <llvm/Passes/PassBuilder.h>

#include "subjects/source/reader/module.hpp"

namespace mmverify::source {

void run_passes(llvm::Module& module, const std::string& pipeline) {
  llvm::LoopAnalysisManager loops;
  llvm::FunctionAnalysisManager functions;
  llvm::CGSCCAnalysisManager calls;
  llvm::ModuleAnalysisManager modules;
  llvm::PassBuilder passes;
  passes.registerModuleAnalyses(modules);
  passes.registerCGSCCAnalyses(calls);
  passes.registerFunctionAnalyses(functions);
  passes.registerLoopAnalyses(loops);
  passes.crossRegisterProxies(loops, functions, calls, modules);
  llvm::ModulePassManager all;
  if (llvm::Error error = passes.parsePassPipeline(all, pipeline))
    throw CannotRead("LLVM's passes: " + llvm::toString(std::move(error)));
  all.run(module, modules);
}

}  // namespace mmverify::source
