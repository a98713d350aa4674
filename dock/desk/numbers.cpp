// Commands on numbers in slots: batches whose answers may not depend on each other.
#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>

#include "dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

/// More elements than 16 bits count, and no multiple of a vector's.
constexpr std::size_t odd_batch = large_batch_size + 7;

}  // namespace

void Desk::run_on_numbers(std::uint64_t number) {
  if ((subject_.flags & MMVERIFY_LARGE_BATCHES) != 0 && mailbox_.one_by_one == 0)
    return run_on_large_batches(number);
  FromThreads first;
  if (first_at_this_level() && mailbox_.one_by_one == 0) first = slot_from_threads_first(0);
  for (std::size_t slot = 0; in_slot(mailbox_.count, slot) != 0; ++slot) call_slot(slot);
  if (mailbox_.one_by_one != 0) return;
  for (const Answers& one : first)
    if (!one.sizes.empty())
      compare(slot_answer(0), one.in_round(0), in_slot(mailbox_.count, 0), 0,
              "asked from two threads at once, the first time at this level");
  const std::size_t batches = static_cast<std::size_t>((mailbox_.count + batch_size - 1) / batch_size);
  // The first command of a level is asked again in every way, all of it; the others, a batch in a way in turn.
  for (std::size_t slot = 0; first_at_this_level() && slot < batches; ++slot) {
    for (const std::size_t size : {batch_size, std::size_t{7}, std::size_t{1}}) ask_slot_again(slot, size);
    ask_slot_in_another_order(slot);
    ask_slot_from_threads(slot);
    if (slot != 0) continue;
    ask_slot_after_another_level(slot);
    ask_slot_many_times_over(slot);
    ask_slot_at_other_places(slot);
  }
  mark_level();
  constexpr std::size_t sizes[] = {batch_size, 7, batch_size - 1, 1};
  ask_slot_again(number % batches, sizes[number / slots % 4]);
}

bool Desk::first_at_this_level() const {
  return (probed_[static_cast<std::size_t>(mailbox_.call)][mailbox_.format % formats] >>
              (mailbox_.level % 32) &
          1) == 0;
}

void Desk::mark_level() {
  probed_[static_cast<std::size_t>(mailbox_.call)][mailbox_.format % formats] |= std::uint64_t{1}
                                                                                 << (mailbox_.level % 32);
}

Arguments Desk::piece(std::size_t slot, std::size_t at, std::size_t count, std::byte* out) const {
  const std::size_t bytes = asked().signature.number_bytes;
  Arguments a{};
  a.level = mailbox_.level;
  a.format = mailbox_.format;
  for (std::size_t array = 0; array < asked().signature.arrays; ++array)
    a.arrays[array] =
        base_ + layout_.input_at(array, slot, in_slot(mailbox_.count, slot), bytes) + at * bytes;
  a.count = count;
  a.out = out;
  return a;
}

std::byte* Desk::slot_answer(std::size_t slot) const {
  return base_ + layout_.answer_at(slot, in_slot(mailbox_.count, slot), asked().answer_bytes);
}

void Desk::call_slot(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes;
  std::byte* out = slot_answer(slot);
  set_canary(out);
  // Filling costs time; what the first command of a level covers is enough to see an output left alone.
  if (first_at_this_level()) std::memset(out, blank, count * wide);
  const std::size_t step = mailbox_.one_by_one != 0 ? 1 : count;
  for (std::size_t at = 0; at < count; at += step) {
    mailbox_.begun.store(from + at, std::memory_order_relaxed);
    guarded(piece(slot, at, step, out + at * wide), from + at);
  }
  check_canary(out, from);
}

