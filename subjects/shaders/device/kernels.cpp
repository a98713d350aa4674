#include "subjects/shaders/device/kernels.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "subjects/shaders/device/buffer.hpp"
#include "subjects/shaders/device/commands.hpp"
#include "subjects/shaders/device/pipeline.hpp"

namespace mmverify::shaders {
namespace {

constexpr std::uint64_t staging_bytes = std::uint64_t{1} << 22;

/// All commands before it, those of earlier submissions too, end, and what they wrote is seen, before a command after it begins.
void wait_for_all(VkCommandBuffer command) {
  VkMemoryBarrier all{};
  all.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  all.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  all.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  vkCmdPipelineBarrier(command, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1,
                       &all, 0, nullptr, 0, nullptr);
}

/// Timestamps of a queue.
class Clock {
 public:
  Clock(const Device& device, std::size_t stamps) : device_(device), stamps_(stamps) {
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = static_cast<std::uint32_t>(stamps);
    check(vkCreateQueryPool(device.handle(), &info, nullptr, &pool_), "making a pool of timestamps");
  }
  ~Clock() { vkDestroyQueryPool(device_.handle(), pool_, nullptr); }
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;

  void reset(VkCommandBuffer command) {
    vkCmdResetQueryPool(command, pool_, 0, static_cast<std::uint32_t>(stamps_));
  }
  /// The time at which all commands before it have ended.
  void stamp(VkCommandBuffer command) {
    vkCmdWriteTimestamp(command, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_, next_++);
  }
  /// ns between each stamp and the next one, once all have been written.
  void read(double* ns) const {
    std::vector<std::uint64_t> ticks(stamps_);
    check(
        vkGetQueryPoolResults(device_.handle(), pool_, 0, next_, ticks.size() * sizeof ticks[0], ticks.data(),
                              sizeof ticks[0], VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "reading timestamps");
    const Properties& p = device_.properties();
    // Differences are modulo the clock's width.
    const std::uint64_t mask =
        p.timestamp_bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << p.timestamp_bits) - 1;
    for (std::size_t k = 0; k + 1 < ticks.size(); ++k)
      ns[k] = static_cast<double>((ticks[k + 1] - ticks[k]) & mask) *
              static_cast<double>(p.limits.timestampPeriod);
  }

 private:
  const Device& device_;
  const std::size_t stamps_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  std::uint32_t next_ = 0;
};

class Resident final : public Kernels {
 public:
  Resident(std::uint32_t number, bool validation)
      : device_(number, validation), commands_(device_), staging_(device_) {
    for (auto& buffer : buffers_) {
      buffer = std::make_unique<Buffer>(device_, Memory::own);
      buffer->reserve(sizeof(std::uint32_t));
    }
    staging_.reserve(staging_bytes);
    runs_on_ = shaders::runs_on(device_.properties(), validation);
  }

  KernelLimits limits() const override {
    const Properties& p = device_.properties();
    return {p.is_processor, p.limits.maxComputeWorkGroupCount[0], p.limits.maxStorageBufferRange,
            p.memory_bytes, p.timestamp_bits};
  }
  const char* runs_on() const override { return runs_on_.c_str(); }
  const char* why() const override { return why_.c_str(); }

