// Facts about a SPIR-V module, read before it is run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mmverify::shaders {

struct ModuleFacts {
  std::string function;  ///< the compute entry point: main, else the first; empty if none
  std::vector<std::string> compute_entry_points, other_entry_points;
  std::vector<std::uint32_t> foreign_capabilities;  ///< for features that no device is opened with
  std::uint32_t group_size = 0;  ///< invocations of a workgroup; 0 if LocalSize does not state them
  std::uint32_t version = 0;     ///< 0x00010300 for SPIR-V 1.3
  std::uint32_t spec_constants = 0;
  std::vector<std::string> float_modes;  ///< the float controls that it requests: "RoundingModeRTE 32", ...
  std::uint32_t float_operations = 0;    ///< additions, products, quotients, dot products
  std::uint32_t contractible = 0;        ///< those without NoContraction, which may be rearranged
  std::vector<std::string>
      contractible_in;  ///< functions with contractible operations, once each, by the module's names
};

/// Throws std::runtime_error, which says what is wrong with the bytes.
ModuleFacts read_module(const std::string& bytes);

}  // namespace mmverify::shaders
