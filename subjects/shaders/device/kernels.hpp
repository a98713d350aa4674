// Kernels on data that stay in a device's memory, timed by the device's own clock. The device library implements
// them; the program reaches them through dlsym, so no exception and no container crosses.
#pragma once

#include <cstddef>
#include <cstdint>

#include "subjects/shaders/device/manifest.hpp"

namespace mmverify::shaders {

/// The bounds of data and dispatches.
struct KernelLimits {
  bool is_processor = false;         ///< a driver that computes on the processor
  std::uint64_t groups = 0;          ///< workgroups of a dispatch
  std::uint64_t buffer_bytes = 0;    ///< of a storage buffer
  std::uint64_t memory_bytes = 0;    ///< of the largest heap of the device's own memory
  std::uint32_t timestamp_bits = 0;  ///< 0: the device has no clock for its kernels
};

/// Buffers at the bindings of docs/SHADER_SUBJECTS.md, in the device's own memory, and one kernel at a time.
/// Each function but the first three returns whether it succeeded; why() has the reason of a failure.
class Kernels {
 public:
  virtual ~Kernels() = default;

  virtual KernelLimits limits() const = 0;
  virtual const char* runs_on() const = 0;
  virtual const char* why() const = 0;

  /// Grows a buffer, which may lose its content.
  virtual bool reserve(std::uint32_t binding, std::uint64_t bytes) = 0;
  virtual bool write(std::uint32_t binding, const void* from, std::uint64_t bytes) = 0;
  virtual bool read(std::uint32_t binding, std::uint64_t at, void* to, std::uint64_t bytes) = 0;
  /// Every word of a buffer is that word.
  virtual bool fill(std::uint32_t binding, std::uint32_t word) = 0;

  /// Makes a module's pipeline, or takes the one made before of that file.
  virtual bool load(const char* spirv_file, const char* function, std::uint32_t group_size) = 0;
  /// Dispatches the loaded kernel, once untimed and then `runs` times; ns gets the time of each, from the end
  /// of the one before to its own. Null and 0: once.
  virtual bool dispatch(const PushConstants& constants, std::size_t runs, double* ns) = 0;
  /// Copies the first bytes of a buffer to another one by vkCmdCopyBuffer, timed the same way.
  virtual bool copy(std::uint32_t from, std::uint32_t to, std::uint64_t bytes, std::size_t runs,
                    double* ns) = 0;
};

/// The library's function of this name: opens a device. Null if there is none, or it has no clock; *why then has
/// the reason. The object is never freed.
using OpenKernels = Kernels*(std::uint32_t device, const char** why);
constexpr const char* open_kernels_name = "mmverify_shader_kernels_v1";

}  // namespace mmverify::shaders
