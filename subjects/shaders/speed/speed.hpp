// How fast the lookups of subjects/shaders/ are as kernels on a device, whose data stay in its memory.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace mmverify::shaders {

/// The order of a dispatch's hits. Both orders have the same hits.
enum class Order : std::uint8_t {
  coherent,  ///< neighbouring hits go to neighbouring micro-triangles along the curve
  shuffled,
};

/// The speed of one kernel on so many hits. GB/s are bytes_in + bytes_out over the time: the bytes of the code or map that a
/// lookup reads do not count.
struct Speed {
  std::string kernel;
  std::optional<std::uint32_t> level = {};  ///< none of blocks and copies
  std::uint64_t hits = 0;
  std::optional<Order> order = {};            ///< none of copies
  std::uint32_t bytes_in = 0, bytes_out = 0;  ///< a hit
  double ns = 0;                              ///< of a dispatch: the median of the runs
  double spread = 0;                          ///< (slowest run - fastest run) / median
  std::optional<double> share_of_copy =
      {};  ///< time of the copy kernel of as many words / ns; none of copies
  std::optional<std::uint64_t> checked = {};  ///< hits whose answer was compared; none of vkCmdCopyBuffer
};

struct Speeds {
  std::vector<std::pair<std::string, std::string>> about;  ///< the device, as in a subject's runs_on
  bool is_processor = false;
  std::uint64_t hits = 0;  ///< at most, in a dispatch
  std::string bounded_by;  ///< what keeps them below those asked for; empty if nothing does
  std::size_t runs = 0;    ///< of each kernel
  double bandwidth = 0;    ///< bytes/s of the fastest copy of the most hits, read and written together
  std::vector<Speed> rows;
};

/// An answer of the device is not the library's, or its inputs are not the hits; what() names kernel, hit and both values.
struct WrongAnswer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct SpeedOptions {
  std::uint32_t device = 0;
  std::uint32_t first = 12, last = 12;  ///< levels, in steps of four
  std::uint64_t hits = 0;               ///< the most in a dispatch; 0: 2^28, on a processor 2^20
  std::function<void(const std::string&)> progress = {};  ///< called with the name of each step; may throw
};

/// Loads the device library into this process. Each kernel runs on H, H/64, ... hits, down to 2^16, in both orders: untimed until a
/// graphics card's clock is up, then in timed runs, between the device's own timestamps. H is the greatest power of two up to those asked for that the
/// device's dispatches, buffers and memory take. A sample of up to 2^16 hits is compared with the library, bit for bit.
/// Domain: first <= last <= 12; hits 0 or at least 2.
/// Errors: NotAvailable if there is no compiler, no Vulkan in this build, no such device or no timestamps; DeviceFailed;
/// WrongAnswer.
Speeds speeds(const SpeedOptions& options);

}  // namespace mmverify::shaders
