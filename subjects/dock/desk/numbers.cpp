// Commands on numbers in slots: the answers of a batch may not depend on each other.
#include <algorithm>
#include <cstring>

#include "subjects/dock/desk/commands.hpp"
#include "subjects/dock/desk/provocations.hpp"
#include "subjects/dock/desk/two_threads.hpp"

namespace mmverify::dock {
namespace {

/// Elements of a subject of MMVERIFY_LARGE_BATCHES that are worth a call each: it costs as much as a batch.
constexpr std::size_t one_by_one_of_large = 64;

void in_one_piece(const Batch& batch) { in_pieces(batch, batch_size); }
void in_sevens(const Batch& batch) { in_pieces(batch, 7); }
void one_by_one(const Batch& batch) { in_pieces(batch, 1, batch.one_by_one); }

/// The batches of a level's first command that are so asked, and whether large ones are.
enum class Batches { each, first };
enum class Large { no, yes };
struct BatchProvocation {
  void (*ask)(const Batch&);
  Batches batches;
  Large large;
};
constexpr BatchProvocation batch_provocations[] = {
    {in_one_piece, Batches::each, Large::no},          {in_sevens, Batches::each, Large::yes},
    {one_by_one, Batches::each, Large::yes},           {in_another_order, Batches::each, Large::no},
    {from_threads, Batches::each, Large::no},          {in_runs, Batches::first, Large::no},
    {in_each_size, Batches::first, Large::no},         {in_orders_of_callers, Batches::first, Large::no},
    {after_another_level, Batches::first, Large::yes}, {after_another_format, Batches::first, Large::no},
    {after_neighbours, Batches::first, Large::no},     {after_the_level_before, Batches::first, Large::no},
    {many_times_over, Batches::first, Large::yes},     {at_other_places, Batches::first, Large::no},
    {over_answers, Batches::first, Large::no},         {beside_another_kind, Batches::first, Large::no},
    {in_circumstances, Batches::first, Large::yes},    {with_one_array, Batches::first, Large::yes},
    {beside_a_writer, Batches::first, Large::no},      {from_many_threads, Batches::first, Large::yes}};

/// Asks a batch from two threads before any other question of its level: a table that the first call fills
/// must be complete before another call reads it. Exceptions are ignored: later calls throw, too.
TwoAnswers first_from_threads(const Batch& batch) {
  batch.caller.mailbox().begun.store(batch.first(), std::memory_order_relaxed);
  const Question all = batch.whole();
  const ThreadQuestion question{all.arguments, all.bytes, {}};
  return answers_from_threads(batch.caller, question, question, {1, 1}, batch.first());
}

/// Asks a batch; `blanks` its output before.
void answer(const Batch& batch, bool blanks) {
  const std::size_t wide = batch.answer_bytes();
  Mailbox& mailbox = batch.caller.mailbox();
  std::byte* out = batch.answers();
  Caller::set_canary(out);
  if (blanks) std::memset(out, blank, batch.count() * wide);
  const std::size_t step = mailbox.one_by_one != 0 ? 1 : batch.count();
  for (std::size_t at = 0; at < batch.count(); at += step) {
    mailbox.begun.store(batch.first() + at, std::memory_order_relaxed);
    batch.caller.guarded(batch.piece(at, step, out + at * wide), batch.first() + at);
  }
  batch.caller.check_canary(out, batch.first());
}

/// Asks `count` elements from `first` on, of several slots, in one call, over bytes of `filling`.
Fenced answers_at_once(const Caller& caller, std::size_t first, std::size_t count, unsigned char filling) {
  const Signature& signature = caller.entry().signature;
  std::vector<std::byte> inputs[most_arrays];
  Arguments a{};
  a.level = caller.mailbox().level;
  a.format = caller.mailbox().format;
  a.count = count;
  for (std::size_t array = 0; array < signature.arrays; ++array) {
    inputs[array].reserve(count * signature.number_bytes);
    for (std::size_t at = first; at < first + count; at += batch_size) {
      const std::size_t slot = at / batch_size, size = in_slot(caller.mailbox().count, slot);
      const std::byte* numbers =
          caller.base() + caller.layout().input_at(array, slot, size, signature.number_bytes);
      inputs[array].insert(inputs[array].end(), numbers, numbers + size * signature.number_bytes);
    }
    a.arrays[array] = inputs[array].data();
  }
  Fenced out(count * caller.entry().answer_bytes, filling);
  caller.mailbox().begun.store(first, std::memory_order_relaxed);
  caller.guarded(a, out, first);
  return out;
}

/// Asks the whole command in large batches, over bytes of `filling`, and visits the answers of each slot.
template <class Visit>
void in_large_batches(const Caller& caller, WorkerMemory& kept, unsigned char filling, Visit visit) {
  const auto all = static_cast<std::size_t>(caller.mailbox().count);
  for (std::size_t first = 0; first < all; first += large_batch_size) {
    const std::size_t count = std::min(large_batch_size, all - first);
    const Fenced out = answers_at_once(caller, first, count, filling);
    for (std::size_t at = first; at < first + count; at += batch_size)
      visit(Batch(caller, kept, at / batch_size), out.data() + (at - first) * caller.entry().answer_bytes);
  }
}

void answer_in_large_batches(const Caller& caller, WorkerMemory& kept, bool again) {
  in_large_batches(caller, kept, blank, [](const Batch& batch, const std::byte* answers) {
    std::memcpy(batch.answers(), answers, batch.whole().bytes);
  });
  if (again)
    in_large_batches(caller, kept, blank_again, [](const Batch& batch, const std::byte* answers) {
      batch.caller.compare(batch.answers(), answers, batch.count(), batch.first(), "asked again");
    });
}

/// Repeats the first command of a level in every way.
void provoke(const Caller& caller, WorkerMemory& kept, std::size_t batches, bool large) {
  for (std::size_t slot = 0; slot < (large ? 1 : batches); ++slot)
    for (const BatchProvocation& provocation : batch_provocations)
      if ((!large || provocation.large == Large::yes) && (slot == 0 || provocation.batches == Batches::each))
        provocation.ask(Batch(caller, kept, slot, large ? one_by_one_of_large : batch_size));
}

}  // namespace

void in_pieces(const Batch& batch, std::size_t size, std::size_t most) {
  const std::size_t count = std::min(batch.count(), most), wide = batch.answer_bytes();
  batch.caller.mailbox().begun.store(batch.first(), std::memory_order_relaxed);
  Fenced again(count * wide, blank_again);
  for (std::size_t at = 0; at < count; at += size) {
    const std::size_t step = std::min(size, count - at), element = batch.first() + at;
    batch.caller.guarded(batch.piece(at, step, again.data() + at * wide), element);
    if (!again.is_blank_from((at + step) * wide)) batch.caller.stop(Outcome::wrote_behind, element, "");
  }
  batch.caller.check_fence(again, batch.first());
  batch.caller.compare(batch.answers(), again.data(), count, batch.first(),
                       size == batch_size ? "asked again" : "asked in batches of " + std::to_string(size));
}

void run_on_numbers(const Caller& caller, WorkerMemory& kept, std::uint64_t number) {
  const Mailbox& mailbox = caller.mailbox();
  const bool one_by_one = mailbox.one_by_one != 0,
             large = (caller.subject().flags & MMVERIFY_LARGE_BATCHES) != 0 && !one_by_one;
  std::uint64_t& levels = kept.levels[caller.entry_number()][mailbox.format % formats];
  const std::uint64_t level = std::uint64_t{1} << (mailbox.level % 32);
  const bool is_first = (levels & level) == 0;
  TwoAnswers early;
  if (is_first && !one_by_one && !large) early = first_from_threads(Batch(caller, kept, 0));
  const auto batches = static_cast<std::size_t>((mailbox.count + batch_size - 1) / batch_size);
  if (large)
    answer_in_large_batches(caller, kept, is_first);
  else
    // Filling costs time; the first command of a level is enough to notice an output that is left unwritten.
    for (std::size_t slot = 0; slot < batches; ++slot) answer(Batch(caller, kept, slot), is_first);
  if (one_by_one) return;
  const Batch first(caller, kept, 0);
  for (const Answers& one : early)
    if (!one.sizes.empty())
      caller.compare(first.answers(), one.in_round(0), first.count(), 0, first_from_two_threads);
  if (is_first) provoke(caller, kept, batches, large);
  levels |= level;
  // A later command repeats one batch in one way.
  constexpr std::size_t sizes[] = {batch_size, 7, batch_size - 1, 1},
                        sizes_of_large[] = {batch_size, batch_size - 1};
  const std::uint64_t turn = number / slots;
  in_pieces(Batch(caller, kept, number % batches), large ? sizes_of_large[turn % 2] : sizes[turn % 4]);
}

}  // namespace mmverify::dock
