// Follows pointers to their variables and tables, and how far into them.
#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Operator.h>

#include <cstdint>
#include <map>
#include <set>

namespace mmverify::source {

/// All places that a pointer may have.  The null pointer, and one never set, lead to no variable.
struct Reach {
  std::set<llvm::Value*> bases;  ///< calls of Guarded::variable, variables, tables
  bool known = true;             ///< false: to others, too
  bool reached = false;          ///< false: nothing comes there
  std::int64_t first = 0;        ///< its offset in bytes is this,
  std::uint64_t stride = 0;      ///< plus a multiple of that
  friend bool operator==(const Reach&, const Reach&) = default;
};

/// Whether it is a pointer or has one.
bool holds_pointers(const llvm::Type* type);

/// Whether so many bytes at one and at the other, of one variable, may be common.
bool overlap(const Reach& a, std::uint64_t bytes_of_a, const Reach& b, std::uint64_t bytes_of_b);

/// A pointer's place as values, computed where the pointer is.
struct Place {
  llvm::Value *offset, *size;     ///< in the part that it was made for: a row, a member, or the whole
  llvm::Value *in_whole, *whole;  ///< in the variable
  llvm::Value* wrong;             ///< it was made of one outside of its part
  llvm::Value* base;              ///< number() of the variable
};

class Pointers {
 public:
  explicit Pointers(llvm::Function& function);

  Reach reach(llvm::Value* pointer) const;
  /// Domain: reach() is known.
  const Place& place(llvm::Value* pointer);
  llvm::ConstantInt* number(llvm::Value* base);
  /// Whether `bytes` bytes are not all in a part of `size` bytes.
  static llvm::Value* beyond(llvm::IRBuilder<>& build, llvm::Value* offset, llvm::Value* bytes,
                             llvm::Value* size);

 private:
  Place moved(llvm::GEPOperator& step);
  Place chosen(llvm::SelectInst& choice);
  const Place& merged(llvm::PHINode& phi);

  llvm::Function& function_;
  const llvm::DataLayout& layout_;
  std::map<llvm::Value*, Reach> reaches_;
  std::map<llvm::Value*, Place> places_;
  std::map<llvm::Value*, std::uint32_t> numbers_;
};

}  // namespace mmverify::source
