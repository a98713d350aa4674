#include "subjects/shaders/device/program.hpp"

#include <cstring>

namespace mmverify::shaders {
namespace {

constexpr std::size_t word = sizeof(std::uint32_t);

}  // namespace

Program::Program(const Device& device, const Module& module)
    : device_(device), pipeline_(device, module), commands_(device) {
  for (auto& buffer : buffers_) buffer = std::make_unique<Buffer>(device);
}

const std::uint32_t* Program::run(const ShaderInputs& asked) {
  bool moved = false;
  const auto fill = [&](std::uint32_t binding, const void* from, std::size_t bytes, std::size_t room) {
    moved = buffers_[binding]->reserve(room) || moved;
    if (bytes != 0) std::memcpy(buffers_[binding]->data(), from, bytes);
  };
  for (std::uint32_t k = 0; k < input_bindings; ++k) {
    const std::size_t bytes = k < asked.arrays.size() ? asked.count * word : 0;
    fill(k, k < asked.arrays.size() ? asked.arrays[k] : nullptr, bytes, bytes);
  }
  fill(answer_binding, nullptr, 0, asked.count * asked.values * word);
  // Shaders read whole words: the last word is padded with zeros, and one more word may be read.
  const std::size_t padded = (asked.byte_count + word - 1) / word * word + word;
  fill(bytes_binding, asked.bytes, asked.byte_count, padded);
  std::memset(static_cast<char*>(buffers_[bytes_binding]->data()) + asked.byte_count, 0,
              padded - asked.byte_count);
  // Fills the buffer, so that a value that a shader leaves unwritten is not the previous call's answer.
  void* const answers = buffers_[answer_binding]->data();
  const std::size_t answer_bytes = asked.count * asked.values * word;
  if (asked.before != nullptr)
    std::memcpy(answers, asked.before, answer_bytes);
  else
    std::memset(answers, 0xA7, answer_bytes);
  if (moved) {
    std::array<VkBuffer, bindings> handles{};
    for (std::uint32_t k = 0; k < bindings; ++k) handles[k] = buffers_[k]->handle();
    pipeline_.bind(handles);
  }
  dispatch(asked);
  device_.throw_what_validation_said();
  return static_cast<const std::uint32_t*>(buffers_[answer_binding]->data());
}

void Program::dispatch(const ShaderInputs& asked) {
  VkCommandBuffer command = commands_.begin();
  pipeline_.record(command, {static_cast<std::uint32_t>(asked.count), asked.level, asked.first, asked.second,
                             static_cast<std::uint32_t>(asked.byte_count)});
  VkMemoryBarrier written{};
  written.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(command, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                       &written, 0, nullptr, 0, nullptr);
  commands_.run();
}

}  // namespace mmverify::shaders
