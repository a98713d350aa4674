// Turns a function of a SPIR-V module into an LLVM function, which is then read as bitcode is.
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <memory>
#include <string>

#include "subjects/source/reader/module.hpp"

namespace mmverify::source {

/// The function of that name and the functions that it calls. Compilers of shaders pass coordinates by
/// pointers; the result takes them by value: `name(level, u, v)`. Operations that SPIR-V leaves to the device
/// are not known: divisions, fused products and sums, round, roots. Sums and products are those of IEEE 754,
/// rounded to nearest, each by itself, subnormal numbers kept.
/// Throws CannotRead: no valid SPIR-V, no such function; NotKnown: an instruction without an operation here.
std::unique_ptr<llvm::Module> read_spirv(const std::string& bytes, const std::string& file,
                                         const std::string& name, llvm::LLVMContext& context, Planted planted,
                                         bool shifts_wrap);

}  // namespace mmverify::source
