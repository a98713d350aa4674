// Batches for a subject of MMVERIFY_LARGE_BATCHES: the slots of one call are copied together for it.
#include <algorithm>
#include <cstring>

#include "subjects/dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

/// The number of elements that are asked one by one: each costs as much as a batch.
constexpr std::size_t one_by_one = 64;

}  // namespace

Fenced Desk::ask_at_once(std::size_t from, std::size_t count, unsigned char filling) {
  const std::size_t bytes = asked().signature.number_bytes, wide = asked().answer_bytes;
  std::vector<std::byte> inputs[most_arrays];
  Arguments a{};
  a.level = mailbox_.level;
  a.format = mailbox_.format;
  a.count = count;
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array].reserve(count * bytes);
    for (std::size_t at = from; at < from + count; at += batch_size) {
      const std::size_t slot = at / batch_size, size = in_slot(mailbox_.count, slot);
      const std::byte* numbers = base_ + layout_.input_at(array, slot, size, bytes);
      inputs[array].insert(inputs[array].end(), numbers, numbers + size * bytes);
    }
    a.arrays[array] = inputs[array].data();
  }
  Fenced out(count * wide, filling);
  mailbox_.begun.store(from, std::memory_order_relaxed);
  guarded(a, out, from);
  return out;
}

void Desk::run_on_large_batches(std::uint64_t number) {
  const auto all = static_cast<std::size_t>(mailbox_.count);
  const std::size_t wide = asked().answer_bytes, batches = (all + batch_size - 1) / batch_size;
  const auto each_slot = [&](std::size_t from, std::size_t count, const Fenced& out, auto visit) {
    for (std::size_t at = from; at < from + count; at += batch_size)
      visit(at / batch_size, out.data() + (at - from) * wide);
  };
  const auto each_call = [&](auto visit) {
    for (std::size_t from = 0; from < all; from += large_batch_size)
      visit(from, std::min(large_batch_size, all - from));
  };
  each_call([&](std::size_t from, std::size_t count) {
    each_slot(from, count, ask_at_once(from, count, blank), [&](std::size_t slot, const std::byte* answers) {
      std::memcpy(slot_answer(slot), answers, in_slot(mailbox_.count, slot) * wide);
    });
  });
  if (first_at_this_level()) {
    each_call([&](std::size_t from, std::size_t count) {
      each_slot(from, count, ask_at_once(from, count, blank_again),
                [&](std::size_t slot, const std::byte* answers) {
                  compare(slot_answer(slot), answers, in_slot(mailbox_.count, slot), slot * batch_size,
                          "asked again");
                });
    });
    ask_slot_again(0, 7);
    ask_slot_again(0, 1, one_by_one);
    ask_slot_after_another_level(0, one_by_one);
    ask_slot_many_times_over(0);
    ask_slot_in_circumstances(0);
    ask_slot_with_one_array(0);
    ask_slot_from_many_threads(0);
    mark_level();
  }
  constexpr std::size_t sizes[] = {batch_size, batch_size - 1};
  ask_slot_again(number % batches, sizes[number / slots % 2]);
}

}  // namespace mmverify::dock
