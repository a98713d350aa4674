// The memory that the tool shares with a worker process: a mailbox, slots of numbers, and room for whole maps
// or codes, all between guard pages.
#pragma once

#include <cstddef>
#include <cstdint>

#include "subjects/dock/entry_points.hpp"
#include "subjects/dock/mailbox.hpp"

namespace mmverify::dock {

/// The number of elements in a call of the subject. A command has up to `slots` such batches, so that the
/// cost of switching processes is small beside 524,288 answers.
constexpr std::size_t batch_size = 4096;
constexpr std::size_t slots = 128;
constexpr std::size_t capacity = batch_size * slots;

/// The number of elements in a call of a subject with MMVERIFY_LARGE_BATCHES.
constexpr std::size_t large_batch_size = batch_size * 16;

/// Room for the largest map, code or case: a 4-state map of level 12 has 4 MiB, its tree 6.7, the largest
/// texture of a question about 16.01.
constexpr std::size_t blob_capacity = std::size_t{1} << 25;

/// Bytes before an answer array that must not change; an overrun at its end hits a guard page.
constexpr std::size_t canary_size = 64;
constexpr unsigned char canary = 0xC5;

/// The descriptor of the shared memory in a new worker, which closes it after mapping.
constexpr int shared_memory_descriptor = 3;

/// The fill byte of an output before a call, and before the repeated call.
constexpr unsigned char blank = 0xD3, blank_again = 0x5A;

/// The offsets in the shared memory. Each slot, and the mailbox, ends at a guard page.
class Layout {
 public:
  explicit Layout(std::size_t page) : page_(page) {}
  std::size_t mailbox_bytes() const { return rounded(sizeof(Mailbox)); }
  std::size_t input_bytes() const { return rounded(batch_size * most_number_bytes); }
  std::size_t answer_bytes() const { return rounded(batch_size * most_answer_bytes + canary_size); }
  std::size_t input(std::size_t array, std::size_t slot) const {
    return mailbox_bytes() + page_ + (array * slots + slot) * (input_bytes() + page_);
  }
  std::size_t answer(std::size_t slot) const {
    return input(most_arrays, 0) + slot * (answer_bytes() + page_);
  }
  std::size_t blob() const { return answer(slots); }
  std::size_t blob_bytes() const { return rounded(blob_capacity); }
  std::size_t blob_answer() const { return blob() + blob_bytes() + page_; }
  std::size_t blob_answer_bytes() const { return rounded(blob_capacity + canary_size); }
  std::size_t total() const { return blob_answer() + blob_answer_bytes() + page_; }
  std::size_t page() const { return page_; }

  /// Offset of the first byte of `count` numbers that end at a slot's end.
  std::size_t input_at(std::size_t array, std::size_t slot, std::size_t count, std::size_t size) const {
    return input(array, slot) + input_bytes() - count * size;
  }
  std::size_t answer_at(std::size_t slot, std::size_t count, std::size_t size) const {
    return answer(slot) + answer_bytes() - count * size;
  }
  /// The same for a map or code, and for the answer to one.
  std::size_t blob_at(std::uint64_t bytes) const {
    return blob() + blob_bytes() - static_cast<std::size_t>(bytes);
  }
  std::size_t blob_answer_at(std::uint64_t bytes) const {
    return blob_answer() + blob_answer_bytes() - static_cast<std::size_t>(bytes);
  }

 private:
  std::size_t rounded(std::size_t bytes) const { return (bytes + page_ - 1) / page_ * page_; }
  std::size_t page_;
};

/// The number of elements in batch `slot` of a command of `count`.
constexpr std::size_t in_slot(std::uint64_t count, std::size_t slot) {
  const std::uint64_t from = slot * batch_size;
  return from >= count ? 0 : static_cast<std::size_t>(count - from < batch_size ? count - from : batch_size);
}

}  // namespace mmverify::dock
