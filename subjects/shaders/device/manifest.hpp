// A worker's manifest: the files of its shaders, and the device. The program writes it, the library in the
// worker reads it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mmverify::shaders {

/// The environment variables that a worker reads.
constexpr const char* manifest_variable = "MMVERIFY_SHADER";
/// If set, the Khronos validation layer is on, and its first message ends the call.
constexpr const char* validation_variable = "MMVERIFY_VULKAN_VALIDATION";

/// A compute shader that answers one entry point of mmverify_subject_t.
struct Module {
  std::string entry_point;     ///< in the header: index_f32, ...
  std::string function;        ///< in the module: OpEntryPoint's name
  std::uint32_t group_size{};  ///< invocations of a workgroup
  std::string file;            ///< SPIR-V
};

struct Manifest {
  std::uint32_t device = 0;  ///< the device's number
  std::vector<Module> modules;
};

/// One item a line: `device N`, then `module ENTRY_POINT GROUP_SIZE FUNCTION FILE`, FILE up to the line's
/// end.
std::string to_text(const Manifest& manifest);

/// Throws std::runtime_error, which names the file and the line.
Manifest read_manifest(const std::string& file);

// The interface of shaders, as docs/SUBJECTS.md has it: descriptor set 0, and push constants.
constexpr std::uint32_t input_bindings = 3;  ///< 0, 1, 2: the entry point's arrays
constexpr std::uint32_t answer_binding = 3;
constexpr std::uint32_t bytes_binding = 4;  ///< the code, block or map that the entry point reads
constexpr std::uint32_t bindings = 5;

/// layout(push_constant)
struct PushConstants {
  std::uint32_t count, level, first, second, bytes;
};

}  // namespace mmverify::shaders
