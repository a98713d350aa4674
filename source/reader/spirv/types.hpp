// Types and constants of a SPIR-V module, and what they are in LLVM.
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Value.h>

#include <string>
#include <vector>

#include "source/reader/spirv/module.hpp"

namespace mmverify::source {

using Id = std::uint32_t;
/// A value's numbers: a vector's components, an array's elements and a structure's members one after another.  So nothing
/// but numbers and pointers reaches LLVM.
using Scalars = std::vector<llvm::Value*>;

inline void append(Scalars& to, const Scalars& more) { to.insert(to.end(), more.begin(), more.end()); }

/// Throws CannotRead.
[[noreturn]] void invalid(const std::string& why);

/// All throw CannotRead where an id is not what it has to be, NotKnown where a type is not among those read here.
class Types {
 public:
  Types(const SpirvModule& module, llvm::LLVMContext& context) : module_(module), context_(context) {}

  /// What makes a type, a constant or a variable outside of functions.
  const Instruction& global(Id id) const;
  static std::uint32_t operand(const Instruction& i, std::size_t k);

  bool is_void(Id type) const { return global(type).opcode == spv::TypeVoid; }
  bool is_pointer(Id type) const { return global(type).opcode == spv::TypePointer; }
  Id pointee(Id pointer) const;

  /// How many parts a vector, an array or a structure has; 0: it is a scalar.
  std::uint32_t parts(Id type) const;
  Id part(Id type, std::uint32_t k) const;
  /// How many numbers a value has.
  std::uint32_t scalars(Id type) const;

  /// Vectors are arrays.
  llvm::Type* llvm_type(Id type) const;

  bool is_constant(Id id) const;
  Scalars constant(Id id) const;
  /// A value of nothing but zeros, or of what is undefined.
  Scalars filled(Id type, bool undefined) const;
  /// Constants of scalars, from `at` on, as one of the type.
  llvm::Constant* joined(Id type, const Scalars& all, std::size_t& at) const;

 private:
  const SpirvModule& module_;
  llvm::LLVMContext& context_;
};

}  // namespace mmverify::source