void Desk::ask_slot_again(std::size_t slot, std::size_t size, std::size_t most) {
  const std::size_t count = std::min(in_slot(mailbox_.count, slot), most), from = slot * batch_size,
                    wide = asked().answer_bytes;
  mailbox_.begun.store(from, std::memory_order_relaxed);
  again_.assign(count * wide, std::byte{blank_again});
  for (std::size_t at = 0; at < count; at += size)
    guarded(piece(slot, at, std::min(size, count - at), again_.data() + at * wide), from + at);
  compare(slot_answer(slot), again_.data(), count, from,
          size == batch_size ? "asked again" : "asked in batches of " + std::to_string(size));
}

void Desk::ask_slot_after_another_level(std::size_t slot, std::size_t most) {
  if (mailbox_.this_level_alone != 0) return;
  const std::uint32_t level = mailbox_.level;
  // Three vertices that are a face's at one level need not be one's at another.
  if (mailbox_.call == Call::attribute_face_of) return;
  if (level < subject_.max_level) ask_slot_after(slot, level + 1, 0, most);
  if (asked().signature.of_points) {
    if (level == subject_.max_level && level != 0) ask_slot_after(slot, level - 1, 0, most);
    return;
  }
  // An index is one of a lower level only by its first digits: the parent's, and the first child's of all.
  if (asked().signature.arrays != 1) return;
  if (level > 0) ask_slot_after(slot, level - 1, 2, most);
  if (level > 2) ask_slot_after(slot, 1, 2 * (level - 1), most);
}

void Desk::ask_slot_after(std::size_t slot, std::uint32_t other, unsigned less_bits, std::size_t most) {
  const std::size_t count = std::min(in_slot(mailbox_.count, slot), most), from = slot * batch_size,
                    wide = asked().answer_bytes;
  std::vector<std::byte> there(wide);
  again_.assign(count * wide, std::byte{blank_again});
  for (std::size_t at = 0; at < count; ++at) {
    Arguments before = piece(slot, at, 1, there.data());
    before.level = other;
    std::uint32_t index = 0;
    if (less_bits != 0) {
      std::memcpy(&index, before.arrays[0], sizeof index);
      index >>= less_bits;
      before.arrays[0] = reinterpret_cast<const std::byte*>(&index);
    }
    mailbox_.another_level.store(1, std::memory_order_relaxed);
    guarded(before, from + at);
    mailbox_.another_level.store(0, std::memory_order_relaxed);
    guarded(piece(slot, at, 1, again_.data() + at * wide), from + at);
  }
  compare(slot_answer(slot), again_.data(), count, from, "asked after level " + std::to_string(other));
}

void Desk::ask_slot_many_times_over(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes, bytes = asked().signature.number_bytes;
  Arguments a = piece(slot, 0, count, nullptr);
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array].reserve(odd_batch * bytes);
    for (std::size_t at = 0; at < odd_batch; at += count)
      inputs[array].insert(inputs[array].end(), a.arrays[array],
                           a.arrays[array] + std::min(count, odd_batch - at) * bytes);
    a.arrays[array] = inputs[array].data();
  }
  again_.assign(odd_batch * wide, std::byte{blank_again});
  a.count = odd_batch;
  a.out = again_.data();
  guarded(a, from);
  const std::string how = "asked in a batch of " + std::to_string(odd_batch);
  for (std::size_t at = 0; at < odd_batch; at += count)
    compare(slot_answer(slot), again_.data() + at * wide, std::min(count, odd_batch - at), from, how);

  // From threads; what the other one asks begins with the batch's second half.
  const std::size_t half = count / 2;
  std::vector<std::byte> turned_inputs[most_arrays], turned_answers = again_;
  const auto turn = [=](std::vector<std::byte>& numbers, std::size_t width) {
    std::rotate(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(half * width), numbers.end());
  };
  Arguments other = a;
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    turned_inputs[array] = inputs[array];
    turn(turned_inputs[array], bytes);
    other.arrays[array] = turned_inputs[array].data();
  }
  turn(turned_answers, wide);
  const std::vector<std::byte> answers = again_;
  const auto sees = [&](const std::vector<std::byte>& right) {
    return [&, this](const std::byte* theirs, std::uint64_t) {
      compare(right.data(), theirs, odd_batch, from, how + " from two threads at once");
    };
  };
  ask_from_threads({a, odd_batch * wide, sees(answers)}, {other, odd_batch * wide, sees(turned_answers)}, {},
                   from);
}

