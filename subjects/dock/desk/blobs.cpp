// Commands on a map, a code or a case. Each call is made at least twice: over other bytes in its output, with
// another room for it, and with its input at another address.
#include <algorithm>
#include <string>

#include "subjects/dock/desk/commands.hpp"
#include "subjects/dock/desk/provocations.hpp"
#include "subjects/dock/desk/two_threads.hpp"

namespace mmverify::dock {
namespace {

std::string text(std::uint64_t number) { return std::to_string(number); }

/// Whether any bytes of the right size are a valid map or block for the question.
bool takes_any_bytes(const Blob& blob) {
  switch (blob.caller.mailbox().call) {
    case Call::micromap_force2:
    case Call::micromap_widen:
    case Call::micromap_up:
    case Call::micromap_down:
    case Call::micromap_through:
    case Call::micromap_substitute:
    case Call::vq2_decode:
    case Call::vq2_region:
    case Call::vq4_decode:
    case Call::vq4_region: return true;
    default: return false;
  }
}

bool always(const Blob&) { return true; }
bool thorough(const Blob& blob) { return blob.is_thorough(); }
bool thorough_and_any_bytes(const Blob& blob) { return blob.is_thorough() && takes_any_bytes(blob); }
bool thorough_and_any_map(const Blob& blob) {
  return thorough_and_any_bytes(blob) && blob.caller.entry().topic == Topic::micromap;
}
bool writes_code(const Blob& blob) { return blob.signature().sizes_answer && blob.size != 0; }
/// Elements in a blob are repeated as elements, whatever their number.
bool early_and_taken(const Blob& blob) {
  constexpr std::uint32_t first = 64;
  return !blob.signature().sizes_answer && blob.size != 0 && (blob.is_thorough() || blob.before() < first);
}

/// Many provocations add limits of their own: each is for the first questions of a kind, or for short ones.
struct BlobProvocation {
  void (*ask)(const Blob&);
  bool (*when)(const Blob&);
};
constexpr BlobProvocation blob_provocations[] = {{in_each_size, early_and_taken},
                                                 {in_other_rooms, writes_code},
                                                 {at_other_places, always},
                                                 {over_answers, thorough},
                                                 {after_like_ones, thorough_and_any_bytes},
                                                 {after_the_level_below, thorough_and_any_map},
                                                 {after_another_format, thorough},
                                                 {after_kept_formats, thorough},
                                                 {from_threads, thorough},
                                                 {in_circumstances, thorough},
                                                 {with_one_array, thorough},
                                                 {beside_a_writer, thorough},
                                                 {from_many_threads, thorough}};

/// The first calls of a level from two threads.
TwoAnswers first_from_threads(const Blob& blob) {
  if (blob.is_large() || blob.before() != 0) return {};
  const ThreadQuestion question{
      blob.arguments(blob.original(), blob.room()), static_cast<std::size_t>(blob.room()), {}};
  return answers_from_threads(blob.caller, question, question, {1, 1}, 0);
}

/// Compares those calls' answers with the later one.
void compare_first(const TwoAnswers& early, const Blob& blob) {
  const bool sized = blob.signature().sizes_answer;
  for (const Answers& one : early) {
    if (one.sizes.empty()) continue;
    if ((sized && one.sizes[0] != blob.size) || (one.sizes[0] != 0) != (blob.size != 0))
      blob.caller.stop(
          Outcome::non_deterministic, 0,
          first_from_two_threads + (": " + text(one.sizes[0])) + " returned, then " + text(blob.size));
    if (blob.size != 0 && blob.answer.size() <= blob.room())
      blob.caller.compare(blob.answer.data(), one.in_round(0), blob.answer.size(), 0, first_from_two_threads);
  }
}

/// Asks for a code: with the tool's room, with what the code needs, with too little, and with just enough.
void encode(Blob& blob) {
  std::uint64_t room = blob.room();
  blob.size = blob.call_at_guard(room, blank, blob.bytes);
  if (blob.size > blob_capacity)
    blob.caller.stop(Outcome::too_large, 0,
                     "asked for " + text(blob.size) + " bytes, more than " + text(blob_capacity));
  if (blob.size > room) {
    room = blob.size;
    blob.encode_within(room, blank, blob.bytes);
  }
  const std::byte* const code = blob.caller.at_guard_page(static_cast<std::size_t>(room));
  blob.answer.assign(code, code + blob.size);
  if (blob.is_thorough() && blob.size != 0)
    for (const std::uint64_t too_little : {std::uint64_t{0}, blob.size - 1})
      blob.encode_within(too_little, blank, blob.bytes);
  blob.encode_within(blob.size, blank_again, blob.elsewhere);
  blob.caller.compare(blob.question(), blob.size, blob.caller.at_guard_page(blob.answer.size()),
                      "asked again");
}

/// Asks for an answer of a known size.
void answer(Blob& blob) {
  const std::byte* const out = blob.caller.at_guard_page(static_cast<std::size_t>(blob.room()));
  blob.size = blob.call_at_guard(blob.room(), blank, blob.bytes);
  blob.answer.assign(out, out + blob.room());
  const std::uint64_t again = blob.call_at_guard(blob.room(), blank_again, blob.elsewhere);
  if (blob.size != again)
    blob.caller.stop(Outcome::non_deterministic, 0,
                     again == 0 ? "taken, then refused" : "refused, then taken");
  blob.caller.compare(blob.question(), again, out, "asked again");
}

}  // namespace

void run_on_blob(const Caller& caller, WorkerMemory& kept) {
  Blob blob(caller, kept);
  const TwoAnswers early = first_from_threads(blob);
  if (blob.signature().sizes_answer)
    encode(blob);
  else
    answer(blob);
  for (const BlobProvocation& provocation : blob_provocations)
    if (provocation.when(blob)) provocation.ask(blob);
  // The tool expects the answer in its place.
  if (blob.size != 0)
    std::copy(blob.answer.begin(), blob.answer.end(), caller.at_guard_page(blob.answer.size()));
  caller.mailbox().report.taken = blob.size != 0 ? 1 : 0;
  caller.mailbox().report.answer_bytes = blob.size;
  compare_first(early, blob);
}

}  // namespace mmverify::dock
