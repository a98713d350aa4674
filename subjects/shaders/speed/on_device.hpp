// The device library's kernels, with errors as exceptions.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "subjects/shaders/compile/compile.hpp"
#include "subjects/shaders/device/kernels.hpp"

namespace mmverify::shaders {

/// The device has too little memory left, or is lost; what() has the step and Vulkan's result.
struct DeviceFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class OnDevice {
 public:
  /// Loads the device library into this process. Throws NotAvailable if this build has none, or there is no such
  /// device.
  explicit OnDevice(std::uint32_t device);

  const KernelLimits& limits() const { return limits_; }
  /// Facts about the device, key and value.
  std::vector<std::pair<std::string, std::string>> about() const;

  /// Compiles a file of shaders/ and loads its kernel. Throws BadShader, NotAvailable.
  void load(const std::string& file, const std::string& entry_point);

  // The functions of Kernels; they throw DeviceFailed.
  void reserve(std::uint32_t binding, std::uint64_t bytes);
  void write(std::uint32_t binding, const std::vector<std::uint8_t>& bytes);
  void fill(std::uint32_t binding, std::uint32_t word);
  std::vector<std::uint32_t> words(std::uint32_t binding, std::uint64_t first, std::uint64_t count);
  void dispatch(const PushConstants& constants);
  std::vector<double> times(const PushConstants& constants, std::size_t runs);
  std::vector<double> copy_times(std::uint32_t from, std::uint32_t to, std::uint64_t bytes, std::size_t runs);

 private:
  void succeeded(bool did, const char* what) const;

  std::uint32_t number_;
  Kernels* kernels_ = nullptr;
  KernelLimits limits_;
  std::map<std::string, Compiled> compiled_;
};

}  // namespace mmverify::shaders
