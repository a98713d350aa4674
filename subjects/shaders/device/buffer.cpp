#include "subjects/shaders/device/buffer.hpp"

#include <algorithm>

namespace mmverify::shaders {

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
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
               VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  check(vkCreateBuffer(device_.handle(), &info, nullptr, &buffer_), "making a buffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device_.handle(), buffer_, &needs);
  VkMemoryAllocateInfo memory{};
  memory.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  memory.allocationSize = needs.size;
  memory.memoryTypeIndex = kind_ == Memory::host ? device_.host_memory(needs.memoryTypeBits)
                                                 : device_.own_memory(needs.memoryTypeBits);
  check(vkAllocateMemory(device_.handle(), &memory, nullptr, &memory_), "allocating memory of the device");
  check(vkBindBufferMemory(device_.handle(), buffer_, memory_, 0), "binding memory");
  if (kind_ == Memory::host)
    check(vkMapMemory(device_.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &data_), "mapping memory");
  return true;
}

}  // namespace mmverify::shaders