void Desk::ask_slot_in_another_order(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes, bytes = asked().signature.number_bytes;
  // About 0.618 of the batch on each time, so that neighbours part.
  std::size_t stride = count * 618 / 1000 + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  const auto rearranged = [=](const std::byte* elements) {
    std::vector<std::byte> copy(count * bytes);
    for (std::size_t k = 0; k < count; ++k)
      std::memcpy(copy.data() + k * bytes, elements + k * stride % count * bytes, bytes);
    return copy;
  };
  Arguments a = piece(slot, 0, count, nullptr);
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array] = rearranged(a.arrays[array]);
    a.arrays[array] = inputs[array].data();
  }
  again_.assign(count * wide, std::byte{blank_again});
  a.out = again_.data();
  guarded(a, from);
  std::vector<std::byte> answers(count * wide);  // back in the slot's order
  for (std::size_t k = 0; k < count; ++k)
    std::memcpy(answers.data() + k * stride % count * wide, again_.data() + k * wide, wide);
  compare(slot_answer(slot), answers.data(), count, from, "asked in another order");
}

void Desk::ask_slot_at_other_places(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes, bytes = asked().signature.number_bytes,
                    value = asked().signature.value_bytes;
  // First all at whole lines; then each array so many elements further that no two lie alike.
  for (std::size_t turn = 0; turn < 4; ++turn) {
    const auto placed = [](std::vector<std::byte>& room, std::size_t size, std::size_t offset) {
      room.assign(size + 2 * line, std::byte{blank_again});
      void* at = room.data();
      std::size_t space = room.size();
      return static_cast<std::byte*>(std::align(line, size, at, space)) + offset % line;
    };
    Arguments a = piece(slot, 0, count, nullptr);
    std::vector<std::byte> inputs[most_arrays];
    for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
      std::byte* const copy = placed(inputs[array], count * bytes, turn * (array + 1) * bytes);
      std::memcpy(copy, a.arrays[array], count * bytes);
      a.arrays[array] = copy;
    }
    a.out = placed(again_, count * wide, turn * (most_arrays + 1) * value);
    guarded(a, from);
    compare(slot_answer(slot), a.out, count, from, "asked with its arrays at other addresses");
  }
}

Desk::FromThreads Desk::slot_from_threads_first(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot);
  mailbox_.begun.store(slot * batch_size, std::memory_order_relaxed);
  const Asked batch{piece(slot, 0, count, nullptr), count * asked().answer_bytes, {}};
  return answers_from_threads(batch, batch, {1, 1});
}

void Desk::ask_slot_from_threads(std::size_t slot) {
  constexpr Rounds rounds;
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes, bytes = asked().signature.number_bytes;
  const auto turned = [half = count / 2](const std::byte* numbers, std::size_t all, std::size_t width) {
    std::vector<std::byte> copy(numbers, numbers + all * width);
    std::rotate(copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(half * width), copy.end());
    return copy;
  };
  const auto sees = [&](const std::byte* right) {
    return [=, this](const std::byte* theirs, std::uint64_t) {
      compare(right, theirs, count, from, "asked from two threads at once");
    };
  };
  const Asked here{piece(slot, 0, count, nullptr), count * wide, sees(slot_answer(slot))};
  Arguments a = here.arguments;
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array] = turned(a.arrays[array], count, bytes);
    a.arrays[array] = inputs[array].data();
  }
  const std::vector<std::byte> answers = turned(slot_answer(slot), count, wide);
  ask_from_threads(here, here, rounds, from);
  ask_from_threads(here, {a, count * wide, sees(answers.data())}, rounds, from);
}

}  // namespace mmverify::dock
