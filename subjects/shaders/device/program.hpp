// A compute shader on a device, ready for calls.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "subjects/shaders/device/buffer.hpp"
#include "subjects/shaders/device/commands.hpp"
#include "subjects/shaders/device/pipeline.hpp"

namespace mmverify::shaders {

/// The inputs of one call to a shader.
struct ShaderInputs {
  std::uint32_t level = 0, first = 0, second = 0;
  std::vector<const void*> arrays = {};  ///< each of `count` 32-bit numbers
  const void* bytes = nullptr;           ///< the code, block or map
  std::size_t byte_count = 0;
  std::size_t count = 0;
  std::size_t values = 1;        ///< words in an answer
  const void* before = nullptr;  ///< the answers' initial content; null if it does not matter
};

/// One compute shader and its buffers. Not thread-safe.
class Program {
 public:
  /// Throws NoDevice if the device lacks a feature of the module, std::runtime_error if the driver refuses
  /// the module.
  Program(const Device& device, const Module& module);
  /// The words of the answers, valid until the next call. Throws std::runtime_error if the device is lost or
  /// the validation layer reports something.
  const std::uint32_t* run(const ShaderInputs& asked);

 private:
  void dispatch(const ShaderInputs& asked);

  const Device& device_;
  Pipeline pipeline_;
  Commands commands_;
  std::array<std::unique_ptr<Buffer>, bindings> buffers_;
};

}  // namespace mmverify::shaders
