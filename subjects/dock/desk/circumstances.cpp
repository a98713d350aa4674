// Asks again as other callers do: with memory that is theirs for the call only, at low addresses, and after work
// that left its traces in the thread.
#include <algorithm>
#include <cstring>
#include <string>

#include "subjects/dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

struct Circumstance {
  Manner manner;
  Lent::Where where;
  const char* how;
};
constexpr Circumstance circumstances[] = {
    {Manner::plain, Lent::Where::below_2_gib, "asked with its memory below 2 GiB"},
    {Manner::plain, Lent::Where::below_4_gib, "asked with its memory below 4 GiB"},
    {Manner::upper_halves, Lent::Where::anywhere, "asked with garbage in the upper halves of registers"},
    {Manner::errno_range, Lent::Where::anywhere, "asked while errno is ERANGE"},
    {Manner::errno_invalid, Lent::Where::anywhere, "asked while errno is EINVAL"},
    {Manner::exceptions, Lent::Where::anywhere, "asked while all floating-point exceptions are flagged"},
    {Manner::utf_8, Lent::Where::anywhere, "asked in the locale C.UTF-8"},
    {Manner::deep_stack, Lent::Where::anywhere, "asked with garbage in 1 MiB of the stack"},
    {Manner::shallow_stack, Lent::Where::anywhere, "asked with garbage in 4 KiB of the stack"}};

/// The first questions of a kind are asked in all circumstances; later ones in one of them in turn.
constexpr std::uint32_t first_in_all = 4;

}  // namespace

std::uint64_t Desk::guarded_in_lent(const Arguments& question, std::size_t bytes, Lent::Where where,
                                    std::uint64_t element) {
  const std::size_t arrays = asked().signature.arrays,
                    array_bytes = question.count * asked().signature.number_bytes;
  const bool is_case = asked().signature.of_blob;
  std::vector<std::size_t> sizes(arrays, array_bytes);
  sizes.insert(sizes.end(), {bytes, question.blob_bytes});
  // The room of a case fills whole pages, so that it is aligned.
  const std::size_t page = layout_.page();
  if (is_case) sizes.push_back((room_for_case(question.blob_bytes) + page - 1) / page * page);
  auto lent = std::make_unique<Lent>(sizes, where);
  Arguments a = question;
  for (std::size_t array = 0; array < arrays; ++array) {
    std::memcpy(lent->piece(array), question.arrays[array], array_bytes);
    a.arrays[array] = lent->piece(array);
  }
  if (question.blob_bytes != 0) std::memcpy(lent->piece(arrays + 1), question.blob, question.blob_bytes);
  a.blob = reinterpret_cast<const std::uint8_t*>(lent->piece(arrays + 1));
  if (is_case) a.case_room = lent->piece(arrays + 2);
  a.out = lent->piece(arrays);
  std::memset(a.out, blank_again, bytes);
  const std::uint64_t size = guarded(a, element);
  lent_answer_.assign(a.out, a.out + bytes);
  // The subject has nothing to look for in the last call's memory during this one, or in this one's after it.
  taken_back_.reset();
  lent->take_back();
  taken_back_ = std::move(lent);
  return size;
}

void Desk::ask_slot_in_circumstances(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size;
  for (const auto& [manner, where, how] : circumstances) {
    Arguments a = piece(slot, 0, count, nullptr);
    a.manner = manner;
    guarded_in_lent(a, count * asked().answer_bytes, where, from);
    compare(slot_answer(slot), lent_answer_.data(), count, from, how);
  }
}

void Desk::ask_blob_in_circumstances(const std::uint8_t* blob, std::uint64_t size) {
  const std::uint32_t before = mailbox_.asked_before;
  std::size_t turn = before / 64 + before;
  for (const auto& [manner, where, how] : circumstances) {
    if (before >= first_in_all && turn++ % std::size(circumstances) != 0) continue;
    Arguments a = whole(nullptr, again_.size());
    a.blob = blob;
    a.manner = manner;
    const std::uint64_t again = guarded_in_lent(a, again_.size(), where, 0);
    if (again != size)
      stop(Outcome::non_deterministic, 0,
           std::string(how) + ": " + std::to_string(size) + " returned, then " + std::to_string(again));
    if (size != 0) compare(again_.data(), lent_answer_.data(), again_.size(), 0, how);
  }
}

void Desk::ask_blob_as_other_callers(const std::uint8_t* blob, std::uint64_t size) {
  ask_blob_in_circumstances(blob, size);
  ask_blob_with_one_array(blob);
  ask_blob_beside_a_writer(blob, size);
  ask_blob_from_many_threads(blob, size);
}

}  // namespace mmverify::dock
