// What a module wants to be given: descriptors, push constants, specialization constants.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/folder.hpp"

namespace mmverify::shaders {

struct Interface {
  std::vector<std::string> faults;     ///< what nobody will give it, each with the binding and its name
  std::vector<std::string> constants;  ///< specialization constants: "3 (`SIDE`): 5"
};

/// By spirv-cross's reflection, of what the entry point uses: spirv-opt leaves out the rest before.  None where there is
/// no spirv-cross.
/// Domain: a valid module.  Errors: std::runtime_error where spirv-cross does not bear it.
std::optional<Interface> read_interface(const std::string& spirv, const program::Folder& folder);

/// The same of spirv-cross's own words.  Errors: std::runtime_error where they are no such.
Interface interface_of(const std::string& reflected);

}  // namespace mmverify::shaders