  bool reserve(std::uint32_t binding, std::uint64_t bytes) override {
    return tried([&] { buffers_.at(binding)->reserve(bytes); });
  }
  bool write(std::uint32_t binding, const void* from, std::uint64_t bytes) override {
    return tried([&] {
      for (std::uint64_t at = 0; at < bytes; at += staging_bytes) {
        const std::uint64_t part = std::min(staging_bytes, bytes - at);
        std::memcpy(staging_.data(), static_cast<const char*>(from) + at, part);
        move(staging_, 0, *buffers_.at(binding), at, part);
      }
    });
  }
  bool read(std::uint32_t binding, std::uint64_t at, void* to, std::uint64_t bytes) override {
    return tried([&] {
      for (std::uint64_t done = 0; done < bytes; done += staging_bytes) {
        const std::uint64_t part = std::min(staging_bytes, bytes - done);
        move(*buffers_.at(binding), at + done, staging_, 0, part);
        std::memcpy(static_cast<char*>(to) + done, staging_.data(), part);
      }
    });
  }
  bool fill(std::uint32_t binding, std::uint32_t word) override {
    return tried([&] {
      VkCommandBuffer command = commands_.begin();
      wait_for_all(command);
      vkCmdFillBuffer(command, buffers_.at(binding)->handle(), 0, VK_WHOLE_SIZE, word);
      commands_.run();
    });
  }
  bool load(const char* spirv_file, const char* function, std::uint32_t group_size) override {
    return tried([&] {
      std::unique_ptr<Pipeline>& kept = pipelines_[spirv_file];
      if (kept == nullptr)
        kept = std::make_unique<Pipeline>(device_, Module{"the kernel", function, group_size, spirv_file});
      loaded_ = kept.get();
    });
  }
  bool dispatch(const PushConstants& constants, std::size_t runs, double* ns) override {
    return tried([&] {
      bind();
      time(runs, ns, [&](VkCommandBuffer command) { loaded_->record(command, constants); });
    });
  }
  bool copy(std::uint32_t from, std::uint32_t to, std::uint64_t bytes, std::size_t runs,
            double* ns) override {
    return tried([&] {
      const VkBufferCopy all{0, 0, bytes};
      time(runs, ns, [&](VkCommandBuffer command) {
        vkCmdCopyBuffer(command, buffers_.at(from)->handle(), buffers_.at(to)->handle(), 1, &all);
      });
    });
  }

 private:
  template <class Work>
  bool tried(const Work& work) {
    try {
      work();
      device_.throw_what_validation_said();
      return true;
    } catch (const std::exception& error) {
      why_ = error.what();
      return false;
    }
  }

  void move(const Buffer& from, std::uint64_t from_at, const Buffer& to, std::uint64_t to_at,
            std::uint64_t bytes) {
    VkCommandBuffer command = commands_.begin();
    wait_for_all(command);
    const VkBufferCopy part{from_at, to_at, bytes};
    vkCmdCopyBuffer(command, from.handle(), to.handle(), 1, &part);
    VkMemoryBarrier seen{};
    seen.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    seen.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    seen.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(command, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &seen, 0,
                         nullptr, 0, nullptr);
    commands_.run();
  }

  void bind() {
    std::array<VkBuffer, bindings> handles{};
    for (std::uint32_t k = 0; k < bindings; ++k) handles[k] = buffers_[k]->handle();
    loaded_->bind(handles);
  }

  void time(std::size_t runs, double* ns, const std::function<void(VkCommandBuffer)>& record) {
    Clock clock(device_, runs + 1);
    VkCommandBuffer command = commands_.begin();
    clock.reset(command);
    wait_for_all(command);
    for (std::size_t k = 0; k <= runs; ++k) {
      record(command);
      wait_for_all(command);
      clock.stamp(command);
    }
    commands_.run();
    if (runs != 0) clock.read(ns);
  }

  const Device device_;
  Commands commands_;
  Buffer staging_;
  std::array<std::unique_ptr<Buffer>, bindings> buffers_;
  std::map<std::string, std::unique_ptr<Pipeline>> pipelines_;  ///< by the module's file
  Pipeline* loaded_ = nullptr;
  std::string runs_on_, why_;
};

std::string why_not_opened;

}  // namespace
}  // namespace mmverify::shaders

extern "C" mmverify::shaders::Kernels* mmverify_shader_kernels_v1(std::uint32_t device, const char** why) {
  using namespace mmverify::shaders;
  try {
    auto opened = std::make_unique<Resident>(device, std::getenv(validation_variable) != nullptr);
    if (opened->limits().timestamp_bits != 0) return opened.release();
    why_not_opened = "the device has no timestamps, by which kernels are timed";
  } catch (const std::exception& error) {
    why_not_opened = error.what();
  }
  *why = why_not_opened.c_str();
  return nullptr;
}
