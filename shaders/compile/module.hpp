// What is to be known of a SPIR-V module before it is run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mmverify::shaders {

struct ModuleFacts {
  std::string function;  ///< of a compute entry point: main, else the first; empty: there is none
  std::vector<std::string> compute_entry_points, other_entry_points;
  std::vector<std::uint32_t>
      foreign_capabilities;      ///< that ask for a device's feature which none is opened with
  std::uint32_t group_size = 0;  ///< invocations of its workgroup; 0: not stated as LocalSize
  std::uint32_t version = 0;     ///< 0x00010300 for SPIR-V 1.3
  std::uint32_t spec_constants = 0;
  std::vector<std::string> float_modes;  ///< what it asks of floats: "RoundingModeRTE 32", ...
  std::uint32_t float_operations = 0;    ///< additions, products, quotients, dot products
  std::uint32_t contractible = 0;        ///< of these, those without NoContraction: they may be rearranged
  std::vector<std::string>
      contractible_in;  ///< functions that hold such, once each, as the module names them
};

/// Throws std::runtime_error: what is wrong with the bytes.
ModuleFacts read_module(const std::string& bytes);

}  // namespace mmverify::shaders
