// Shaders as subjects, compiled and run on a Vulkan device.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/arguments.hpp"

namespace mmverify::cli {

/// Whether a subject's name is a shader's: FILE[@ENTRY_POINT][@DEVICE][:KIND], FILE ending in .glsl, .comp,
/// .hlsl, .slang or .spv.
bool is_shader(const std::string& name);

/// The name with the device's number and the entry point added if it has none; a name of no shader stays.
/// UsageError if shaders have no such entry point.
std::string with_device(const std::string& name, std::optional<std::uint32_t> device,
                        const std::optional<std::string>& entry_point);

/// Compiles the shader and opens the device. Without a device, the subjects' laws are not_applicable.
/// UsageError if it does not compile; EnvironmentError if the file, a compiler or Vulkan in this build is
/// missing.
std::vector<proofs::SubjectPtr> of_shader(const std::string& name, double timeout_seconds,
                                          std::vector<RunsOn>* runs_on);

/// The most seconds for one call of the subject: as given, else 10, or 60 for a shader, since a loaded
/// machine stalls a dispatch.
double timeout_of(const std::string& name, std::optional<double> given);

}  // namespace mmverify::cli
