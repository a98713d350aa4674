// Commands on numbers in slots: the answers of a batch may not depend on each other.
#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>
#include <unordered_map>

#include "subjects/dock/desk/desk.hpp"

namespace mmverify::dock {

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
  // The first command of a level is repeated in every way, all of it; of later ones, one batch in one way
  // each.
  for (std::size_t slot = 0; first_at_this_level() && slot < batches; ++slot) {
    for (const std::size_t size : {batch_size, std::size_t{7}, std::size_t{1}}) ask_slot_again(slot, size);
    ask_slot_in_another_order(slot);
    ask_slot_from_threads(slot);
    if (slot != 0) continue;
    ask_slot_in_runs(slot);
    ask_slot_in_each_size(slot);
    ask_slot_in_orders_of_callers(slot);
    ask_slot_after_another_level(slot);
    ask_slot_after_another_format(slot);
    ask_slot_after_neighbours(slot);
    ask_slot_after_one_of_the_level_before(slot);
    ask_slot_many_times_over(slot);
    ask_slot_at_other_places(slot);
    ask_slot_over_answers(slot);
    ask_slot_beside_another_kind(slot);
    ask_slot_in_circumstances(slot);
    ask_slot_with_one_array(slot);
    ask_slot_beside_a_writer(slot);
    ask_slot_from_many_threads(slot);
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

void Desk::ask_piece(std::size_t slot, std::size_t at, std::size_t count, Fenced& out) {
  const std::size_t wide = asked().answer_bytes, element = slot * batch_size + at;
  guarded(piece(slot, at, count, out.data() + at * wide), element);
  if (!out.is_blank_from((at + count) * wide)) stop(Outcome::wrote_behind, element, "");
}

std::byte* Desk::slot_answer(std::size_t slot) const {
  return base_ + layout_.answer_at(slot, in_slot(mailbox_.count, slot), asked().answer_bytes);
}

void Desk::call_slot(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes;
  std::byte* out = slot_answer(slot);
  set_canary(out);
  // Filling costs time; the first command of a level is enough to notice an output that is left unwritten.
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
  Fenced again(count * wide, blank_again);
  for (std::size_t at = 0; at < count; at += size) ask_piece(slot, at, std::min(size, count - at), again);
  check_fence(again, from);
  compare(slot_answer(slot), again.data(), count, from,
          size == batch_size ? "asked again" : "asked in batches of " + std::to_string(size));
}

void Desk::ask_slot_after_another_level(std::size_t slot, std::size_t most) {
  if (mailbox_.this_level_alone != 0) return;
  const std::uint32_t level = mailbox_.level;
  // Three vertices of a face at one level need not be a face at another.
  if (mailbox_.call == Call::attribute_face_of) return;
  if (level < subject_.max_level) ask_slot_after(slot, level + 1, 0, most);
  if (asked().signature.of_points) {
    if (level == subject_.max_level && level != 0) ask_slot_after(slot, level - 1, 0, most);
    return;
  }
  // An index is valid at a lower level only if shortened: to the parent's index, or to its first digit.
  if (asked().signature.arrays != 1) return;
  if (level > 0) ask_slot_after(slot, level - 1, 2, most);
  if (level > 2) ask_slot_after(slot, 1, 2 * (level - 1), most);
}

void Desk::ask_slot_after_one_of_the_level_before(std::size_t slot) {
  if (asked().signature.arrays < 2 || asked().signature.of_points || mailbox_.this_level_alone != 0) return;
  constexpr std::size_t most = 512;
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes, bytes = asked().signature.number_bytes;
  std::optional<Batch>& kept =
      level_before_[static_cast<std::size_t>(mailbox_.call)][mailbox_.format % formats];
  const auto word = [](const std::byte* at) {
    std::uint32_t number = 0;
    std::memcpy(&number, at, sizeof number);
    return number;
  };
  std::unordered_map<std::uint32_t, std::size_t> places;
  for (std::size_t k = 0; kept && kept->level != mailbox_.level && k * bytes < kept->arrays[0].size(); ++k)
    places.emplace(word(kept->arrays[0].data() + k * bytes), k);
  Fenced there(wide, blank), here(wide, blank_again);
  std::size_t matches = 0;
  for (std::size_t at = 0; at < count && matches < most && !places.empty(); ++at) {
    Arguments before = piece(slot, at, 1, nullptr);
    const auto same = places.find(word(before.arrays[0]));
    if (same == places.end()) continue;
    ++matches;
    before.level = kept->level;
    for (std::size_t array = 0; array < asked().signature.arrays; ++array)
      before.arrays[array] = kept->arrays[array].data() + same->second * bytes;
    mailbox_.another_level.store(1, std::memory_order_relaxed);
    guarded(before, there, from + at);
    mailbox_.another_level.store(0, std::memory_order_relaxed);
    guarded(piece(slot, at, 1, nullptr), here, from + at);
    compare(slot_answer(slot) + at * wide, here.data(), 1, from + at,
            "asked after one of level " + std::to_string(kept->level) + " with the same first number");
  }
  kept = Batch{mailbox_.level, {}};
  const Arguments whole = piece(slot, 0, count, nullptr);
  for (std::size_t array = 0; array < asked().signature.arrays; ++array)
    kept->arrays[array].assign(whole.arrays[array], whole.arrays[array] + count * bytes);
}

void Desk::ask_slot_after(std::size_t slot, std::uint32_t other, unsigned less_bits, std::size_t most) {
  const std::size_t count = std::min(in_slot(mailbox_.count, slot), most), from = slot * batch_size,
                    wide = asked().answer_bytes;
  Fenced there(wide, blank), again(count * wide, blank_again);
  for (std::size_t at = 0; at < count; ++at) {
    Arguments before = piece(slot, at, 1, nullptr);
    before.level = other;
    std::uint32_t index = 0;
    if (less_bits != 0) {
      std::memcpy(&index, before.arrays[0], sizeof index);
      index >>= less_bits;
      before.arrays[0] = reinterpret_cast<const std::byte*>(&index);
    }
    mailbox_.another_level.store(1, std::memory_order_relaxed);
    guarded(before, there, from + at);
    mailbox_.another_level.store(0, std::memory_order_relaxed);
    ask_piece(slot, at, 1, again);
  }
  check_fence(again, from);
  compare(slot_answer(slot), again.data(), count, from, "asked after level " + std::to_string(other));
}

void Desk::ask_slot_many_times_over(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes, bytes = asked().signature.number_bytes;
  Arguments a = piece(slot, 0, count, nullptr);
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array] = gathered(a.arrays[array], bytes, odd_batch,
                             [=](std::size_t k) { return element_over_and_over(k, count); });
    a.arrays[array] = inputs[array].data();
  }
  Fenced again(odd_batch * wide, blank_again);
  a.count = odd_batch;
  guarded(a, again, from);
  const std::string how = "asked in a batch of " + std::to_string(odd_batch);
  for (std::size_t k = 0; k < odd_batch; ++k) {
    const std::size_t of = element_over_and_over(k, count);
    compare(slot_answer(slot) + of * wide, again.data() + k * wide, 1, from + of, how);
  }

