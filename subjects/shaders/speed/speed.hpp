// Times lookups by the shaders of subjects/shaders/subjects on a device, and the library's scalar lookups for
// comparison.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mmverify::shaders {

/// The speed of one function at one level; blocks have no level.
struct Speed {
  std::string function;
  std::optional<std::uint32_t> level = {};
  double device_ns = 0;  ///< ns a lookup: the best wall time of a call, copies included, over lookups
  std::optional<double> cpu_ns =
      {};  ///< impl's ns a lookup: same points, one at a time, one thread; none without such a function
  std::uint64_t differing = 0;  ///< answers that differ from impl's
};

struct Speeds {
  std::vector<std::pair<std::string, std::string>> about;  ///< the device, as in a subject's runs_on
  std::vector<Speed> rows;
};

struct SpeedOptions {
  std::uint32_t device = 0;
  std::uint32_t first = 4, last = 12;                     ///< levels, in steps of four
  std::size_t batch = 1 << 16;                            ///< lookups in a call
  double seconds = 0.1;                                   ///< least time of each of a function's three turns
  std::uint64_t seed = 1;                                 ///< makes the points
  std::function<void(const std::string&)> progress = {};  ///< called with the name of each step; may throw
};

/// Loads the device library into this process. A device's time is wall time, since a software driver uses
/// threads of its own.
/// Domain: first <= last <= 12, batch in 1..2^19.
/// Errors: NotAvailable if there is no compiler, no Vulkan in this build, or no such device.
Speeds speeds(const SpeedOptions& options);

}  // namespace mmverify::shaders
