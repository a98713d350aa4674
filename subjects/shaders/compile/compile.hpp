// Compiles a shader's file to SPIR-V that a worker can run.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "subjects/program/folder.hpp"
#include "subjects/shaders/compile/module.hpp"
#include "subjects/shaders/device/manifest.hpp"

namespace mmverify::shaders {

/// A subject's name: FILE[@ENTRY_POINT][@DEVICE].
struct ShaderName {
  std::string file;
  std::optional<std::string> entry_point =
      {};  ///< of a whole shader: index_f32 if none is named; of a snippet: all that it defines
  std::optional<std::uint32_t> device = {};  ///< 0 if none is named
};
std::string to_text(const ShaderName& name);
/// The parts of a shader's name; nothing if the file's suffix is none of .glsl, .comp, .hlsl, .slang, .spv.
std::optional<ShaderName> shader_name(const std::string& subject);

/// All entry points that a shader may answer.
std::vector<std::string> entry_points();

/// The file does not compile, uses a resource that mmverify does not bind, is no valid SPIR-V, or defines no
/// entry point; what() names file and line.
struct BadShader : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The program that compiles such a file, or reads its interface, is not installed.
struct NotAvailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Compiled {
  Manifest manifest;
  std::string manifest_file;
  std::string fingerprint;                                 ///< hash of all modules and the device's number
  std::vector<std::pair<std::string, std::string>> about;  ///< facts about the modules, key and value
  std::vector<std::string> warnings;
  std::shared_ptr<const program::Folder> files;  ///< removed with the last copy
};

/// Compiles the file, validates it with spirv-val, and reads the interface of the result with spirv-cross.
/// Throws BadShader, NotAvailable, and std::runtime_error if the file cannot be read or a program cannot be
/// run.
Compiled compile(const ShaderName& name);

/// Compiles a file in GLSL or HLSL to SPIR-V that keeps this function of a word and two floats, called or
/// not, and its line numbers: input for readers of SPIR-V. Returns the module's file in that folder. Throws
/// BadShader, NotAvailable.
std::string compile_function(const std::string& file, const std::string& function,
                             const program::Folder& folder);

/// The library that runs shaders: MMVERIFY_SHADER_LIBRARY, or beside this program, or where it is installed.
/// Throws NotAvailable if this build has none.
std::string device_library();

}  // namespace mmverify::shaders
