#include "subjects/dock/desk/blob.hpp"

#include <utility>

namespace mmverify::dock {
namespace {

constexpr std::uint32_t first_thorough = 64, later_one_in = 64;

}  // namespace

Blob::Blob(const Caller& caller, WorkerMemory& kept)
    : caller(caller), kept(kept), bytes(original()), elsewhere(copied_elsewhere()) {
  // The order alternates: a question's first call has the address of the previous question's second call to
  // that entry point.
  bool& elsewhere_first = kept.elsewhere_first[caller.entry_number()];
  elsewhere_first = !elsewhere_first;
  if (elsewhere_first) std::swap(bytes, elsewhere);
}

const std::uint8_t* Blob::original() const {
  return reinterpret_cast<const std::uint8_t*>(caller.base() + caller.layout().blob_at(blob_bytes()));
}

bool Blob::is_thorough() const {
  return !is_large() && (before() < first_thorough || before() % later_one_in == 0);
}

bool Blob::is_large() const { return std::max(blob_bytes(), room()) > most_thorough; }

Arguments Blob::arguments(const std::uint8_t* bytes, std::uint64_t room) const {
  Arguments a{};
  a.level = caller.mailbox().level;
  a.format = caller.mailbox().format;
  a.blob = bytes;
  a.blob_bytes = static_cast<std::size_t>(blob_bytes());
  a.count = static_cast<std::size_t>(caller.mailbox().count);
  for (std::size_t array = 0; array < signature().arrays; ++array)
    a.arrays[array] = caller.base() + caller.layout().input_at(array, 0, a.count, signature().number_bytes);
  a.room = static_cast<std::size_t>(room);
  return a;
}

QuestionCopy Blob::copy() const {
  QuestionCopy q;
  q.arguments = arguments(original(), answer.size());
  q.size = size;
  q.answer = answer;
  const auto* blob = reinterpret_cast<const std::byte*>(q.arguments.blob);
  q.blob.assign(blob, blob + q.arguments.blob_bytes);
  q.arguments.blob = reinterpret_cast<const std::uint8_t*>(q.blob.data());
  for (std::size_t array = 0; array < signature().arrays; ++array) {
    const std::byte* numbers = q.arguments.arrays[array];
    q.arrays[array].assign(numbers, numbers + q.arguments.count * signature().number_bytes);
    q.arguments.arrays[array] = q.arrays[array].data();
  }
  return q;
}

const std::uint8_t* Blob::copied_elsewhere() {
  const std::uint8_t* here = original();
  if (caller.entry().topic == Topic::bake) return here;
  // The place depends on the size and the first and last bytes. So a blob is always copied to the same place,
  // and codes that differ only in the middle lie at one address, where a cache may mistake one for another.
  constexpr std::size_t ends = 8;
  const std::size_t end = std::min<std::size_t>(ends, blob_bytes());
  std::uint64_t sum = blob_bytes();
  for (std::size_t k = 0; k < end; ++k) sum = (sum * 31 + here[k]) * 31 + here[blob_bytes() - 1 - k];
  std::vector<std::byte>& room = kept.elsewhere;
  room.resize(static_cast<std::size_t>(blob_bytes()) + 2 * line);
  // The upper bits of a product with the golden ratio: the sums of short maps have few remainders.
  const std::size_t turn = 1 + (sum * 0x9E3779B97F4A7C15u >> 32) % (places - 1);
  auto* there = reinterpret_cast<std::uint8_t*>(room.data() + before_line(room) + place_behind_line(turn, 1));
  std::copy_n(here, blob_bytes(), there);
  return there;
}

std::uint64_t Blob::call_at_guard(std::uint64_t room, unsigned char filling,
                                  const std::uint8_t* bytes) const {
  Arguments a = arguments(bytes, room);
  // A lookup's arrays move, too: each a different number of elements behind a line.
  const std::size_t wide = signature().number_bytes, all = a.count * wide;
  for (std::size_t array = 0; bytes != original() && array < signature().arrays; ++array) {
    std::vector<std::byte>& moved = kept.arrays_elsewhere[array];
    moved.resize(all + 2 * line);
    std::byte* there = moved.data() + before_line(moved) + (array + 1) * wide;
    std::copy_n(a.arrays[array], all, there);
    a.arrays[array] = there;
  }
  return caller.guarded_at_page(a, a.room, filling, 0);
}

void Blob::encode_within(std::uint64_t room, unsigned char filling, const std::uint8_t* bytes) const {
  if (const std::uint64_t again = call_at_guard(room, filling, bytes); again != size)
    caller.stop(Outcome::non_deterministic, 0,
                "a code of " + std::to_string(size) + " bytes, then, with room for " + std::to_string(room) +
                    ", of " + std::to_string(again));
}

void Blob::ask_into(Fenced& out, const std::uint8_t* bytes, const std::string& how) const {
  const std::uint64_t again = caller.guarded(arguments(bytes, answer.size()), out, 0);
  caller.compare(question(), again, out.data(), how);
}

void Blob::ask_after(const Arguments& before, Fenced& out, const std::string& how) const {
  caller.guarded_beyond(before, out, 0);
  const std::uint64_t again = call_at_guard(answer.size(), blank_again, bytes);
  caller.compare(question(), again, caller.at_guard_page(answer.size()), how);
}

}  // namespace mmverify::dock
