// From a file with a shader to SPIR-V that a worker can run.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "program/folder.hpp"
#include "shaders/compile/module.hpp"
#include "shaders/device/manifest.hpp"

namespace mmverify::shaders {

/// FILE[@ENTRY_POINT][@DEVICE], as a subject is named.
struct ShaderName {
  std::string file;
  std::optional<std::string> entry_point =
      {};  ///< of a whole shader, index_f32 where none is named; of a snippet, all that it defines
  std::optional<std::uint32_t> device = {};  ///< 0 where none is named
};
std::string to_text(const ShaderName& name);
/// Nothing where the file's name does not end as that of a shader does: .glsl, .comp, .hlsl, .slang, .spv.
std::optional<ShaderName> shader_name(const std::string& subject);

/// All that a shader may answer.
std::vector<std::string> entry_points();

/// The file does not compile, wants to be given what nobody gives it, is no valid SPIR-V, or defines nothing that could be asked; what() names file and line.
struct BadShader : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// What compiles such a file, or reads its interface, is not installed.
struct NotAvailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Compiled {
  Manifest manifest;
  std::string manifest_file;
  std::string fingerprint;                                 ///< of all modules and the device's number
  std::vector<std::pair<std::string, std::string>> about;  ///< the modules, in words: key and value
  std::vector<std::string> warnings;
  std::shared_ptr<const program::Folder> files;  ///< goes with the last copy of this
};

/// Compiles, validates with spirv-val, and reads what came of it, with spirv-cross what it wants to be given.  Throws BadShader, NotAvailable, and std::runtime_error
/// where the file cannot be read or a program not be run.
Compiled compile(const ShaderName& name);

/// SPIR-V of a file in GLSL or HLSL that has this function of a word and two floats, called or not, and its lines: for who
/// reads functions and runs none.  Returns the module's file in that folder.  Throws BadShader, NotAvailable.
std::string compile_function(const std::string& file, const std::string& function,
                             const program::Folder& folder);

/// The library that runs shaders: MMVERIFY_SHADER_LIBRARY, or beside this program, or where it is installed.  Throws
/// NotAvailable where this build has none.
std::string device_library();

}  // namespace mmverify::shaders
