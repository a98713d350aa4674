// LLVM's bitcode: found functions, and the one that is asked for, alone, at one level, without calls and loops.
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <memory>
#include <string>
#include <vector>

#include "source/program.hpp"

namespace mmverify::source {

/// What the reader cannot do, in words for whoever asked.
struct CannotRead : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// An instruction that has no operation here; what() begins with file and line.
struct NotKnown : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Mistakes on purpose, for the tests that must find them; the last ones are of SPIR-V.
enum class Planted {
  none,
  swapped_edges,
  signed_compare,
  shift_by_one_less,
  widened_with_sign,
  lost_wrap,
  shuffled_otherwise,
  signed_numbers,
  lowest_for_highest,
  clamped_above_alone,
  table_of_one
};

/// Bitcode or its text; of SPIR-V the function of that name alone.  Throws CannotRead, NotKnown.
std::unique_ptr<llvm::Module> read_module(const std::string& file, const std::string& function,
                                          llvm::LLVMContext& context, Planted planted);

/// The functions that the module has bodies of, as their source calls them.
std::vector<std::string> functions_of(const llvm::Module& module);

/// The function of that name, which takes a level, u and v: a word and two floats, u before v, the level first or last.
/// Throws CannotRead: there is none, several, or of another form.
llvm::Function& index_function(llvm::Module& module, const std::string& name);

/// Leaves the one function mmverify_source_index(level, u, v) for others to call.
void export_index(llvm::Module& module, llvm::Function& index);

/// Leaves one function of u and v, with the level a constant, its calls inlined, its loops unrolled.
llvm::Function& at_level(llvm::Module& module, llvm::Function& index, unsigned level);

/// The program of a function of two floats.  Throws NotKnown.
Program translate(const llvm::Function& function, Planted planted);

}  // namespace mmverify::source
