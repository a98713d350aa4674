// A function of a SPIR-V module as a function of LLVM's: from there on it is read as bitcode is.
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <memory>
#include <string>

#include "source/reader/module.hpp"

namespace mmverify::source {

/// The function of that name and those that it calls.  Shaders' compilers hand coordinates over by pointers; the function
/// here takes them by value: `name(level, u, v)`.
/// What SPIR-V leaves to a device is not known: divisions, a product and a sum at once, round, roots.  Sums and products are
/// those of IEEE 754, rounded to nearest, each by itself, subnormal numbers kept.
/// Throws CannotRead: no valid SPIR-V, no such function; NotKnown: an instruction without an operation here.
std::unique_ptr<llvm::Module> read_spirv(const std::string& bytes, const std::string& file,
                                         const std::string& name, llvm::LLVMContext& context,
                                         Planted planted);

}  // namespace mmverify::source
