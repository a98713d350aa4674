// The cost of a lookup in a shader on a device, beside the library's own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/result.hpp"

namespace mmverify::bench {

struct ShaderSpeed {
  std::string function;
  std::optional<std::uint64_t> level;
  double device_ns = 0;          ///< wall time of a lookup in a batch, copies included
  std::optional<double> cpu_ns;  ///< impl's, one by one; none if impl has no such function
  std::uint64_t differing = 0;   ///< answers of a batch that differ from impl's
};

struct ShaderFigures {
  std::uint64_t device = 0, batch = 0, seed = 0;
  std::vector<std::pair<std::string, std::string>> about;  ///< the device and its driver
  std::vector<ShaderSpeed> rows;
};

Result shader_tables(const ShaderFigures& figures);

}  // namespace mmverify::bench
