// Shaders as subjects: compiled, and run on a Vulkan device.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.hpp"

namespace mmverify::cli {

/// Whether the subject's name is that of a shader: FILE[@ENTRY_POINT][@DEVICE][:KIND], FILE ending in .glsl, .comp, .hlsl,
/// .slang or .spv.
bool is_shader(const std::string& name);

/// The name with the device's number and the entry point in it, where it names none; as it is of what is no shader.
/// UsageError where shaders have no such entry point.
std::string with_device(const std::string& name, std::optional<std::uint32_t> device,
                        const std::optional<std::string>& entry_point);

/// Compiles it and opens the device.  Where there is no device: subjects whose laws are not_applicable.  UsageError where it
/// does not compile; EnvironmentError where the file, a compiler or Vulkan in this build is missing.
std::vector<proofs::SubjectPtr> of_shader(const std::string& name, double timeout_seconds,
                                          std::vector<RunsOn>* runs_on);

/// Seconds that one call of the subject may take: as given, else 10, of a shader 60, as a loaded machine stalls a dispatch.
double timeout_of(const std::string& name, std::optional<double> given);

}  // namespace mmverify::cli
