// The values of one function, and the instructions that make new values: arithmetic, comparisons,
// conversions, parts of vectors and structures.
#pragma once

#include <llvm/IR/IRBuilder.h>

#include <functional>
#include <map>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/spirv/types.hpp"

namespace mmverify::source {

class Values {
 public:
  Values(const SpirvModule& module, const Types& types, llvm::LLVMContext& context, Planted planted)
      : module_(module), types_(types), planted_(planted), build_(context) {}

  llvm::IRBuilder<>& build() { return build_; }

  /// Throws CannotRead: there is no such value; NotKnown: memory outside of functions.
  Scalars value(Id id);
  Scalars constant_or_value(Id id) const;  ///< for an instruction that is built elsewhere
  Id type_of(Id id) const;
  llvm::Value* one(Id id);
  llvm::Value* word(Id id);
  llvm::Value* number(Id id);
  void set(const Instruction& i, Scalars all);
  void set(Id id, Id type, Scalars all);

  /// Each makes the instruction if it is of its group, and returns whether it is.
  bool arithmetic(const Instruction& i);
  bool conversion(const Instruction& i);
  bool composite(const Instruction& i);
  bool of_bits(const Instruction& i);
  /// Makes an OpExtInst.
  void extended(const Instruction& i);

 private:
  using Unary = std::function<llvm::Value*(llvm::Value*)>;
  using Binary = std::function<llvm::Value*(llvm::Value*, llvm::Value*)>;
  enum class Sort { words, floats };

  static std::uint32_t operand(const Instruction& i, std::size_t k) { return Types::operand(i, k); }
  Scalars checked(Id id, Sort sort);
  void each(const Instruction& i, std::size_t at, Sort sort, const Unary& make);
  void pairs(const Instruction& i, std::size_t at, Sort sort, const Binary& make);
  void shifts(const Instruction& i, llvm::Instruction::BinaryOps how);
  llvm::Value* of_words(const Instruction& i, llvm::Instruction::BinaryOps how, llvm::Value* a,
                        llvm::Value* b);
  void clamp(const Instruction& i, Sort sort, llvm::Intrinsic::ID most, llvm::Intrinsic::ID least,
             bool orders);
  llvm::Value* sign_of_float(llvm::Value* a);
  llvm::Value* sign_of_word(llvm::Value* a);
  void first_bit(const Instruction& i, std::uint32_t which);
  void field(const Instruction& i);
  void extract(const Instruction& i);
  void insert(const Instruction& i);
  void shuffle(const Instruction& i);
  void select(const Instruction& i);
  std::size_t place(Id& type, const Instruction& i, std::size_t from) const;
  llvm::Type* scalar_type(Id type) const;
  llvm::Value* of_one(llvm::Intrinsic::ID id, llvm::Value* a) { return build_.CreateUnaryIntrinsic(id, a); }
  llvm::Value* of_two(llvm::Intrinsic::ID id, llvm::Value* a, llvm::Value* b) {
    return build_.CreateBinaryIntrinsic(id, a, b);
  }
  /// x, or an undefined value if the condition holds.
  llvm::Value* unless(llvm::Value* condition, llvm::Value* x) {
    const auto* known = llvm::dyn_cast<llvm::ConstantInt>(condition);
    if (known != nullptr && known->isZero()) return x;
    return build_.CreateSelect(condition, llvm::UndefValue::get(x->getType()), x);
  }
  static llvm::Value* whole(const llvm::Value* like, std::uint64_t k) {
    return llvm::ConstantInt::get(like->getType(), k);
  }

  const SpirvModule& module_;
  const Types& types_;
  Planted planted_;
  llvm::IRBuilder<> build_;
  std::map<Id, Scalars> values_;
  std::map<Id, Id> kinds_;  ///< the values' types
};

}  // namespace mmverify::source
