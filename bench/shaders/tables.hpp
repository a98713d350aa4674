// The speed of lookups as kernels on a device, beside a kernel that copies as many bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/result.hpp"

namespace mmverify::bench {

struct KernelSpeed {
  std::string kernel;
  std::optional<std::uint64_t> level;
  std::uint64_t hits = 0;
  std::string order;                          ///< "coherent", "shuffled"; empty of copies
  std::uint64_t bytes_in = 0, bytes_out = 0;  ///< a hit
  double ns = 0;                              ///< of a dispatch: the median of the runs
  double spread = 0;                          ///< (slowest run - fastest run) / median
  std::optional<double> share_of_copy;        ///< none of copies
  std::optional<std::uint64_t> checked;       ///< none of vkCmdCopyBuffer
};

struct ShaderFigures {
  std::uint64_t device = 0, hits = 0, runs = 0;
  bool is_processor = false;
  std::string bounded_by;  ///< what keeps the hits below those asked for; empty if nothing does
  double bandwidth = 0;    ///< bytes/s of the fastest copy of the most hits
  std::vector<std::pair<std::string, std::string>> about;  ///< the device and its driver
  std::vector<KernelSpeed> rows;
};

Result shader_tables(const ShaderFigures& figures);

}  // namespace mmverify::bench