  ask_turned_from_threads(a, again.data(), odd_batch, {}, from, how + " from two threads at once");
}

void Desk::ask_slot_in_another_order(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot);
  // A stride of about 0.618 of the batch separates neighbours.
  std::size_t stride = count * 618 / 1000 + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  std::vector<std::size_t> order(count);
  for (std::size_t k = 0; k < count; ++k) order[k] = k * stride % count;
  ask_slot_rearranged(slot, order, "asked in another order");
}

void Desk::ask_slot_in_runs(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot);
  std::vector<std::size_t> order(count);
  for (std::size_t k = 0; k < count; ++k) {
    constexpr std::size_t lengths[] = {4, 8, 16, 64};
    const std::size_t length = lengths[4 * k / count], run = k / length;
    const bool odd = k % length == 1 + run % (length - 2);
    order[k] = (run * (length + 1) + (odd ? count / 2 + run : 0)) % count;
  }
  ask_slot_rearranged(slot, order, "asked in runs of one element with another one inside");
}

void Desk::ask_slot_rearranged(std::size_t slot, const std::vector<std::size_t>& order,
                               const std::string& how) {
  const std::size_t count = order.size(), from = slot * batch_size, wide = asked().answer_bytes,
                    bytes = asked().signature.number_bytes;
  Arguments a = piece(slot, 0, count, nullptr);
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array] = gathered(a.arrays[array], bytes, count, [&](std::size_t k) { return order[k]; });
    a.arrays[array] = inputs[array].data();
  }
  Fenced again(count * wide, blank_again);
  guarded(a, again, from);
  for (std::size_t k = 0; k < count; ++k)
    compare(slot_answer(slot) + order[k] * wide, again.data() + k * wide, 1, from + order[k], how);
  // Alternating distant neighbours change shared memory with every element.
  if (slot == 0)
    ask_turned_from_threads(a, again.data(), count, often, from, how + ", from two threads at once");
}

void Desk::ask_slot_at_other_places(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    wide = asked().answer_bytes, bytes = asked().signature.number_bytes,
                    value = asked().signature.value_bytes;
  // First all arrays begin at a line; then each is shifted by another number of elements.
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
    Fenced again(count * wide, blank_again, turn * (most_arrays + 1) * value % line);
    guarded(a, again, from);
    compare(slot_answer(slot), again.data(), count, from, "asked with its arrays at other addresses");
  }
}

FromThreads Desk::slot_from_threads_first(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot);
  mailbox_.begun.store(slot * batch_size, std::memory_order_relaxed);
  const Asked batch{piece(slot, 0, count, nullptr), count * asked().answer_bytes, {}};
  return answers_from_threads(batch, batch, {1, 1}, slot * batch_size);
}

void Desk::ask_slot_from_threads(std::size_t slot) {
  const Rounds rounds = slot == 0 ? often : Rounds{};
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size,
                    bytes = count * asked().answer_bytes;
  const Asked here{piece(slot, 0, count, nullptr), bytes, [&](const std::byte* theirs, std::uint64_t) {
                     compare(slot_answer(slot), theirs, count, from, asked_from_threads);
                   }};
  ask_from_threads(here, here, rounds, from);
  ask_turned_from_threads(here.arguments, slot_answer(slot), count, rounds, from, asked_from_threads);
}

void Desk::ask_turned_from_threads(const Arguments& here, const std::byte* answers, std::size_t count,
                                   const Rounds& rounds, std::uint64_t from, const std::string& how) {
  const std::size_t bytes = asked().signature.number_bytes, wide = asked().answer_bytes;
  const auto turned = [=](const std::byte* numbers, std::size_t width) {
    std::vector<std::byte> copy(numbers, numbers + count * width);
    std::rotate(copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(count / 2 * width), copy.end());
    return copy;
  };
  Arguments there = here;
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array] = turned(here.arrays[array], bytes);
    there.arrays[array] = inputs[array].data();
  }
  const std::vector<std::byte> turned_answers = turned(answers, wide);
  const auto sees = [&](const std::byte* right) {
    return [&, right](const std::byte* theirs, std::uint64_t) { compare(right, theirs, count, from, how); };
  };
  ask_from_threads({here, count * wide, sees(answers)}, {there, count * wide, sees(turned_answers.data())},
                   rounds, from);
}

}  // namespace mmverify::dock
