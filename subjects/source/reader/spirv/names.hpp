// Names of SPIR-V's instructions and of what stands in them, by SPIRV-Tools; numbers in a build without it.
#pragma once

#include <string>

#include "subjects/source/reader/spirv/module.hpp"

namespace mmverify::source {

/// The name of an opcode, "OpFDiv".
std::string opcode_name(std::uint16_t opcode);

/// The operands of an instruction from `at` on, as its text has them: "MaxIterations 3". `otherwise` names
/// them in a build without SPIRV-Tools, before their number.
std::string operands_text(const Instruction& i, std::size_t at, const std::string& otherwise);

/// The name of an instruction of GLSL.std.450: "PackHalf2x16".
std::string extended_name(std::uint32_t instruction);

}  // namespace mmverify::source
