// The resources that a module uses: descriptors, push constants, specialization constants.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "subjects/program/folder.hpp"

namespace mmverify::shaders {

struct Interface {
  std::vector<std::string> faults;     ///< resources that mmverify does not bind, each with binding and name
  std::vector<std::string> constants;  ///< specialization constants: "3 (`SIDE`): 5"
};

/// The interface of a module's entry point, by spirv-cross's reflection after spirv-opt has removed unused
/// variables. Nothing if there is no spirv-cross.
/// Domain: a valid module. Errors: std::runtime_error if spirv-cross refuses the module.
std::optional<Interface> read_interface(const std::string& spirv, const program::Folder& folder);

/// The interface in spirv-cross's JSON output. Errors: std::runtime_error if it is no such JSON.
Interface interface_of(const std::string& reflected);

}  // namespace mmverify::shaders
