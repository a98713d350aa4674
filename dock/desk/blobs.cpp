// Commands on a map, a code or a case: each call is made at least twice, its answer in other bytes and other
// room.
#include <algorithm>
#include <cstring>

#include "dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

constexpr std::uint32_t first_thorough = 64, later_one_in = 64;
/// Maps and codes above this take so long that the further calls would count as a hang: level 12, and 4-state at 11.
constexpr std::uint64_t most_thorough = std::uint64_t{3} << 18;

std::string text(std::uint64_t number) { return std::to_string(number); }

}  // namespace

bool Desk::thorough() {
  if (std::max(mailbox_.blob_bytes, mailbox_.room) > most_thorough) return false;
  const std::uint32_t before =
      questions_[static_cast<std::size_t>(mailbox_.call)][mailbox_.level % 32][mailbox_.format % 3]++;
  return before < first_thorough || before % later_one_in == 0;
}

void Desk::run_on_blob() {
  if (asked().signature.sizes_answer)
    encode(thorough());
  else
    answer(thorough());
}

std::byte* Desk::blob_answer(std::uint64_t size) const { return base_ + layout_.blob_answer_at(size); }

Arguments Desk::whole(std::byte* out, std::uint64_t room) const {
  Arguments a{};
  a.level = mailbox_.level;
  a.format = mailbox_.format;
  a.blob = reinterpret_cast<const std::uint8_t*>(base_ + layout_.blob_at(mailbox_.blob_bytes));
  a.blob_bytes = static_cast<std::size_t>(mailbox_.blob_bytes);
  a.count = static_cast<std::size_t>(mailbox_.count);
  for (std::size_t array = 0; array < asked().signature.arrays; ++array)
    a.arrays[array] = base_ + layout_.input_at(array, 0, a.count, asked().signature.number_bytes);
  a.out = out;
  a.room = static_cast<std::size_t>(room);
  return a;
}

std::uint64_t Desk::call_at_guard(std::uint64_t room, unsigned char filling) {
  std::byte* out = blob_answer(room);
  set_canary(out);
  std::memset(out, filling, static_cast<std::size_t>(room));
  const std::uint64_t size = guarded(whole(out, room), 0);
  check_canary(out, 0);
  return size;
}

void Desk::encode(bool thorough) {
  std::uint64_t room = mailbox_.room, size = call_at_guard(room, blank);
  if (size > blob_capacity)
    stop(Outcome::too_large, 0, "asked for " + text(size) + " bytes, more than " + text(blob_capacity));
  const auto same_size = [&](std::uint64_t again, std::uint64_t given) {
    if (again != size)
      stop(Outcome::non_deterministic, 0,
           "a code of " + text(size) + " bytes, then, with room for " + text(given) + ", of " + text(again));
  };
  if (size > room) {
    room = size;
    same_size(call_at_guard(room, blank), room);
  }
  again_.assign(blob_answer(room), blob_answer(room) + size);
  if (thorough && size != 0)
    for (const std::uint64_t too_little : {std::uint64_t{0}, size - 1})
      same_size(call_at_guard(too_little, blank), too_little);
  // What is read lies in exactly the room that it needs.
  same_size(call_at_guard(size, blank_again), size);
  compare(again_.data(), blob_answer(size), static_cast<std::size_t>(size), 0, "asked again");
  if (thorough) ask_blob_from_threads(size);
  mailbox_.taken = size != 0 ? 1 : 0;
  mailbox_.answer_bytes = size;
}

void Desk::answer(bool thorough) {
  const std::uint64_t room = mailbox_.room, first = call_at_guard(room, blank);
  again_.assign(blob_answer(room), blob_answer(room) + room);
  const std::uint64_t second = call_at_guard(room, blank_again);
  if (first != second)
    stop(Outcome::non_deterministic, 0, first != 0 ? "taken, then refused" : "refused, then taken");
  if (first != 0) compare(again_.data(), blob_answer(room), static_cast<std::size_t>(room), 0, "asked again");
  if (thorough) ask_blob_from_threads(first);
  mailbox_.taken = first != 0 ? 1 : 0;
  mailbox_.answer_bytes = first;
}

void Desk::ask_blob_from_threads(std::uint64_t size) {
  constexpr std::size_t rounds = 2;
  const std::uint64_t room = asked().signature.sizes_answer ? size : mailbox_.room;
  ask_from_threads(
      whole(nullptr, room), static_cast<std::size_t>(room), rounds, 0,
      [&](const std::byte* theirs, std::uint64_t their_size) {
        if (their_size != size)
          stop(Outcome::non_deterministic, 0,
               "asked from two threads at once: " + text(size) + " bytes, then " + text(their_size));
        compare(blob_answer(size), theirs, static_cast<std::size_t>(size), 0,
                "asked from two threads at once");
      });
}

}  // namespace mmverify::dock
