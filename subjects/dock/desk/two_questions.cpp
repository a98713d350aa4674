// Two threads put questions at once, the same or different ones: a subject that keeps an argument where both threads
// see it answers one of them by the other's.
#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

#include "subjects/dock/desk/provocations.hpp"
#include "subjects/dock/desk/two_threads.hpp"

namespace mmverify::dock {
namespace {

const std::string beside_another = std::string(from_two_threads) + in_another_kind;
/// Elements of a batch, so many that two threads meet in it.
constexpr std::size_t elements_in_threads = 2048;
/// Batches that are kept for an entry point: the last two, as the last one may differ in nothing that matters.
constexpr std::size_t most_batches = 2;
/// Kinds of questions on blobs that are kept for an entry point, and the most bytes of one.
constexpr std::size_t most_kinds = 8, most_bytes = 1u << 16;
/// Two threads repeat their batches for so long.
constexpr std::chrono::microseconds long_enough(1500);
/// Two threads repeat a blob's question for so long if it is early: a race on memory that two threads share
/// shows only if they meet in it. Laws begin with plain cases, and a plain map leaves nothing in memory that
/// two threads share; so one question in one_in_early of the first most_early counts as early, too.
constexpr Rounds early_rounds{2, 256, std::chrono::milliseconds(2)};
constexpr std::uint32_t first_early = 8, most_early = 1u << 14, one_in_early = 256;
/// The first questions of a kind, of which every other one is asked beside one of another kind.
constexpr std::uint32_t first_beside_others = 64;

bool is_early(std::uint32_t before) {
  return before < first_early || (before < most_early && before % one_in_early == 0);
}

/// The batch's elements over and over.
QuestionCopy longer(const Batch& batch) {
  const Order order = over_and_over(elements_in_threads, batch.count());
  QuestionCopy copy = rearranged(batch.piece(0, 0), batch.signature(), order);
  copy.answer = gathered(batch.answers(), batch.answer_bytes(), order);
  return copy;
}

/// A copy of the question; if it is a lookup in a short code, with its elements over and over.
QuestionCopy longer(const Blob& blob) {
  QuestionCopy q = blob.copy();
  const std::size_t count = q.arguments.count;
  const bool is_lookup = blob.signature().arrays != 0 && q.answer.size() == count && q.size == count;
  if (!is_lookup || count == 0 || count >= elements_in_threads || q.blob.size() > longest_code) return q;
  const Order order = over_and_over(elements_in_threads, count);
  QuestionCopy more = rearranged(q.arguments, blob.signature(), order);
  more.blob = std::move(q.blob);
  more.answer = gathered(q.answer.data(), 1, order);
  more.size = more.arguments.room = elements_in_threads;
  return more;
}

/// The question of a thread, whose answers must be the copy's.
ThreadQuestion of_thread(const Blob& blob, const QuestionCopy& q, const std::string& how) {
  return {q.arguments, q.answer.size(), [&](const std::byte* theirs, std::uint64_t size) {
            if (size != q.size)
              blob.caller.stop(Outcome::non_deterministic, 0,
                               how + ": " + std::to_string(q.size) + " bytes, then " + std::to_string(size));
            if (q.size != 0) blob.caller.compare(q.answer.data(), theirs, q.answer.size(), 0, how);
          }};
}

/// An earlier question to the entry point at another level or in another format; null: there was none.
const QuestionCopy* of_another_kind(const Blob& blob) {
  const Mailbox& mailbox = blob.caller.mailbox();
  const std::deque<QuestionCopy>& all = blob.kept.of_other_kinds[blob.caller.entry_number()];
  const auto found = std::find_if(all.rbegin(), all.rend(), [&](const QuestionCopy& q) {
    return q.arguments.level != mailbox.level || q.arguments.format != mailbox.format;
  });
  return found == all.rend() ? nullptr : &*found;
}

/// Keeps the question for later ones of other kinds, in place of the last one of its own kind unless that tells
/// more.
void keep(const Blob& blob) {
  if (std::max(blob.blob_bytes(), blob.size) > most_bytes) return;
  const Mailbox& mailbox = blob.caller.mailbox();
  QuestionCopy now = longer(blob);
  std::deque<QuestionCopy>& all = blob.kept.of_other_kinds[blob.caller.entry_number()];
  const auto same = std::find_if(all.begin(), all.end(), [&](const QuestionCopy& q) {
    return q.arguments.level == mailbox.level && q.arguments.format == mailbox.format;
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

}  // namespace

void from_threads(const Batch& batch) {
  const Rounds rounds = batch.slot == 0 ? often : Rounds{};
  const Question all = batch.whole();
  const ThreadQuestion here{all.arguments, all.bytes, [&](const std::byte* theirs, std::uint64_t) {
                              batch.caller.compare(all.answer, theirs, batch.count(), all.element,
                                                   from_two_threads);
                            }};
  ask_from_threads(batch.caller, here, here, rounds, all.element);
  ask_turned_from_threads(batch.caller, all, rounds, from_two_threads);
}

void beside_another_kind(const Batch& batch) {
  const auto of_thread = [&](const QuestionCopy& q) {
    return ThreadQuestion{q.arguments, q.answer.size(), [&](const std::byte* theirs, std::uint64_t) {
                            // The element of a longer batch is none of this command's.
                            batch.caller.compare(q.answer.data(), theirs, q.arguments.count,
                                                 batch.caller.mailbox().count, beside_another);
                          }};
  };
  QuestionCopy now = longer(batch);
  std::deque<QuestionCopy>& others = batch.kept.of_other_kinds[batch.caller.entry_number()];
  if (batch.caller.mailbox().this_level_alone == 0)
    for (const QuestionCopy& other : others)
      ask_from_threads(batch.caller, of_thread(now), of_thread(other), {2, 256, long_enough}, batch.first());
  if (others.size() == most_batches) others.pop_front();
  others.push_back(std::move(now));
}

void from_threads(const Blob& blob) {
  const std::uint32_t before = blob.before();
  const Rounds rounds = is_early(before) ? early_rounds : Rounds{};
  const std::string how = from_two_threads;
  QuestionCopy now = blob.copy();
  const ThreadQuestion here = of_thread(blob, now, how);
  ask_from_threads(blob.caller, here, here, rounds, 0);
  std::optional<QuestionCopy>& last = blob.kept.last[blob.caller.entry_number()];
  const bool beside_others = (before < first_beside_others ? before : before / 64 + before / 256) % 2 != 0;
  blob.caller.mark_beyond(true);
  if (const QuestionCopy* other = beside_others ? of_another_kind(blob) : nullptr; other != nullptr) {
    const QuestionCopy more = longer(blob);
    ask_from_threads(blob.caller, of_thread(blob, more, beside_another),
                     of_thread(blob, *other, beside_another), rounds, 0);
  } else if (last) {
    ask_from_threads(blob.caller, here, of_thread(blob, *last, how), rounds, 0);
  }
  blob.caller.mark_beyond(false);
  last.emplace(std::move(now));
  keep(blob);
}

}  // namespace mmverify::dock
