// A SPIR-V module as written: functions, and types, constants and names by their ids.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mmverify::source {

/// The opcodes and extended instructions that the reader knows. The numbers are those of the SPIR-V
/// specification, 3.49, and of GLSL.std.450.
namespace spv {
enum Opcode : std::uint16_t {
  Undef = 1,
  Name = 5,
  String = 7,
  Line = 8,
  ExtInstImport = 11,
  ExtInst = 12,
  ExecutionMode = 16,
  TypeVoid = 19,
  TypeBool = 20,
  TypeInt = 21,
  TypeFloat = 22,
  TypeVector = 23,
  TypeArray = 28,
  TypeStruct = 30,
  TypePointer = 32,
  TypeFunction = 33,
  ConstantTrue = 41,
  ConstantFalse = 42,
  Constant = 43,
  ConstantComposite = 44,
  ConstantNull = 46,
  SpecConstantTrue = 48,
  SpecConstantFalse = 49,
  SpecConstant = 50,
  SpecConstantComposite = 51,
  SpecConstantOp = 52,
  Function = 54,
  FunctionParameter = 55,
  FunctionEnd = 56,
  FunctionCall = 57,
  Variable = 59,
  Load = 61,
  Store = 62,
  AccessChain = 65,
  InBoundsAccessChain = 66,
  Decorate = 71,
  MemberDecorate = 72,
  GroupDecorate = 74,
  GroupMemberDecorate = 75,
  VectorExtractDynamic = 77,
  VectorShuffle = 79,
  CompositeConstruct = 80,
  CompositeExtract = 81,
  CompositeInsert = 82,
  CopyObject = 83,
  ConvertFToU = 109,
  ConvertFToS = 110,
  ConvertSToF = 111,
  ConvertUToF = 112,
  UConvert = 113,
  SConvert = 114,
  FConvert = 115,
  Bitcast = 124,
  SNegate = 126,
  FNegate = 127,
  IAdd = 128,
  FAdd = 129,
  ISub = 130,
  FSub = 131,
  IMul = 132,
  FMul = 133,
  UDiv = 134,
  SDiv = 135,
  UMod = 137,
  SRem = 138,
  SMod = 139,
  VectorTimesScalar = 142,
  Any = 154,
  All = 155,
  IsNan = 156,
  IsInf = 157,
  LogicalEqual = 164,
  LogicalNotEqual = 165,
  LogicalOr = 166,
  LogicalAnd = 167,
  LogicalNot = 168,
  Select = 169,
  IEqual = 170,
  INotEqual = 171,
  UGreaterThan = 172,
  SGreaterThan = 173,
  UGreaterThanEqual = 174,
  SGreaterThanEqual = 175,
  ULessThan = 176,
  SLessThan = 177,
  ULessThanEqual = 178,
  SLessThanEqual = 179,
  FOrdEqual = 180,
  FUnordEqual = 181,
  FOrdNotEqual = 182,
  FUnordNotEqual = 183,
  FOrdLessThan = 184,
  FUnordLessThan = 185,
  FOrdGreaterThan = 186,
  FUnordGreaterThan = 187,
  FOrdLessThanEqual = 188,
  FUnordLessThanEqual = 189,
  FOrdGreaterThanEqual = 190,
  FUnordGreaterThanEqual = 191,
  ShiftRightLogical = 194,
  ShiftRightArithmetic = 195,
  ShiftLeftLogical = 196,
  BitwiseOr = 197,
  BitwiseXor = 198,
  BitwiseAnd = 199,
  Not = 200,
  BitFieldInsert = 201,
  BitFieldSExtract = 202,
  BitFieldUExtract = 203,
  BitReverse = 204,
  BitCount = 205,
  Phi = 245,
  LoopMerge = 246,
  SelectionMerge = 247,
  Label = 248,
  Branch = 249,
  BranchConditional = 250,
  Switch = 251,
  Return = 253,
  ReturnValue = 254,
  Unreachable = 255,
  NoLine = 317,
  DecorateId = 332,
  DecorateString = 5632,
  MemberDecorateString = 5633,
};
enum Extended : std::uint32_t {
  RoundEven = 2,
  Trunc = 3,
  FAbs = 4,
  SAbs = 5,
  FSign = 6,
  SSign = 7,
  Floor = 8,
  Ceil = 9,
  Fract = 10,
  FMin = 37,
  UMin = 38,
  SMin = 39,
  FMax = 40,
  UMax = 41,
  SMax = 42,
  FClamp = 43,
  UClamp = 44,
  SClamp = 45,
  Step = 48,
  FindILsb = 73,
  FindSMsb = 74,
  FindUMsb = 75,
  NMin = 79,
  NMax = 80,
  NClamp = 81,
};
enum Storage : std::uint32_t { Private = 6, FunctionStorage = 7 };
enum Decoration : std::uint32_t { RelaxedPrecision = 0, NoSignedWrap = 4469, NoUnsignedWrap = 4470 };
}  // namespace spv

struct Instruction {
  std::uint16_t opcode = 0;
  std::uint32_t type = 0, result = 0;  ///< ids; 0 if it has none
  std::vector<std::uint32_t> operands = {};
  std::uint32_t file = 0, line = 0;  ///< the id of an OpString; 0 if unknown
};

struct SpirvFunction {
  Instruction head;
  std::vector<Instruction> parameters, body;
};

struct SpirvModule {
  std::map<std::uint32_t, std::string> names, strings, sets;  ///< sets: of extended instructions
  std::map<std::uint32_t, Instruction> globals;  ///< types, constants, variables outside of functions
  std::vector<SpirvFunction> functions;
  /// Decorations by what they decorate: operand 0 of each is an id, and of `members` a structure's.
  std::map<std::uint32_t, std::vector<Instruction>> decorations, members;
  std::vector<std::string> foreign_promises;  ///< messages on modes that change binary32 operations
  bool shifts_wrap = false;                   ///< shifts take the amount modulo the width

  bool is_decorated(std::uint32_t id, std::uint32_t decoration) const;
};

/// Whether the bytes begin as SPIR-V does, in either byte order.
bool is_spirv(const std::string& bytes);

/// Throws CannotRead if an instruction is cut short or a string has no end.
SpirvModule read_spirv_module(const std::string& bytes);

/// The operands from `at` on as a string, which SPIR-V packs in words.
std::string text_at(const std::vector<std::uint32_t>& operands, std::size_t at);

}  // namespace mmverify::source
