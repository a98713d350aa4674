#include "subjects/source/reader/spirv/decorations.hpp"

#include <algorithm>
#include <array>

#include "subjects/source/program.hpp"
#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/spirv/names.hpp"

namespace mmverify::source {
namespace {

/// Decorations that change no value that a function computes, by their numbers in the specification.
constexpr std::array harmless{
    1,                                      // SpecId: a specialization constant is refused where it is used
    2,    3,    4,   5,  6,  7,  8, 9, 10,  // Block to CPacked: how a buffer's members lie
    11,                                     // BuiltIn: a variable outside of functions is refused
    13,   14,   15,  16, 17,                // NoPerspective to Sample: how an input is interpolated
    18,                                     // Invariant: other shaders give the same value
    20,                                     // Aliased: promises nothing
    29,   30,   31,  32, 33, 34,            // Stream to DescriptorSet: the place of an input or a resource
    35,   36,   37,                         // Offset to XfbStride: the place of a member
    41,                                     // LinkageAttributes: the name for other modules
    42,                                     // NoContraction: the reader contracts nothing
    43,                                     // InputAttachmentIndex: the place of an image
    5300,                                   // NonUniform: promises nothing
    5356,                                   // AliasedPointer: promises nothing
    5634, 5635, 5636                        // CounterBuffer to UserTypeGOOGLE: names of HLSL
};

/// Decorations that the reader looks at where they stand.
constexpr std::array known{spv::RelaxedPrecision, spv::NoSignedWrap, spv::NoUnsignedWrap};

[[noreturn]] void refuse(const std::string& promise) {
  throw NotKnown(promise + ": a promise that nothing checks");
}

void refuse_other(const Instruction& decoration, std::size_t at) {
  const std::uint32_t which = decoration.operands.at(at);
  if (std::find(harmless.begin(), harmless.end(), static_cast<int>(which)) != harmless.end()) return;
  if (std::find(known.begin(), known.end(), which) != known.end()) return;
  refuse(operands_text(decoration, at, "decoration"));
}

/// Refuses bits of a mask, an operand of the instruction, unless all are among `harmless_bits`.
void refuse_bits(const Instruction& i, std::size_t at, std::uint32_t harmless_bits, const char* what) {
  if (at < i.operands.size() && (i.operands[at] & ~harmless_bits) != 0) refuse(operands_text(i, at, what));
}

bool may_wrap(std::uint16_t opcode) {
  return opcode == spv::IAdd || opcode == spv::ISub || opcode == spv::IMul || opcode == spv::SNegate;
}

}  // namespace

void refuse_promises_of(const SpirvModule& module, std::uint32_t id) {
  const auto found = module.decorations.find(id);
  if (found == module.decorations.end()) return;
  for (const Instruction& decoration : found->second) refuse_other(decoration, 1);
}

void refuse_promises_of_members(const SpirvModule& module, std::uint32_t type) {
  const auto found = module.members.find(type);
  if (found == module.members.end()) return;
  for (const Instruction& decoration : found->second) refuse_other(decoration, 2);
}

void refuse_promises_in(const SpirvModule& module, const Instruction& i) {
  constexpr std::uint32_t unroll_or_not = 3, flatten_or_not = 3, non_temporal = 4;
  switch (i.opcode) {
    case spv::LoopMerge: return refuse_bits(i, 2, unroll_or_not, "loop control");
    case spv::SelectionMerge: return refuse_bits(i, 1, flatten_or_not, "selection control");
    case spv::Load: refuse_bits(i, 1, non_temporal, "memory operand"); break;
    case spv::Store: return refuse_bits(i, 2, non_temporal, "memory operand");
    default: break;
  }
  if (i.result == 0) return;
  refuse_promises_of(module, i.result);
  if (!may_wrap(i.opcode) && wrap_flags(module, i.result) != 0)
    refuse("NoSignedWrap or NoUnsignedWrap of " + opcode_name(i.opcode));
}

void refuse_function_control(const Instruction& head) {
  constexpr std::uint32_t inline_or_not = 3;
  if ((head.operands.at(0) & ~inline_or_not) == 0) return;
  std::string text = operands_text(head, 0, "function control");
  refuse(text.substr(0, text.find(" %")) + " of a function");
}

unsigned wrap_flags(const SpirvModule& module, std::uint32_t result) {
  return (module.is_decorated(result, spv::NoUnsignedWrap) ? no_unsigned_wrap : 0u) |
         (module.is_decorated(result, spv::NoSignedWrap) ? no_signed_wrap : 0u);
}

}  // namespace mmverify::source
