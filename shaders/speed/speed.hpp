// How fast the shaders of shaders/subjects look up on a device, beside the library's own single values.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mmverify::shaders {

/// One function at one level; of blocks there is none.
struct Speed {
  std::string function;
  std::optional<std::uint32_t> level = {};
  double device_ns = 0;  ///< a lookup: wall time of a call, its copies included, over its lookups; the best
  std::optional<double> cpu_ns =
      {};  ///< impl's, one by one in one thread, the same points; none where impl has no such
  std::uint64_t differing = 0;  ///< answers unlike impl's
};

struct Speeds {
  std::vector<std::pair<std::string, std::string>> about;  ///< the device, as a subject's runs_on has it
  std::vector<Speed> rows;
};

struct SpeedOptions {
  std::uint32_t device = 0;
  std::uint32_t first = 4, last = 12;                     ///< levels, every fourth of them
  std::size_t batch = 1 << 16;                            ///< lookups a call
  double seconds = 0.1;                                   ///< at least, of each function, thrice
  std::uint64_t seed = 1;                                 ///< of the points
  std::function<void(const std::string&)> progress = {};  ///< told what begins; may throw
};

/// The device library is loaded into this process.  Times of the device are wall time, as a driver of software uses
/// threads of its own.
/// Domain: first <= last <= 12, batch in 1..2^19.
/// Errors: NotAvailable where there is no compiler, no Vulkan in this build, or no such device.
Speeds speeds(const SpeedOptions& options);

}  // namespace mmverify::shaders
