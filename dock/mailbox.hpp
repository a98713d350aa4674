// The memory that the tool and a worker process share: a mailbox, numbers in slots and whole maps or codes,
// all between guard pages.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace mmverify::dock {

/// Entry points by number, in the order of the C header.
enum class Call : std::uint32_t {
  index_f32,
  index_f64,
  corners,
  row_index_f32,
  row_corners,
  tree_encode,
  tree_decode,
  tree_lookup,
  tree_lookup_f32,
  micromap_pack,
  micromap_unpack,
  micromap_force2,
  micromap_widen,
  micromap_up,
  micromap_down,
  micromap_through,
  micromap_substitute,
  vq2_decode,
  vq2_region,
  vq2_encode,
  vq4_decode,
  vq4_region,
  vq4_encode,
  bake
};
constexpr std::uint32_t calls = 24;

/// Whether it is about a map or a code, which lies apart from the slots, and so does its answer.
constexpr bool of_codec(Call c) { return c >= Call::tree_encode; }

/// Bytes of one input number, how many input arrays, and bytes of one answer.
constexpr std::size_t input_size(Call c) { return c == Call::index_f64 ? 8 : 4; }
constexpr std::size_t input_arrays(Call c) {
  switch (c) {
    case Call::index_f32:
    case Call::index_f64:
    case Call::row_index_f32:
    case Call::tree_lookup_f32:
    case Call::vq2_region:
    case Call::vq4_region:
      return 2;
    case Call::corners:
    case Call::row_corners:
    case Call::tree_lookup:
      return 1;
    default:
      return 0;
  }
}
constexpr std::size_t answer_size(Call c) {
  return c == Call::corners || c == Call::row_corners ? 24 : of_codec(c) ? 1 : 4;
}

/// A subject is called with this many elements at a time, a command carries up to `slots` such batches: one
/// switch of processes for all of them keeps its cost small beside 524,288 answers.
constexpr std::size_t batch_size = 4096;
constexpr std::size_t slots = 128;
constexpr std::size_t capacity = batch_size * slots;

/// The largest map or code: a 4-state map of level 12 has 4 MiB, its tree 6.7.
constexpr std::size_t blob_capacity = std::size_t{1} << 24;

/// Bytes before an answer array that must stay as they are: an overrun at the far end meets a guard page.
constexpr std::size_t canary_size = 64;
constexpr unsigned char canary = 0xC5;

/// What lies in an output before a call, and before the same elements are asked again.
constexpr unsigned char blank = 0xD3, blank_again = 0x5A;

enum class Outcome : std::uint32_t {
  ready,
  cannot_load,
  answered,
  threw,
  changed_mode,
  wrote_before,
  unwritten,
  non_deterministic,
  too_large
};

/// What was loaded.
struct Description {
  char name[128];
  std::uint32_t max_level, flags, has;  ///< has: bit c for Call c
};

struct Mailbox {
  std::atomic<std::uint32_t> turn;  ///< 0: the tool's, 1: the worker's; the futex both wait on
  // From the tool.
  Call call;
  std::uint32_t level;
  std::uint32_t one_by_one;  ///< call with one element at a time, to find the one that does it
  std::uint64_t count;
  std::uint32_t format;  ///< of a map: its states' bits; of micromap_through its mode; of a block or a case 0
  std::uint64_t blob_bytes;  ///< of the map or code that is asked about
  std::uint64_t room;        ///< of the answer to it: bytes that must be written, of an encoder that may be
  // From the worker, the first also while it works.
  std::atomic<std::uint64_t> begun;  ///< elements before the batch that is being worked on
  Outcome outcome;
  std::uint64_t element;  ///< the one that `outcome` is about
  char message[512];
  std::uint32_t taken;         ///< what an encoder or decoder made of the map or code: 0 for nothing
  std::uint64_t answer_bytes;  ///< and how many bytes of it
  Description description;
};

/// Where things lie. Every slot ends at a page that cannot be touched, and so does the mailbox.
class Layout {
 public:
  explicit Layout(std::size_t page) : page_(page) {}
  std::size_t mailbox_bytes() const { return rounded(sizeof(Mailbox)); }
  std::size_t input_bytes() const { return rounded(batch_size * 8); }
  std::size_t answer_bytes() const { return rounded(batch_size * 24 + canary_size); }
  std::size_t input(std::size_t array, std::size_t slot) const {
    return mailbox_bytes() + page_ + (array * slots + slot) * (input_bytes() + page_);
  }
  std::size_t answer(std::size_t slot) const { return input(2, 0) + slot * (answer_bytes() + page_); }
  std::size_t blob() const { return answer(slots); }
  std::size_t blob_bytes() const { return rounded(blob_capacity); }
  std::size_t blob_answer() const { return blob() + blob_bytes() + page_; }
  std::size_t blob_answer_bytes() const { return rounded(blob_capacity + canary_size); }
  std::size_t total() const { return blob_answer() + blob_answer_bytes() + page_; }
  std::size_t page() const { return page_; }

  /// First byte of `count` numbers pushed against the end of a slot.
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

/// Elements of batch `slot` of a command of `count`.
constexpr std::size_t in_slot(std::uint64_t count, std::size_t slot) {
  const std::uint64_t from = slot * batch_size;
  return from >= count ? 0 : static_cast<std::size_t>(count - from < batch_size ? count - from : batch_size);
}

}  // namespace mmverify::dock
