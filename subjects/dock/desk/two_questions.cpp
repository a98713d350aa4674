// Two threads put different questions at once: a subject that keeps an argument where both threads see it answers
// one of them by the other's.
#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

#include "subjects/dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

const std::string asked_beside = std::string(asked_from_threads) + in_another_kind;
/// Elements of a batch, so many that two threads meet in it.
constexpr std::size_t elements_in_threads = 2048;
/// Batches that are kept for an entry point: the last two, as the last one may differ in nothing that matters.
constexpr std::size_t most_batches = 2;
/// Kinds of questions on blobs that are kept for an entry point, and the most bytes of one.
constexpr std::size_t most_kinds = 8, most_bytes = 1u << 16;
/// Two threads repeat their batches for so long.
constexpr std::chrono::microseconds long_enough(1500);

}  // namespace

Desk::Question Desk::batch_over_and_over(std::size_t slot) const {
  const std::size_t count = in_slot(mailbox_.count, slot), bytes = asked().signature.number_bytes;
  const auto of = [count](std::size_t k) { return element_over_and_over(k, count); };
  Question batch;
  batch.arguments = piece(slot, 0, elements_in_threads, nullptr);
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    batch.arrays[array] = gathered(batch.arguments.arrays[array], bytes, elements_in_threads, of);
    batch.arguments.arrays[array] = batch.arrays[array].data();
  }
  batch.answer = gathered(slot_answer(slot), asked().answer_bytes, elements_in_threads, of);
  return batch;
}

void Desk::ask_slot_beside_another_kind(std::size_t slot) {
  const std::size_t from = slot * batch_size;
  const auto asked_by_thread = [&](const Question& q) {
    return Asked{q.arguments, q.answer.size(), [this, &q](const std::byte* theirs, std::uint64_t) {
                   // The element of a longer batch is none of this command's.
                   compare(q.answer.data(), theirs, q.arguments.count, mailbox_.count, asked_beside);
                 }};
  };
  Question now = batch_over_and_over(slot);
  std::deque<Question>& others = other_kinds_[static_cast<std::size_t>(mailbox_.call)];
  if (mailbox_.this_level_alone == 0)
    for (const Question& other : others)
      ask_from_threads(asked_by_thread(now), asked_by_thread(other), {2, 256, long_enough}, from);
  if (others.size() == most_batches) others.pop_front();
  others.push_back(std::move(now));
}

Desk::Question Desk::longer_question(std::uint64_t size) const {
  Question q = this_question(size);
  const std::size_t count = q.arguments.count, bytes = asked().signature.number_bytes;
  const bool is_lookup = asked().signature.arrays != 0 && q.answer.size() == count && size == count;
  if (!is_lookup || count == 0 || count >= elements_in_threads || q.blob.size() > longest_code) return q;
  const auto of = [count](std::size_t k) { return element_over_and_over(k, count); };
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    q.arrays[array] = gathered(q.arrays[array].data(), bytes, elements_in_threads, of);
    q.arguments.arrays[array] = q.arrays[array].data();
  }
  q.answer = gathered(q.answer.data(), 1, elements_in_threads, of);
  q.size = q.arguments.count = q.arguments.room = elements_in_threads;
  return q;
}

const Desk::Question* Desk::question_of_another_kind() const {
  const std::deque<Question>& all = other_kinds_[static_cast<std::size_t>(mailbox_.call)];
  const auto found = std::find_if(all.rbegin(), all.rend(), [this](const Question& q) {
    return q.arguments.level != mailbox_.level || q.arguments.format != mailbox_.format;
  });
  return found == all.rend() ? nullptr : &*found;
}

void Desk::keep_for_other_kinds(std::uint64_t size) {
  if (std::max(mailbox_.blob_bytes, size) > most_bytes) return;
  Question now = longer_question(size);
  std::deque<Question>& all = other_kinds_[static_cast<std::size_t>(mailbox_.call)];
  const auto same = std::find_if(all.begin(), all.end(), [this](const Question& q) {
    return q.arguments.level == mailbox_.level && q.arguments.format == mailbox_.format;
  });
  if (same == all.end()) {
    if (all.size() == most_kinds) all.pop_front();
    all.push_back(std::move(now));
  } else if (std::adjacent_find(now.answer.begin(), now.answer.end(), std::not_equal_to<>()) !=
             now.answer.end()) {
    // An answer of one value is often right at any level.
    *same = std::move(now);
  }
}

}  // namespace mmverify::dock
