#include "subjects/shaders/device/pipeline.hpp"

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

Pipeline::Pipeline(const Device& device, const Module& module) : device_(device), module_(module) {
  const auto words = read_words(module.file);
  if (const std::string what = lacking(device.properties(), words); !what.empty())
    throw NoDevice(device.properties().name + " has no " + what + ", which " + module.entry_point + " uses");
  if (module.group_size > device.properties().limits.maxComputeWorkGroupInvocations)
    throw NoDevice(device.properties().name + " has workgroups of up to " +
                   std::to_string(device.properties().limits.maxComputeWorkGroupInvocations) +
                   " invocations, and " + module.entry_point + " has " + std::to_string(module.group_size));
  make_layout();
  make_set();
  make_pipeline(words);
}

Pipeline::~Pipeline() {
  VkDevice d = device_.handle();
  if (descriptors_ != VK_NULL_HANDLE) vkDestroyDescriptorPool(d, descriptors_, nullptr);
  if (pipeline_ != VK_NULL_HANDLE) vkDestroyPipeline(d, pipeline_, nullptr);
  if (layout_ != VK_NULL_HANDLE) vkDestroyPipelineLayout(d, layout_, nullptr);
  if (set_layout_ != VK_NULL_HANDLE) vkDestroyDescriptorSetLayout(d, set_layout_, nullptr);
}

void Pipeline::make_layout() {
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
}

void Pipeline::make_set() {
  VkDevice d = device_.handle();
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
}

void Pipeline::make_pipeline(const std::vector<std::uint32_t>& words) {
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

void Pipeline::bind(const std::array<VkBuffer, bindings>& buffers) {
  std::array<VkDescriptorBufferInfo, bindings> infos{};
  std::array<VkWriteDescriptorSet, bindings> writes{};
  for (std::uint32_t k = 0; k < bindings; ++k) {
    infos[k] = {buffers[k], 0, VK_WHOLE_SIZE};
    writes[k].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[k].dstSet = set_;
    writes[k].dstBinding = k;
    writes[k].descriptorCount = 1;
    writes[k].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[k].pBufferInfo = &infos[k];
  }
  vkUpdateDescriptorSets(device_.handle(), bindings, writes.data(), 0, nullptr);
}

void Pipeline::record(VkCommandBuffer command, const PushConstants& constants) const {
  const std::uint64_t groups = (std::uint64_t{constants.count} + module_.group_size - 1) / module_.group_size;
  if (groups > device_.properties().limits.maxComputeWorkGroupCount[0])
    throw std::runtime_error("more workgroups than the device takes: make them larger than " +
                             std::to_string(module_.group_size));
  vkCmdBindPipeline(command, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vkCmdBindDescriptorSets(command, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0, nullptr);
  vkCmdPushConstants(command, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof constants, &constants);
  vkCmdDispatch(command, static_cast<std::uint32_t>(groups), 1, 1);
}

}  // namespace mmverify::shaders
