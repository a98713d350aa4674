// Commands on a map, a code or a case. Each call is made at least twice: over other bytes in its output, with
// another room for it, and with its input at another address.
#include <algorithm>
#include <array>
#include <cstring>

#include "subjects/dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

constexpr std::uint32_t first_from_threads = 8, first_thorough = 64, later_one_in = 64;
/// Short maps and codes, and their answers, in bytes; the first of them are asked at every place, since a law may have one map
/// that matters. Longer ones are so asked as often as from threads.
constexpr std::uint64_t most_at_all_places = 64, most_answer_at_all_places = 256;
constexpr std::uint32_t first_short_at_all_places = 256;
/// One later question in one_in_other_rooms is asked with another room for its code.
constexpr std::uint32_t one_in_other_rooms = 16;
/// The rooms that callers have who ask for no size first, in bytes; each of the first questions has them.
constexpr std::array<std::uint64_t, 3> much_room{std::uint64_t{1} << 16, std::uint64_t{3} << 19,
                                                 blob_capacity};
constexpr std::uint32_t first_with_much_room = 2;
/// Later questions that are repeated from threads as long as the first ones: one in one_in_from_threads of
/// the first later_from_threads. Laws begin with plain cases, and a plain map leaves nothing in memory that
/// two threads share.
constexpr std::uint32_t later_from_threads = 1u << 14, one_in_from_threads = 256;
/// The largest map or code, in bytes, that is asked in every way. A larger one (level 12, 4-state at level 11)
/// takes so long that the further calls would count as a hang.
constexpr std::uint64_t most_thorough = std::uint64_t{3} << 18;

std::string text(std::uint64_t number) { return std::to_string(number); }

