#include "subjects/shaders/device/program.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace mmverify::shaders {
namespace {

constexpr std::size_t word = sizeof(std::uint32_t);

std::vector<std::uint32_t> read_words(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  if (bytes.empty() || bytes.size() % word != 0) throw std::runtime_error(file + ": no SPIR-V");
  std::vector<std::uint32_t> words(bytes.size() / word);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

/// Number types that the module uses and the device lacks; empty if there are none.
std::string lacking(const Properties& p, const std::vector<std::uint32_t>& words) {
  constexpr std::uint32_t header = 5, capability = 17;
  enum : std::uint32_t { float16 = 9, float64 = 10, int64 = 11, int16 = 22, int8 = 39 };
  for (std::size_t at = header; at + 1 < words.size() && words[at] >> 16 != 0; at += words[at] >> 16) {
    if ((words[at] & 0xffffu) != capability) continue;
    const std::uint32_t needed = words[at + 1];
    if (needed == float64 && p.features.shaderFloat64 == VK_FALSE) return "binary64";
    if (needed == int64 && p.features.shaderInt64 == VK_FALSE) return "64-bit integers";
    if (needed == int16 && p.features.shaderInt16 == VK_FALSE) return "16-bit integers";
    if (needed == float16 && !p.float16) return "binary16";
    if (needed == int8 && !p.int8) return "8-bit integers";
  }
  return {};
}

}  // namespace

void Buffer::free() {
  if (buffer_ != VK_NULL_HANDLE) vkDestroyBuffer(device_.handle(), buffer_, nullptr);
  if (memory_ != VK_NULL_HANDLE) vkFreeMemory(device_.handle(), memory_, nullptr);
  buffer_ = VK_NULL_HANDLE;
  memory_ = VK_NULL_HANDLE;
}

bool Buffer::reserve(std::size_t bytes) {
  if (buffer_ != VK_NULL_HANDLE && bytes <= bytes_) return false;
  free();
  constexpr std::size_t least = 4096;
  bytes_ = std::max(least, bytes);
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes_;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  check(vkCreateBuffer(device_.handle(), &info, nullptr, &buffer_), "making a buffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device_.handle(), buffer_, &needs);
  VkMemoryAllocateInfo memory{};
  memory.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  memory.allocationSize = needs.size;
  memory.memoryTypeIndex = device_.host_memory(needs.memoryTypeBits);
  check(vkAllocateMemory(device_.handle(), &memory, nullptr, &memory_), "allocating memory of the device");
  check(vkBindBufferMemory(device_.handle(), buffer_, memory_, 0), "binding memory");
  check(vkMapMemory(device_.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &data_), "mapping memory");
  return true;
}

Program::Program(const Device& device, const Module& module) : device_(device), module_(module) {
  const auto words = read_words(module.file);
  if (const std::string what = lacking(device.properties(), words); !what.empty())
    throw NoDevice(device.properties().name + " has no " + what + ", which " + module.entry_point + " uses");
  if (module.group_size > device.properties().limits.maxComputeWorkGroupInvocations)
    throw NoDevice(device.properties().name + " has workgroups of up to " +
                   std::to_string(device.properties().limits.maxComputeWorkGroupInvocations) +
                   " invocations, and " + module.entry_point + " has " + std::to_string(module.group_size));
  make_layout();
  make_pipeline(words);
  for (auto& buffer : buffers_) buffer = std::make_unique<Buffer>(device);
}

Program::~Program() {
  VkDevice d = device_.handle();
  if (fence_ != VK_NULL_HANDLE) vkDestroyFence(d, fence_, nullptr);
  if (commands_ != VK_NULL_HANDLE) vkDestroyCommandPool(d, commands_, nullptr);
  if (descriptors_ != VK_NULL_HANDLE) vkDestroyDescriptorPool(d, descriptors_, nullptr);
  if (pipeline_ != VK_NULL_HANDLE) vkDestroyPipeline(d, pipeline_, nullptr);
  if (layout_ != VK_NULL_HANDLE) vkDestroyPipelineLayout(d, layout_, nullptr);
  if (set_layout_ != VK_NULL_HANDLE) vkDestroyDescriptorSetLayout(d, set_layout_, nullptr);
}

void Program::make_layout() {
  VkDevice d = device_.handle();
  std::array<VkDescriptorSetLayoutBinding, bindings> slots{};
  for (std::uint32_t k = 0; k < bindings; ++k)
    slots[k] = {k, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set.bindingCount = bindings;
  set.pBindings = slots.data();
  check(vkCreateDescriptorSetLayout(d, &set, nullptr, &set_layout_), "making a descriptor set's layout");
  const VkPushConstantRange constants{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(PushConstants)};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &set_layout_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &constants;
  check(vkCreatePipelineLayout(d, &layout, nullptr, &layout_), "making a pipeline's layout");

  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, bindings};
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = 1;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &size;
  check(vkCreateDescriptorPool(d, &pool, nullptr, &descriptors_), "making a descriptor pool");
  VkDescriptorSetAllocateInfo one{};
  one.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  one.descriptorPool = descriptors_;
  one.descriptorSetCount = 1;
  one.pSetLayouts = &set_layout_;
  check(vkAllocateDescriptorSets(d, &one, &set_), "allocating a descriptor set");

  VkCommandPoolCreateInfo commands{};
  commands.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  commands.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  commands.queueFamilyIndex = device_.queue_family();
  check(vkCreateCommandPool(d, &commands, nullptr, &commands_), "making a command pool");
  VkCommandBufferAllocateInfo buffer{};
  buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  buffer.commandPool = commands_;
  buffer.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  buffer.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(d, &buffer, &command_), "allocating a command buffer");
  VkFenceCreateInfo fence{};
  fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  check(vkCreateFence(d, &fence, nullptr, &fence_), "making a fence");
}

void Program::make_pipeline(const std::vector<std::uint32_t>& words) {
  VkDevice d = device_.handle();
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = words.size() * word;
  info.pCode = words.data();
  VkShaderModule shader = VK_NULL_HANDLE;
  check(vkCreateShaderModule(d, &info, nullptr, &shader), "making a shader module");
  VkComputePipelineCreateInfo pipeline{};
  pipeline.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  pipeline.layout = layout_;
  pipeline.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  pipeline.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  pipeline.stage.module = shader;
  pipeline.stage.pName = module_.function.c_str();
  const VkResult result = vkCreateComputePipelines(d, VK_NULL_HANDLE, 1, &pipeline, nullptr, &pipeline_);
  vkDestroyShaderModule(d, shader, nullptr);
  check(result, "making a compute pipeline");
}

void Program::bind() {
  std::array<VkDescriptorBufferInfo, bindings> infos{};
  std::array<VkWriteDescriptorSet, bindings> writes{};
  for (std::uint32_t k = 0; k < bindings; ++k) {
    infos[k] = {buffers_[k]->handle(), 0, VK_WHOLE_SIZE};
    writes[k].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[k].dstSet = set_;
    writes[k].dstBinding = k;
    writes[k].descriptorCount = 1;
    writes[k].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[k].pBufferInfo = &infos[k];
  }
  vkUpdateDescriptorSets(device_.handle(), bindings, writes.data(), 0, nullptr);
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
  if (moved) bind();
  dispatch(asked);
  device_.throw_what_validation_said();
  return static_cast<const std::uint32_t*>(buffers_[answer_binding]->data());
}

void Program::dispatch(const ShaderInputs& asked) {
  const std::size_t groups = (asked.count + module_.group_size - 1) / module_.group_size;
  if (groups > device_.properties().limits.maxComputeWorkGroupCount[0])
    throw std::runtime_error("more workgroups than the device takes: make them larger than " +
                             std::to_string(module_.group_size));
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(command_, &begin), "beginning a command buffer");
  const PushConstants constants{static_cast<std::uint32_t>(asked.count), asked.level, asked.first,
                                asked.second, static_cast<std::uint32_t>(asked.byte_count)};
  vkCmdBindPipeline(command_, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vkCmdBindDescriptorSets(command_, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0, nullptr);
  vkCmdPushConstants(command_, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof constants, &constants);
  vkCmdDispatch(command_, static_cast<std::uint32_t>(groups), 1, 1);
  VkMemoryBarrier written{};
  written.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(command_, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                       &written, 0, nullptr, 0, nullptr);
  check(vkEndCommandBuffer(command_), "ending a command buffer");
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &command_;
  check(vkQueueSubmit(device_.queue(), 1, &submit, fence_), "submitting");
  // No timeout here: if the device hangs, the tool ends the worker.
  check(vkWaitForFences(device_.handle(), 1, &fence_, VK_TRUE, UINT64_MAX), "waiting for the device");
  check(vkResetFences(device_.handle(), 1, &fence_), "resetting a fence");
}

}  // namespace mmverify::shaders
