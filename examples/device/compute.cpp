#include "compute.hpp"

#include <array>

namespace rays {
namespace {

#include "rays_spirv.h"

constexpr std::uint32_t threads = 64;  // of a workgroup, as rays.comp has it
constexpr std::array kinds = {VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR,
                              VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};

}  // namespace

Pipeline::Pipeline(const Device& device) : device_(device) {
  make_set();
  make_pipeline();
}

Pipeline::~Pipeline() {
  vkDestroyPipeline(device_.handle(), pipeline_, nullptr);
  vkDestroyPipelineLayout(device_.handle(), layout_, nullptr);
  vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), set_layout_, nullptr);
}

void Pipeline::make_set() {
  std::array<VkDescriptorSetLayoutBinding, kinds.size()> bindings{};
  std::array<VkDescriptorPoolSize, kinds.size()> sizes{};
  for (std::uint32_t k = 0; k < kinds.size(); ++k) {
    bindings[k] = {k, kinds[k], 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    sizes[k] = {kinds[k], 1};
  }
  VkDescriptorSetLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  layout.bindingCount = static_cast<std::uint32_t>(bindings.size());
  layout.pBindings = bindings.data();
  check(vkCreateDescriptorSetLayout(device_.handle(), &layout, nullptr, &set_layout_),
        "vkCreateDescriptorSetLayout");
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = 1;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  check(vkCreateDescriptorPool(device_.handle(), &pool, nullptr, &pool_), "vkCreateDescriptorPool");
  VkDescriptorSetAllocateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  set.descriptorPool = pool_;
  set.descriptorSetCount = 1;
  set.pSetLayouts = &set_layout_;
  check(vkAllocateDescriptorSets(device_.handle(), &set, &set_), "vkAllocateDescriptorSets");
}

void Pipeline::make_pipeline() {
  const VkPushConstantRange constants{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(std::uint32_t)};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &set_layout_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &constants;
  check(vkCreatePipelineLayout(device_.handle(), &layout, nullptr, &layout_), "vkCreatePipelineLayout");
  VkShaderModuleCreateInfo code{};
  code.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  code.codeSize = sizeof rays_spirv;
  code.pCode = rays_spirv;
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.layout = layout_;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.pName = "main";
  check(vkCreateShaderModule(device_.handle(), &code, nullptr, &info.stage.module), "vkCreateShaderModule");
  const VkResult result =
      vkCreateComputePipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_);
  vkDestroyShaderModule(device_.handle(), info.stage.module, nullptr);
  check(result, "vkCreateComputePipelines");
}

void Pipeline::bind(VkAccelerationStructureKHR scene, VkBuffer rays, VkBuffer hits) {
  VkWriteDescriptorSetAccelerationStructureKHR structure{};
  structure.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR;
  structure.accelerationStructureCount = 1;
  structure.pAccelerationStructures = &scene;
  const std::array<VkDescriptorBufferInfo, kinds.size()> buffers = {
      {{}, {rays, 0, VK_WHOLE_SIZE}, {hits, 0, VK_WHOLE_SIZE}}};
  std::array<VkWriteDescriptorSet, kinds.size()> writes{};
  for (std::uint32_t k = 0; k < kinds.size(); ++k) {
    writes[k].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[k].dstSet = set_;
    writes[k].dstBinding = k;
    writes[k].descriptorCount = 1;
    writes[k].descriptorType = kinds[k];
    writes[k].pBufferInfo = &buffers[k];
  }
  writes[0].pNext = &structure;
  writes[0].pBufferInfo = nullptr;
  vkUpdateDescriptorSets(device_.handle(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0,
                         nullptr);
}

void Pipeline::dispatch(VkCommandBuffer commands, std::uint32_t count) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0, nullptr);
  vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof count, &count);
  vkCmdDispatch(commands, (count + threads - 1) / threads, 1, 1);
}

}  // namespace rays
