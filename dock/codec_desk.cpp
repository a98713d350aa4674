#include "dock/codec_desk.hpp"

#include <algorithm>
#include <cstring>
#include <thread>

namespace mmverify::dock {
namespace {

constexpr std::uint32_t first_thorough = 64, later_one_in = 64;
/// Maps and codes above this take so long that the further calls would count as a hang: level 12, and 4-state at 11.
constexpr std::uint64_t most_thorough = std::uint64_t{3} << 18;

std::string text(std::uint64_t number) { return std::to_string(number); }

bool all(const std::byte* bytes, std::uint64_t size, unsigned char value) {
  return std::all_of(bytes, bytes + size, [value](std::byte b) { return b == std::byte{value}; });
}

}  // namespace

bool CodecDesk::thorough() {
  const Mailbox& m = desk_.mailbox;
  if (std::max(m.blob_bytes, m.room) > most_thorough) return false;
  const std::uint32_t before = asked_[static_cast<std::size_t>(m.call)][m.level % 32][m.format % 3]++;
  return before < first_thorough || before % later_one_in == 0;
}

void CodecDesk::run() {
  if (encodes())
    encode(thorough());
  else
    answer(thorough());
}

std::uint64_t CodecDesk::call(std::byte* out, std::uint64_t room) const {
  const Mailbox& m = desk_.mailbox;
  const mmverify_subject_t& s = desk_.subject;
  const auto* blob = reinterpret_cast<const std::uint8_t*>(desk_.base + desk_.layout.blob_at(m.blob_bytes));
  auto* to = reinterpret_cast<std::uint8_t*>(out);
  const auto array = [&](std::size_t number) {
    return desk_.base + desk_.layout.input_at(number, 0, m.count, input_size(m.call));
  };
  const auto floats = [&](std::size_t number) { return reinterpret_cast<const float*>(array(number)); };
  const auto numbers = [&](std::size_t number) {
    return reinterpret_cast<const std::uint32_t*>(array(number));
  };
  switch (m.call) {
    case Call::tree_encode:
      return s.tree_encode(m.level, m.format, blob, to, room);
    case Call::tree_decode:
      return s.tree_decode(m.level, m.format, blob, m.blob_bytes, to) != 0 ? room : 0;
    case Call::tree_lookup:
      s.tree_lookup(m.level, m.format, blob, m.blob_bytes, numbers(0), to, m.count);
      return room;
    case Call::tree_lookup_f32:
      s.tree_lookup_f32(m.level, m.format, blob, m.blob_bytes, floats(0), floats(1), to, m.count);
      return room;
    case Call::micromap_pack:
      s.micromap_pack(m.format, blob, m.blob_bytes, to);
      return room;
    case Call::micromap_unpack:
      s.micromap_unpack(m.format, blob, room, to);
      return room;
    case Call::micromap_force2:
      s.micromap_force2(m.level, blob, to);
      return room;
    case Call::micromap_widen:
      s.micromap_widen(m.level, blob, to);
      return room;
    case Call::micromap_up:
      s.micromap_up(m.level, m.format, blob, to);
      return room;
    case Call::micromap_down:
      s.micromap_down(m.level, m.format, blob, to);
      return room;
    case Call::micromap_through:
      s.micromap_through(m.level, m.format, blob, to);
      return room;
    case Call::micromap_substitute:
      s.micromap_substitute(m.level, blob, to);
      return room;
    case Call::vq2_decode:
      s.vq2_decode(blob, to);
      return room;
    case Call::vq2_region:
      s.vq2_region(blob, numbers(0), numbers(1), to, m.count);
      return room;
    case Call::vq2_encode:
      s.vq2_encode(blob, to);
      return room;
    case Call::vq4_decode:
      s.vq4_decode(blob, to);
      return room;
    case Call::vq4_region:
      s.vq4_region(blob, numbers(0), numbers(1), to, m.count);
      return room;
    case Call::vq4_encode:
      s.vq4_encode(blob, to);
      return room;
    case Call::bake: {
      mmverify_bake_case_t what;
      std::memcpy(&what, blob, sizeof what);
      what.texels = blob + sizeof what;
      return s.bake(&what, to) != 0 ? room : 0;
    }
    default:
      return 0;
  }
}

std::uint64_t CodecDesk::call_at_guard(std::uint64_t room, unsigned char filling) {
  std::byte* out = place(room);
  std::memset(out - canary_size, canary, canary_size);
  std::memset(out, filling, room);
  std::uint64_t size = 0;
  desk_.guarded([&] { size = call(out, room); }, 0);
  if (!all(out - canary_size, canary_size, canary)) desk_.stop(Outcome::wrote_before, 0, "");
  return size;
}

void CodecDesk::encode(bool thorough) {
  Mailbox& m = desk_.mailbox;
  std::uint64_t room = m.room, size = call_at_guard(room, blank);
  if (size > blob_capacity)
    desk_.stop(Outcome::too_large, 0, "asked for " + text(size) + " bytes, more than " + text(blob_capacity));
  const auto same_size = [&](std::uint64_t again, std::uint64_t given) {
    if (again != size)
      desk_.stop(
          Outcome::non_deterministic, 0,
          "a code of " + text(size) + " bytes, then, with room for " + text(given) + ", of " + text(again));
  };
  if (size > room) {
    room = size;
    same_size(call_at_guard(room, blank), room);
  }
  before_.assign(place(room), place(room) + size);
  if (thorough && size != 0)
    for (const std::uint64_t too_little : {std::uint64_t{0}, size - 1})
      same_size(call_at_guard(too_little, blank), too_little);
  // What is read lies in exactly the room that it needs.
  same_size(call_at_guard(size, blank_again), size);
  compare(before_.data(), place(size), size, blank_again, "asked again");
  if (thorough) ask_from_threads(size);
  m.taken = size != 0 ? 1 : 0;
  m.answer_bytes = size;
}

void CodecDesk::answer(bool thorough) {
  Mailbox& m = desk_.mailbox;
  const std::uint64_t room = m.room, first = call_at_guard(room, blank);
  before_.assign(place(room), place(room) + room);
  const std::uint64_t second = call_at_guard(room, blank_again);
  if (first != second)
    desk_.stop(Outcome::non_deterministic, 0, first != 0 ? "taken, then refused" : "refused, then taken");
  if (first != 0) compare(before_.data(), place(room), room, blank_again, "asked again");
  if (thorough) ask_from_threads(first);
  m.taken = first != 0 ? 1 : 0;
  m.answer_bytes = first;
}

void CodecDesk::compare(const std::byte* before, const std::byte* after, std::uint64_t size,
                        unsigned char filling, const char* how) {
  const auto [one, other] = std::mismatch(before, before + size, after);
  if (one == before + size) return;
  const auto at = static_cast<std::uint64_t>(one - before);
  if (*other == std::byte{filling}) desk_.stop(Outcome::unwritten, at, "");
  desk_.stop(Outcome::non_deterministic, at,
             std::string(how) + ": byte " + text(at) + " was " + text(std::to_integer<unsigned>(*one)) +
                 ", then " + text(std::to_integer<unsigned>(*other)));
}

void CodecDesk::ask_from_threads(std::uint64_t size) {
  if ((desk_.subject.flags & MMVERIFY_SINGLE_THREADED) != 0) return;
  constexpr std::size_t rounds = 2;
  const std::uint64_t room = encodes() ? size : desk_.mailbox.room;
  struct Theirs {
    std::vector<std::byte> bytes[rounds];
    std::uint64_t size[rounds] = {};
    bool threw = false;
  } theirs[2];
  const auto ask = [&](Theirs& mine) {
    try {
      for (std::size_t round = 0; round < rounds; ++round) {
        mine.bytes[round].assign(room, std::byte{blank_again});
        mine.size[round] = call(mine.bytes[round].data(), room);
      }
    } catch (...) {
      mine.threw = true;
    }
  };
  std::thread other([&] {
    desk_.leave_processor();
    ask(theirs[1]);
  });
  ask(theirs[0]);
  other.join();
  for (const Theirs& one : theirs) {
    if (one.threw) desk_.stop(Outcome::threw, 0, "when called from two threads at once");
    for (std::size_t round = 0; round < rounds; ++round) {
      if (one.size[round] != size)
        desk_.stop(Outcome::non_deterministic, 0,
                   "asked from two threads at once: " + text(size) + " bytes, then " + text(one.size[round]));
      compare(place(size), one.bytes[round].data(), size, blank_again, "asked from two threads at once");
    }
  }
}

}  // namespace mmverify::dock
