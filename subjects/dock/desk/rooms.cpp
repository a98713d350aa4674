// Rooms and places of a blob's answer.
#include <algorithm>
#include <array>
#include <vector>

#include "subjects/dock/desk/provocations.hpp"

namespace mmverify::dock {
namespace {

/// The number of questions of a kind that are asked with each room, and with some of them; later one in
/// one_in_other_rooms has another room.
constexpr std::uint32_t first_in_all_rooms = 8, first_in_other_rooms = 64, one_in_other_rooms = 16;
/// The rooms that callers have who ask for no size first, in bytes; each of the first questions has them.
constexpr std::array<std::uint64_t, 3> much_room{std::uint64_t{1} << 16, std::uint64_t{3} << 19,
                                                 blob_capacity};
constexpr std::uint32_t first_with_much_room = 2;
/// Short maps and codes, and their answers, in bytes; the first of them are asked at every place, since a law
/// may have one map that matters. Longer ones are so asked as often as with all rooms.
constexpr std::uint64_t most_at_all_places = 64, most_answer_at_all_places = 256;
constexpr std::uint32_t first_short_at_all_places = 256, first_at_all_places = 8;

void encode_in_room(const Blob& blob, std::uint64_t room) {
  blob.encode_within(room, blank_again, blob.bytes);
  if (room >= blob.size)
    blob.caller.compare(blob.question(), blob.size, blob.caller.at_guard_page(static_cast<std::size_t>(room)),
                        "asked with room for " + std::to_string(room) + " bytes");
}

}  // namespace

void in_other_rooms(const Blob& blob) {
  const std::uint32_t before = blob.before();
  if (before >= first_in_other_rooms && before % one_in_other_rooms != 0) return;
  if (blob.is_large() || blob.size > Blob::most_thorough) return;
  // A vector's store, or a word's, may need room behind the last byte.
  std::vector<std::uint64_t> rooms{1, blob.size / 2, blob.blob_bytes()};
  for (std::uint64_t more = 1; more <= 8; ++more) rooms.push_back(blob.size + more);
  const std::size_t turn = before < first_in_other_rooms ? before : before / one_in_other_rooms;
  for (std::size_t k = 0; k < rooms.size(); ++k)
    if (before < first_in_all_rooms || turn % rooms.size() == k) encode_in_room(blob, rooms[k]);
  if (before < first_with_much_room)
    for (const std::uint64_t room : much_room) encode_in_room(blob, std::max(room, blob.size));
}

void at_other_places(const Blob& blob) {
  if (blob.caller.entry().topic == Topic::bake || blob.blob_bytes() == 0 || blob.is_large()) return;
  const bool is_short =
      blob.blob_bytes() <= most_at_all_places && blob.answer.size() <= most_answer_at_all_places;
  if (blob.before() >= (is_short ? first_short_at_all_places : first_at_all_places)) return;
  std::vector<std::byte> room(static_cast<std::size_t>(blob.blob_bytes()) + 2 * line);
  for (std::size_t turn = 0; turn < places; ++turn) {
    auto* there =
        reinterpret_cast<std::uint8_t*>(room.data() + before_line(room) + place_behind_line(turn, 1));
    std::copy_n(blob.original(), blob.blob_bytes(), there);
    // The output moves as well, to places in another order.
    Fenced out(blob.answer.size(), blank_again,
               place_behind_line(5 * turn + 1, blob.signature().value_bytes));
    blob.ask_into(out, there, "asked with its bytes at another address");
  }
}

}  // namespace mmverify::dock
