#include "subjects/source/reader/spirv/types.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/DerivedTypes.h>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/spirv/decorations.hpp"
#include "subjects/source/reader/spirv/names.hpp"

namespace mmverify::source {
namespace {

constexpr std::uint32_t most_scalars = 1 << 16;

}  // namespace

void invalid(const std::string& why) { throw CannotRead("no valid SPIR-V: " + why); }

const Instruction& Types::global(Id id) const {
  const auto found = module_.globals.find(id);
  if (found == module_.globals.end()) invalid("there is no id " + std::to_string(id));
  return found->second;
}

std::uint32_t Types::operand(const Instruction& i, std::size_t k) {
  if (k >= i.operands.size()) invalid("an instruction has too few operands");
  return i.operands[k];
}

Id Types::pointee(Id pointer) const {
  if (!is_pointer(pointer)) invalid("a pointer is none");
  return operand(global(pointer), 1);
}

std::uint32_t Types::parts(Id type) const {
  const Instruction& t = global(type);
  if (t.opcode == spv::TypeVector) return operand(t, 1);
  if (t.opcode == spv::TypeStruct) return static_cast<std::uint32_t>(t.operands.size());
  if (t.opcode == spv::TypeArray) {
    const Instruction& length = global(operand(t, 1));
    if (length.opcode != spv::Constant) throw NotKnown("an array whose length is no constant");
    return operand(length, 0);
  }
  return 0;
}

Id Types::part(Id type, std::uint32_t k) const {
  const Instruction& t = global(type);
  if (k >= parts(type)) invalid("there is no such part of a type");
  return t.opcode == spv::TypeStruct ? t.operands[k] : operand(t, 0);
}

std::uint32_t Types::scalars(Id type) const {
  const std::uint32_t count = parts(type);
  if (count == 0) return 1;
  std::uint64_t sum = 0;
  if (global(type).opcode == spv::TypeStruct) {
    for (std::uint32_t k = 0; k < count; ++k) sum += scalars(part(type, k));
  } else {
    sum = std::uint64_t{count} * scalars(part(type, 0));
  }
  if (sum > most_scalars) throw NotKnown("a value of more than 65536 numbers");
  return static_cast<std::uint32_t>(sum);
}

llvm::Type* Types::llvm_type(Id type) const {
  const Instruction& t = global(type);
  switch (t.opcode) {
    case spv::TypeVoid: return llvm::Type::getVoidTy(context_);
    case spv::TypeBool: return llvm::Type::getInt1Ty(context_);
    case spv::TypeInt:
      if (operand(t, 0) < 1 || operand(t, 0) > 64) invalid("a word of more than 64 bits");
      return llvm::Type::getIntNTy(context_, operand(t, 0));
    case spv::TypeFloat:
      if (operand(t, 0) == 32) return llvm::Type::getFloatTy(context_);
      if (operand(t, 0) == 64) return llvm::Type::getDoubleTy(context_);
      throw NotKnown("a float of " + std::to_string(operand(t, 0)) + " bits");
    case spv::TypePointer: return llvm_type(pointee(type))->getPointerTo();
    case spv::TypeVector:
    case spv::TypeArray: scalars(type); return llvm::ArrayType::get(llvm_type(part(type, 0)), parts(type));
    case spv::TypeStruct: {
      refuse_promises_of_members(module_, type);
      std::vector<llvm::Type*> members;
      for (std::uint32_t k = 0; k < parts(type); ++k) members.push_back(llvm_type(part(type, k)));
      return llvm::StructType::get(context_, members);
    }
    default: throw NotKnown("a value of a type that is not known: " + opcode_name(t.opcode));
  }
}

Scalars Types::constant(Id id) const {
  const Instruction& c = global(id);
  if (module_.is_decorated(id, spv::RelaxedPrecision)) throw NotKnown(relaxed);
  refuse_promises_of(module_, id);
  switch (c.opcode) {
    case spv::SpecConstantTrue:
    case spv::SpecConstantFalse:
    case spv::SpecConstant:
    case spv::SpecConstantComposite:
    case spv::SpecConstantOp:
      throw NotKnown("a specialization constant, which a pipeline may set to anything");
    case spv::ConstantTrue: return {llvm::ConstantInt::getTrue(context_)};
    case spv::ConstantFalse: return {llvm::ConstantInt::getFalse(context_)};
    case spv::Constant: {
      llvm::Type* type = llvm_type(c.type);
      const std::uint64_t bits =
          operand(c, 0) | (c.operands.size() > 1 ? std::uint64_t{c.operands[1]} << 32 : 0);
      if (type->isIntegerTy()) return {llvm::ConstantInt::get(type, bits)};
      if (!type->isFloatTy() && !type->isDoubleTy()) invalid("a constant that is no number");
      const bool single = type->isFloatTy();
      return {llvm::ConstantFP::get(
          context_, llvm::APFloat(single ? llvm::APFloat::IEEEsingle() : llvm::APFloat::IEEEdouble(),
                                  llvm::APInt(single ? 32 : 64, bits)))};
    }
    case spv::ConstantComposite: {
      Scalars all;
      if (c.operands.size() != parts(c.type)) invalid("a constant with another count of parts");
      scalars(c.type);
      for (const Id part : c.operands) {
        append(all, constant(part));
      }
      return all;
    }
    case spv::ConstantNull:
    case spv::Undef: return filled(c.type, c.opcode == spv::Undef);
    default: throw NotKnown(opcode_name(c.opcode) + ", outside of functions");
  }
}

bool Types::is_constant(Id id) const {
  const auto found = module_.globals.find(id);
  if (found == module_.globals.end()) return false;
  const std::uint16_t opcode = found->second.opcode;
  return (opcode >= spv::ConstantTrue && opcode <= spv::SpecConstantOp) || opcode == spv::Undef;
}

Scalars Types::filled(Id type, bool undefined) const {
  if (const std::uint32_t count = parts(type); count != 0) {
    Scalars all;
    scalars(type);
    for (std::uint32_t k = 0; k < count; ++k) {
      append(all, filled(part(type, k), undefined));
    }
    return all;
  }
  llvm::Type* t = llvm_type(type);
  if (undefined) return {llvm::UndefValue::get(t)};
  return {llvm::Constant::getNullValue(t)};
}

llvm::Constant* Types::joined(Id type, const Scalars& all, std::size_t& at) const {
  if (const std::uint32_t count = parts(type); count != 0) {
    std::vector<llvm::Constant*> of;
    for (std::uint32_t k = 0; k < count; ++k) of.push_back(joined(part(type, k), all, at));
    llvm::Type* t = llvm_type(type);
    if (auto* s = llvm::dyn_cast<llvm::StructType>(t)) return llvm::ConstantStruct::get(s, of);
    return llvm::ConstantArray::get(llvm::cast<llvm::ArrayType>(t), of);
  }
  return llvm::cast<llvm::Constant>(all.at(at++));
}

}  // namespace mmverify::source
