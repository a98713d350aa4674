// The places of a command's numbers, for processes and scripts.
#include "subjects/dock/worker.hpp"

namespace mmverify::dock {

std::byte* Worker::input(Call call, std::size_t array, std::uint64_t count, std::uint64_t t) const {
  const auto slot = static_cast<std::size_t>(t / batch_size);
  const std::size_t size = entry_point(call).signature.number_bytes;
  return base_ + layout_.input_at(array, slot, in_slot(count, slot), size) + t % batch_size * size;
}

const std::byte* Worker::answer(Call call, std::uint64_t count, std::uint64_t t) const {
  const auto slot = static_cast<std::size_t>(t / batch_size);
  const std::size_t size = entry_point(call).answer_bytes;
  return base_ + layout_.answer_at(slot, in_slot(count, slot), size) + t % batch_size * size;
}

}  // namespace mmverify::dock