/// Whether any bytes of the right size are a valid map or block for the question.
bool any_bytes_are_one(Call call) {
  switch (call) {
    case Call::micromap_force2:
    case Call::micromap_widen:
    case Call::micromap_up:
    case Call::micromap_down:
    case Call::micromap_through:
    case Call::micromap_substitute:
    case Call::vq2_decode:
    case Call::vq2_region:
    case Call::vq4_decode:
    case Call::vq4_region:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool Desk::thorough() const {
  if (std::max(mailbox_.blob_bytes, mailbox_.room) > most_thorough) return false;
  const std::uint32_t before = mailbox_.asked_before;
  return before < first_thorough || before % later_one_in == 0;
}

FromThreads Desk::blob_from_threads_first() {
  if (std::max(mailbox_.blob_bytes, mailbox_.room) > most_thorough || mailbox_.asked_before != 0) return {};
  const Asked question{whole(nullptr, mailbox_.room), static_cast<std::size_t>(mailbox_.room), {}};
  return answers_from_threads(question, question, {1, 1}, 0);
}

void Desk::compare_first(const FromThreads& before, std::uint64_t room, std::uint64_t size) {
  const std::string how = "asked from two threads at once, the first time at this level";
  for (const Answers& one : before) {
    if (one.sizes.empty()) continue;
    const bool sizes_differ = asked().signature.sizes_answer && one.sizes[0] != size;
    if (sizes_differ || (one.sizes[0] != 0) != (size != 0))
      stop(Outcome::non_deterministic, 0, how + ": " + text(one.sizes[0]) + " returned, then " + text(size));
    const std::uint64_t bytes = asked().signature.sizes_answer ? size : room;
    if (size != 0 && bytes <= room)
      compare(blob_answer(bytes), one.in_round(0), static_cast<std::size_t>(bytes), 0, how);
  }
}

void Desk::run_on_blob() {
  const std::uint64_t room = mailbox_.room;
  const FromThreads first = blob_from_threads_first();
  if (asked().signature.sizes_answer)
    encode(thorough());
  else
    answer(thorough());
  compare_first(first, room, mailbox_.report.answer_bytes);
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

const std::uint8_t* Desk::blob_elsewhere() {
  const std::uint8_t* here = whole(nullptr, 0).blob;
  if (asked().topic == Topic::bake) return here;
  // The place depends on the size and the first and last bytes. So a blob is always copied to the same place,
  // and codes that differ only in the middle lie at one address, where a cache may mistake one for another.
  constexpr std::size_t ends = 8;
  const std::size_t end = std::min<std::size_t>(ends, mailbox_.blob_bytes);
  std::uint64_t sum = mailbox_.blob_bytes;
  for (std::size_t k = 0; k < end; ++k) sum = (sum * 31 + here[k]) * 31 + here[mailbox_.blob_bytes - 1 - k];
  elsewhere_.resize(static_cast<std::size_t>(mailbox_.blob_bytes) + 2 * line);
  // The upper bits of a product with the golden ratio: the sums of short maps have few remainders.
  const std::size_t turn = 1 + (sum * 0x9E3779B97F4A7C15u >> 32) % (places - 1);
  auto* there = reinterpret_cast<std::uint8_t*>(elsewhere_.data() + before_line(elsewhere_) +
                                                place_behind_line(turn, 1));
  std::copy_n(here, mailbox_.blob_bytes, there);
  return there;
}

Desk::Blobs Desk::blobs() {
  const Blobs both{whole(nullptr, 0).blob, blob_elsewhere()};
  // The order alternates: a question's first call has the address of the previous question's second call to
  // that entry point.
  bool& elsewhere_first = elsewhere_first_[static_cast<std::size_t>(mailbox_.call)];
  elsewhere_first = !elsewhere_first;
  return elsewhere_first ? Blobs{both.second, both.first} : both;
}

std::uint64_t Desk::call_at_guard(std::uint64_t room, unsigned char filling, const std::uint8_t* blob) {
  std::byte* out = blob_answer(room);
  set_canary(out);
  std::memset(out, filling, static_cast<std::size_t>(room));
  Arguments arguments = whole(out, room);
  // A lookup's arrays move, too: each a different number of elements behind a line.
  const std::size_t bytes = asked().signature.number_bytes, all = arguments.count * bytes;
  for (std::size_t array = 0; blob != arguments.blob && array < asked().signature.arrays; ++array) {
    std::vector<std::byte>& room = arrays_elsewhere_[array];
    room.resize(all + 2 * line);
    std::byte* there = room.data() + before_line(room) + (array + 1) * bytes;
    std::copy_n(arguments.arrays[array], all, there);
    arguments.arrays[array] = there;
  }
  arguments.blob = blob;
  const std::uint64_t size = guarded(arguments, 0);
  check_canary(out, 0);
  return size;
}

void Desk::encode_within(std::uint64_t room, std::uint64_t size, unsigned char filling,
                         const std::uint8_t* blob) {
  if (const std::uint64_t again = call_at_guard(room, filling, blob); again != size)
    stop(Outcome::non_deterministic, 0,
         "a code of " + text(size) + " bytes, then, with room for " + text(room) + ", of " + text(again));
}

void Desk::encode_in_room(std::uint64_t room, std::uint64_t size, const std::uint8_t* blob) {
  encode_within(room, size, blank_again, blob);
  if (room >= size)
    compare(again_.data(), blob_answer(room), static_cast<std::size_t>(size), 0,
            "asked with room for " + text(room) + " bytes");
}

void Desk::encode_in_other_rooms(std::uint64_t size, const std::uint8_t* blob) {
  const std::uint32_t before = mailbox_.asked_before;
  const bool late = before >= first_thorough && before % one_in_other_rooms != 0;
  if (late || std::max({mailbox_.blob_bytes, mailbox_.room, size}) > most_thorough) return;
  // A vector's store, or a word's, may need room behind the last byte.
  std::vector<std::uint64_t> rooms{1, size / 2, mailbox_.blob_bytes};
  for (std::uint64_t more = 1; more <= 8; ++more) rooms.push_back(size + more);
  const std::size_t turn = before < first_thorough ? before : before / one_in_other_rooms;
  for (std::size_t k = 0; k < rooms.size(); ++k) {
    if (before >= first_from_threads && turn % rooms.size() != k) continue;
    encode_in_room(rooms[k], size, blob);
  }
  if (before < first_with_much_room)
    for (const std::uint64_t room : much_room) encode_in_room(std::max(room, size), size, blob);
  // The tool expects the answer in its place.
  std::copy(again_.begin(), again_.end(), blob_answer(size));
}

void Desk::encode(bool thorough) {
  const auto [blob, other_blob] = blobs();
  std::uint64_t room = mailbox_.room, size = call_at_guard(room, blank, blob);
  if (size > blob_capacity)
    stop(Outcome::too_large, 0, "asked for " + text(size) + " bytes, more than " + text(blob_capacity));
  if (size > room) {
    room = size;
    encode_within(room, size, blank, blob);
  }
  again_.assign(blob_answer(room), blob_answer(room) + size);
  if (thorough && size != 0)
    for (const std::uint64_t too_little : {std::uint64_t{0}, size - 1})
      encode_within(too_little, size, blank, blob);
  // The room is exactly what the code needs.
  encode_within(size, size, blank_again, other_blob);
  compare(again_.data(), blob_answer(size), static_cast<std::size_t>(size), 0, "asked again");
  if (size != 0) encode_in_other_rooms(size, blob);
  ask_blob_at_other_places(size);
  if (thorough) {
    ask_blob_over_answers(blob, size);
    ask_blob_after_another_format(blob, size);
    ask_blob_after_kept_formats(blob, size);
    ask_blob_from_threads(size);
    ask_blob_as_other_callers(blob, size);
  }
  mailbox_.report.taken = size != 0 ? 1 : 0;
  mailbox_.report.answer_bytes = size;
}

void Desk::answer(bool thorough) {
  const auto [blob, other_blob] = blobs();
  const std::uint64_t room = mailbox_.room, first = call_at_guard(room, blank, blob);
  again_.assign(blob_answer(room), blob_answer(room) + room);
  const std::uint64_t second = call_at_guard(room, blank_again, other_blob);
  if (first != second)
    stop(Outcome::non_deterministic, 0, first != 0 ? "taken, then refused" : "refused, then taken");
  if (first != 0) compare(again_.data(), blob_answer(room), static_cast<std::size_t>(room), 0, "asked again");
  // Elements in a blob are repeated as elements, whatever their number.
  if (first != 0 && (thorough || mailbox_.asked_before < first_thorough)) ask_blob_in_each_size(blob);
  ask_blob_at_other_places(first);
  if (thorough) {
    ask_blob_over_answers(blob, first);
    if (any_bytes_are_one(mailbox_.call)) ask_blob_after_like_ones(blob);
    if (asked().topic == Topic::micromap && any_bytes_are_one(mailbox_.call))
      ask_blob_after_level_below(blob);
    ask_blob_after_another_format(blob, first);
    ask_blob_after_kept_formats(blob, first);
    ask_blob_from_threads(first);
    ask_blob_as_other_callers(blob, first);
  }
  mailbox_.report.taken = first != 0 ? 1 : 0;
  mailbox_.report.answer_bytes = first;
}

void Desk::ask_blob_after(const Arguments& before, Fenced& out, const std::uint8_t* blob, std::uint64_t size,
                          const std::string& how) {
  guarded(before, out, 0);
  const std::uint64_t again = call_at_guard(again_.size(), blank_again, blob);
  if (again != size)
    stop(Outcome::non_deterministic, 0, how + ": " + text(size) + " returned, then " + text(again));
  if (size != 0) compare(again_.data(), blob_answer(again_.size()), again_.size(), 0, how);
}

void Desk::ask_blob_into(Fenced& out, const std::uint8_t* blob, std::uint64_t size, const std::string& how) {
  Arguments a = whole(nullptr, again_.size());
  a.blob = blob;
  if (const std::uint64_t again = guarded(a, out, 0); again != size)
    stop(Outcome::non_deterministic, 0, how + ": " + text(size) + " returned, then " + text(again));
  if (size != 0) compare(again_.data(), out.data(), again_.size(), 0, how);
}

void Desk::ask_blob_at_other_places(std::uint64_t size) {
  if (asked().topic == Topic::bake || mailbox_.blob_bytes == 0) return;
  if (std::max(mailbox_.blob_bytes, mailbox_.room) > most_thorough) return;
  const bool is_short =
      mailbox_.blob_bytes <= most_at_all_places && again_.size() <= most_answer_at_all_places;
  if (mailbox_.asked_before >= (is_short ? first_short_at_all_places : first_from_threads)) return;
  const std::uint8_t* here = whole(nullptr, 0).blob;
  std::vector<std::byte> room(static_cast<std::size_t>(mailbox_.blob_bytes) + 2 * line);
  for (std::size_t turn = 0; turn < places; ++turn) {
    auto* there =
        reinterpret_cast<std::uint8_t*>(room.data() + before_line(room) + place_behind_line(turn, 1));
    std::copy_n(here, mailbox_.blob_bytes, there);
    // The output moves as well, to places in another order.
    Fenced out(again_.size(), blank_again, place_behind_line(5 * turn + 1, asked().signature.value_bytes));
    ask_blob_into(out, there, size, "asked with its bytes at another address");
  }
}

void Desk::ask_blob_after_like_ones(const std::uint8_t* blob) {
  constexpr std::size_t word = 8;
  const auto size = static_cast<std::size_t>(mailbox_.blob_bytes);
  if (size < 2 * word) return;
  Fenced answer(static_cast<std::size_t>(mailbox_.room), blank);
  Arguments before = whole(nullptr, mailbox_.room);
  const std::vector<std::uint8_t> these(blob, blob + size);
  const auto inverted = [&](std::size_t from, std::size_t to) {
    std::vector<std::uint8_t> other = these;
    for (std::size_t k = from; k < to; ++k) other[k] = static_cast<std::uint8_t>(~other[k]);
    return other;
  };
  // Something else comes first: otherwise a cache still has the answer for these bytes, and not for the
  // similar ones.
  std::vector<std::uint8_t> unlike = these;
  for (std::size_t k = 0; k < size; ++k) unlike[k] = static_cast<std::uint8_t>(unlike[k] + 1 + 3 * k);
  const auto after = [&](const std::vector<std::uint8_t>& bytes, const char* how) {
    before.blob = unlike.data();
    guarded(before, answer, 0);
    before.blob = bytes.data();
    ask_blob_after(before, answer, blob, mailbox_.room, how);
  };
  std::vector<std::uint8_t> turned = these;
  std::rotate(turned.begin(), turned.begin() + word,
              turned.begin() + static_cast<std::ptrdiff_t>(size / word * word));
  after(turned, "asked after the same words of eight bytes in another order");
  after(inverted(size / 2, size), "asked after other bytes with the same first half");
  after(inverted(0, size / 2), "asked after other bytes with the same second half");
}

void Desk::ask_blob_after_level_below(const std::uint8_t* blob) {
  if (mailbox_.level < 2) return;
  // This asks the first quarter of the bytes.
  Fenced answer(static_cast<std::size_t>(mailbox_.room), blank);
  Arguments before = whole(nullptr, mailbox_.room);
  before.blob = blob;
  before.level = mailbox_.level - 1;
  ask_blob_after(before, answer, blob, mailbox_.room, "asked after level " + text(before.level));
}

Desk::Question Desk::this_question(std::uint64_t size) const {
  Question q;
  const std::uint64_t room = asked().signature.sizes_answer ? size : mailbox_.room;
  q.arguments = whole(nullptr, room);
  q.size = size;
  q.answer.assign(blob_answer(room), blob_answer(room) + room);
  const auto* blob = reinterpret_cast<const std::byte*>(q.arguments.blob);
  q.blob.assign(blob, blob + q.arguments.blob_bytes);
  q.arguments.blob = reinterpret_cast<const std::uint8_t*>(q.blob.data());
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    const std::byte* numbers = q.arguments.arrays[array];
    q.arrays[array].assign(numbers, numbers + q.arguments.count * asked().signature.number_bytes);
    q.arguments.arrays[array] = q.arrays[array].data();
  }
  return q;
}

void Desk::ask_blob_from_threads(std::uint64_t size) {
  // A race on memory that two threads share shows only if they meet in it, so some questions of a level are
  // repeated often.
  const std::uint32_t before = mailbox_.asked_before;
  const bool early =
      before < first_from_threads || (before < later_from_threads && before % one_in_from_threads == 0);
  const Rounds rounds = early ? Rounds{2, 256, std::chrono::milliseconds(2)} : Rounds{};
  Question now = this_question(size);
  std::string how = asked_from_threads;
  const auto asked_by_thread = [&](const Question& q) {
    return Asked{q.arguments, q.answer.size(),
                 [this, &q, &how](const std::byte* theirs, std::uint64_t their_size) {
                   if (their_size != q.size)
                     stop(Outcome::non_deterministic, 0,
                          how + ": " + text(q.size) + " bytes, then " + text(their_size));
                   if (q.size != 0) compare(q.answer.data(), theirs, q.answer.size(), 0, how);
                 }};
  };
  std::optional<Question>& earlier = earlier_[static_cast<std::size_t>(mailbox_.call)];
  const Asked this_one = asked_by_thread(now);
  ask_from_threads(this_one, this_one, rounds, 0);
  const bool another_kind = (before < first_thorough ? before : before / 64 + before / 256) % 2 != 0;
  const Question* other = another_kind ? question_of_another_kind() : nullptr;
  if (other != nullptr) {
    how += in_another_kind;
    const Question longer = longer_question(size);
    ask_from_threads(asked_by_thread(longer), asked_by_thread(*other), rounds, 0);
  } else if (earlier) {
    ask_from_threads(this_one, asked_by_thread(*earlier), rounds, 0);
  }
  earlier.emplace(std::move(now));
  keep_for_other_kinds(size);
}

}  // namespace mmverify::dock
