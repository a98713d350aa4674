// LLVM bitcode: its functions, and one function alone at one level, without calls and loops.
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <memory>
#include <string>
#include <vector>

#include "subjects/source/program.hpp"

namespace mmverify::source {

/// A file that the reader cannot use; what() is a message for the user.
struct CannotRead : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// An instruction that no operation models; what() begins with file and line.
struct NotKnown : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Deliberate mistakes, for the tests that must find them; the last ones are in the reading of SPIR-V.
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

/// Reads bitcode or its text; of SPIR-V only the function `function`. `shifts_wrap`: SPIR-V's shifts take
/// the amount modulo the width, as HLSL's do. Throws CannotRead, NotKnown.
std::unique_ptr<llvm::Module> read_module(const std::string& file, const std::string& function,
                                          llvm::LLVMContext& context, Planted planted,
                                          bool shifts_wrap = false);

/// The functions with bodies, by their names in the source.
std::vector<std::string> functions_of(const llvm::Module& module);

/// The function of that name. It takes a level, a word, and two floats, u before v; the level is first or
/// last. Throws CannotRead if there is none, or several, or one of another form.
llvm::Function& index_function(llvm::Module& module, const std::string& name);

/// Exports the function mmverify_source_index(level, u, v) alone.
void export_index(llvm::Module& module, llvm::Function& index);

/// Returns a function of u and v with the level constant, its calls inlined and its loops unrolled.
llvm::Function& at_level(llvm::Module& module, llvm::Function& index, unsigned level);

/// The program of a function of two floats.  Throws NotKnown.
Program translate(const llvm::Function& function, Planted planted);

}  // namespace mmverify::source
