// Refusals of bitcode for what it says beside its operations: names that compiled code calls, code that others
// put in, definitions that others replace, promises that nothing shows.
#pragma once

#include <llvm/IR/Module.h>

#include <vector>

namespace mmverify::source {

/// The definitions that a function's code may come to: itself, what it calls, and what it names.
struct Reached {
  std::vector<llvm::Function*> functions;
  std::vector<llvm::GlobalVariable*> variables;
};
Reached reached_from(llvm::Function& index);

/// All of the below. Throws NotKnown with a file and a line, where there is one.
void refuse_what_is_not_judged(llvm::Module& module, llvm::Function& index);

/// A definition under a name that compiled code calls by itself, such as memcpy, or that an intrinsic becomes a
/// call of, such as floorf; a function of the library's name, such as ffs, that compilers take for the library's.
void refuse_own_names(const llvm::Module& module, const Reached& reached);
/// Attributes by which a compiler puts code in, or by which functions differ from their operations.
void refuse_attributes(const llvm::Function& f);
/// Sums of floats in a loop with a pragma by which compilers may add in another order.
void refuse_reordered(llvm::Function& f);
/// Metadata that promises what nothing checks, and pointers of other address spaces.
void refuse_metadata(const llvm::Function& f);
/// A definition other than the index function's own that a linker may replace by another one.
void refuse_replaceable(const llvm::Function& index, const Reached& reached);
/// Attributes on memory, and `returned`, of functions with bodies, where LLVM does not derive them again.
void refuse_underived(const llvm::Module& module, const Reached& reached);

}  // namespace mmverify::source
