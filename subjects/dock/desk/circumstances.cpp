// Asks again as other callers do: with memory that is theirs for the call only, at low addresses, and after work
// that left its traces in the thread.
#include <algorithm>
#include <cstring>
#include <memory>

#include "subjects/dock/desk/provocations.hpp"

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

/// Repeats the question with copies of its inputs, and its output, in memory that is taken back afterwards.
void ask_in(const Circumstance& circumstance, const Question& question, const Caller& caller,
            WorkerMemory& kept) {
  const Signature& signature = caller.entry().signature;
  Arguments a = question.arguments;
  a.manner = circumstance.manner;
  const std::size_t array_bytes = a.count * signature.number_bytes;
  std::vector<std::size_t> sizes(signature.arrays, array_bytes);
  sizes.insert(sizes.end(), {question.bytes, a.blob_bytes});
  // The room of a case fills whole pages, so that it is aligned.
  const std::size_t page = caller.layout().page();
  if (signature.of_blob) sizes.push_back((room_for_case(a.blob_bytes) + page - 1) / page * page);
  auto lent = std::make_unique<Lent>(sizes, circumstance.where);
  std::size_t piece = 0;
  for (; piece < signature.arrays; ++piece) {
    std::memcpy(lent->piece(piece), a.arrays[piece], array_bytes);
    a.arrays[piece] = lent->piece(piece);
  }
  a.out = lent->piece(piece++);
  std::memset(a.out, blank_again, question.bytes);
  std::byte* const blob = lent->piece(piece++);
  if (a.blob_bytes != 0) std::memcpy(blob, a.blob, a.blob_bytes);
  a.blob = reinterpret_cast<const std::uint8_t*>(blob);
  if (signature.of_blob) a.case_room = lent->piece(piece);
  const std::uint64_t size = caller.guarded(a, question.element);
  const std::vector<std::byte> answer(a.out, a.out + question.bytes);
  // The subject has nothing to look for in the last call's memory during this one, or in this one's after it.
  kept.lent.reset();
  lent->take_back();
  kept.lent = std::move(lent);
  caller.compare(question, size, answer.data(), circumstance.how);
}

}  // namespace

void in_circumstances(const Batch& batch) {
  for (const Circumstance& one : circumstances) ask_in(one, batch.whole(), batch.caller, batch.kept);
}

void in_circumstances(const Blob& blob) {
  const std::uint32_t before = blob.before();
  std::size_t turn = before / 64 + before;
  for (const Circumstance& one : circumstances)
    if (before < first_in_all || turn++ % std::size(circumstances) == 0)
      ask_in(one, blob.question(), blob.caller, blob.kept);
}

}  // namespace mmverify::dock
