// A SPIR-V module's promises of its values, variables, functions and loops, beside what they compute.
#pragma once

#include "subjects/source/reader/spirv/module.hpp"

namespace mmverify::source {

/// Each throws NotKnown with the name of a promise that the reader does not check. Those that change no value
/// pass; RelaxedPrecision and the wraps of sums and products pass too, as the reader looks at them itself.
void refuse_promises_of(const SpirvModule& module, std::uint32_t id);
/// The same of the members of a structure.
void refuse_promises_of_members(const SpirvModule& module, std::uint32_t type);
/// The same of an instruction: its result's, its loop control's, its access's.
void refuse_promises_in(const SpirvModule& module, const Instruction& i);
/// The same of a function's control, an operand of OpFunction.
void refuse_function_control(const Instruction& head);

/// The message on RelaxedPrecision.
constexpr const char* relaxed = "RelaxedPrecision (mediump): a device may compute in 16 bits";

/// The flags of subjects/source/program.hpp that the decorations of a result amount to.
unsigned wrap_flags(const SpirvModule& module, std::uint32_t result);

}  // namespace mmverify::source
