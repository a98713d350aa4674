// Types and constants of a SPIR-V module, and their LLVM equivalents.
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Value.h>

#include <string>
#include <vector>

#include "subjects/source/reader/spirv/module.hpp"

namespace mmverify::source {

using Id = std::uint32_t;
/// The numbers of a value: a vector's components, an array's elements or a structure's members, flattened.
/// LLVM gets numbers and pointers only.
using Scalars = std::vector<llvm::Value*>;

inline void append(Scalars& to, const Scalars& more) { to.insert(to.end(), more.begin(), more.end()); }

/// Throws CannotRead.
[[noreturn]] void invalid(const std::string& why);

/// The types of a module. All functions throw CannotRead if an id is not of the required kind, NotKnown if a
/// type is not supported.
class Types {
 public:
  Types(const SpirvModule& module, llvm::LLVMContext& context) : module_(module), context_(context) {}

  /// The instruction that defines a type, a constant or a variable outside of functions.
  const Instruction& global(Id id) const;
  static std::uint32_t operand(const Instruction& i, std::size_t k);

  bool is_void(Id type) const { return global(type).opcode == spv::TypeVoid; }
  bool is_pointer(Id type) const { return global(type).opcode == spv::TypePointer; }
  Id pointee(Id pointer) const;

  /// The number of parts of a vector, an array or a structure; 0 for a scalar.
  std::uint32_t parts(Id type) const;
  Id part(Id type, std::uint32_t k) const;
  /// The number of numbers in a value.
  std::uint32_t scalars(Id type) const;

  /// The LLVM type; a vector becomes an array.
  llvm::Type* llvm_type(Id type) const;

  bool is_constant(Id id) const;
  Scalars constant(Id id) const;
  /// A value of zeros, or of undefined numbers.
  Scalars filled(Id type, bool undefined) const;
  /// The next constants of `all`, from `at` on, combined into one of the type.
  llvm::Constant* joined(Id type, const Scalars& all, std::size_t& at) const;

 private:
  const SpirvModule& module_;
  llvm::LLVMContext& context_;
};

}  // namespace mmverify::source
