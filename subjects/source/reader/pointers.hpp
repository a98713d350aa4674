// Follows pointers to their variables and tables, with their offsets.
#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Operator.h>

#include <cstdint>
#include <map>
#include <set>

namespace mmverify::source {

/// All places that a pointer may point to. The null pointer, and one never set, point to no variable.
struct Reach {
  std::set<llvm::Value*> bases;  ///< calls of Guarded::variable, variables, tables
  bool known = true;             ///< false if it may point to other places, too
  bool reached = false;          ///< false if no value reaches it
  std::int64_t first = 0;        ///< the offset in bytes is `first`
  std::uint64_t stride = 0;      ///< plus a multiple of `stride`
  friend bool operator==(const Reach&, const Reach&) = default;
};

/// Whether the type is a pointer or contains one.
bool holds_pointers(const llvm::Type* type);

/// Whether bytes_of_a bytes at `a` and bytes_of_b bytes at `b`, in one variable, may overlap.
bool overlap(const Reach& a, std::uint64_t bytes_of_a, const Reach& b, std::uint64_t bytes_of_b);

/// A pointer's place as values, computed where the pointer is computed.
struct PointerExtent {
  llvm::Value *offset, *size;     ///< in the part that it was made for: a row, a member, or the whole
  llvm::Value *in_whole, *whole;  ///< in the variable
  llvm::Value* wrong;             ///< whether it was made from a pointer outside its part
  llvm::Value* base;              ///< number() of the variable; 0 of null, never_set() of one never set
};

class Pointers {
 public:
  explicit Pointers(llvm::Function& function);

  Reach reach(llvm::Value* pointer) const;
  /// Domain: reach() is known.
  const PointerExtent& place(llvm::Value* pointer);
  llvm::ConstantInt* number(llvm::Value* base);
  /// Whether some of the `bytes` bytes at `offset` lie outside a part of `size` bytes.
  static llvm::Value* beyond(llvm::IRBuilder<>& build, llvm::Value* offset, llvm::Value* bytes,
                             llvm::Value* size);
  static llvm::ConstantInt* never_set(llvm::IRBuilder<>& build);
  /// Whether the pointer is null or was never set.
  static llvm::Value* nowhere(llvm::IRBuilder<>& build, const PointerExtent& place);
  /// Whether the pointer lies outside of its part or variable, and not behind its last byte; a null pointer
  /// has no bytes.
  static llvm::Value* left(llvm::IRBuilder<>& build, const PointerExtent& place, bool of_whole);

 private:
  PointerExtent moved(llvm::GEPOperator& step);
  PointerExtent chosen(llvm::SelectInst& choice);
  const PointerExtent& merged(llvm::PHINode& phi);

  llvm::Function& function_;
  const llvm::DataLayout& layout_;
  std::map<llvm::Value*, Reach> reaches_;
  std::map<llvm::Value*, PointerExtent> places_;
  std::map<llvm::Value*, std::uint32_t> numbers_;
};

}  // namespace mmverify::source
