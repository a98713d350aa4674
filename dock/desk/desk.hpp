// What a worker process works at: it runs the commands in the mailbox, and asks everything again to see whether
// the subject's answers stay the same.
#pragma once

#include <sched.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dock/desk/arguments.hpp"
#include "dock/desk/places.hpp"
#include "dock/layout.hpp"

namespace mmverify::dock {

/// More elements than 16 bits count, and no multiple of a vector's.
constexpr std::size_t odd_batch = large_batch_size + 7;

/// Which of `count` elements the k-th of a longer batch is: all, then all from the second on, and so forth.  In order
/// each time, those a power of two apart would be one.
constexpr std::size_t element_over_and_over(std::size_t k, std::size_t count) {
  return (k + k / count) % count;
}

/// `count` elements of so many bytes: at place k the one of number of(k).
template <class Of>
std::vector<std::byte> gathered(const std::byte* elements, std::size_t bytes, std::size_t count, Of of) {
  std::vector<std::byte> all(count * bytes);
  for (std::size_t k = 0; k < count; ++k)
    std::memcpy(all.data() + k * bytes, elements + of(k) * bytes, bytes);
  return all;
}

class Desk {
 public:
  /// Domain: base is map()'s, subject is cannot_load()'s; mode_before_loading is this thread's float_mode() before
  /// the library was loaded.
  Desk(std::byte* base, const Layout& layout, const mmverify_subject_t& subject,
       std::uint64_t mode_before_loading);

  /// Runs commands as they come, until the tool ends the process.
  [[noreturn]] void serve();

 private:
  /// Ends a command; the outcome is in the mailbox.
  struct Stop {};

  /// Runs the command in the mailbox, the `number`th of this process.
  void run(std::uint64_t number);
  void finish(Outcome outcome, std::uint64_t element, const std::string& message);
  [[noreturn]] void stop(Outcome outcome, std::uint64_t element, const std::string& message);

  const EntryPoint& asked() const { return entry_point(mailbox_.call); }

  /// call(), with what it throws and the modes it leaves behind caught; those count against `element`.
  std::uint64_t guarded(const Arguments& a, std::uint64_t element);

  /// The bytes before an output.
  static void set_canary(std::byte* out);
  void check_canary(const std::byte* out, std::uint64_t element);

  /// What one of two threads asks, and where its answers go: of up to `bytes` bytes, over `blank_again`.
  struct Asked {
    Arguments arguments;
    std::size_t bytes;
    std::function<void(const std::byte* answer, std::uint64_t size)> see;
  };
  /// A thread's answers, round by round.
  struct Answers {
    static constexpr std::size_t margin =
        4096;  ///< a subject that writes outside its output spoils nothing yet
    std::vector<std::vector<std::byte>> rooms;  ///< an answer between two margins
    std::vector<std::uint64_t> sizes;
    std::size_t bytes = 0;
    bool threw = false, changed_mode = false, lacks_memory = false;
    std::size_t first_address = 0, value_bytes = 1;  ///< answers lie at each place in turn
    std::size_t place(std::size_t round) const {
      return before_line(rooms[round]) + margin + place_behind_line(first_address + round, value_bytes);
    }
    const std::byte* in_round(std::size_t round) const { return rooms[round].data() + place(round); }
  };
  using FromThreads = std::array<Answers, 2>;
  /// How often a thread asks: at least twice, and on for as long as this, up to so many times.
  struct Rounds {
    std::size_t least = 2, most = 2;
    std::chrono::microseconds within{0};
  };
  /// What threads share is seen only where they meet between two of its stores: a level's first batch is asked often.
  static constexpr Rounds often{2, 256, std::chrono::milliseconds(4)};
  /// Two threads ask at once, each its own question over and over.  Empty where the subject is for one thread.
  /// A mode that a thread is left with counts against `element`.  Throws std::system_error where no thread can be had.
  FromThreads answers_from_threads(const Asked& here, const Asked& there, const Rounds& rounds,
                                   std::uint64_t element);
  /// The same; the questions see the answers.  Exceptions count against `element`.
  void ask_from_threads(const Asked& here, const Asked& there, const Rounds& rounds, std::uint64_t element);

  /// Compares answers of `count` elements with those of being asked again `how`, over bytes of `blank_again`.
  /// `first` is the first element's number in the command.
  void compare(const std::byte* before, const std::byte* again, std::size_t count, std::uint64_t first,
               const std::string& how);

  /// Numbers in slots (numbers.cpp).
  void run_on_numbers(std::uint64_t number);
  /// The same for a subject of MMVERIFY_LARGE_BATCHES (large.cpp): many slots a call, and asked again less often.
  void run_on_large_batches(std::uint64_t number);
  /// `count` elements from `from` on, which several slots hold: asked in one call, over bytes of `filling`.
  std::vector<std::byte> ask_at_once(std::size_t from, std::size_t count, unsigned char filling);
  /// `count` elements of a slot from `at` on.
  Arguments piece(std::size_t slot, std::size_t at, std::size_t count, std::byte* out) const;
  std::byte* slot_answer(std::size_t slot) const;
  void call_slot(std::size_t slot);
  /// Asks the batch from two threads before anything else was asked of its level: a table that the first call fills
  /// must be whole before another call reads it.  What is thrown comes again.
  FromThreads slot_from_threads_first(std::size_t slot);
  /// Asks a batch again in pieces of another size, and so at other places and addresses.
  void ask_slot_again(std::size_t slot, std::size_t size, std::size_t most = batch_size);
  /// Both threads ask the batch; then one of them does, and the other one the same turned by half of it.
  void ask_slot_from_threads(std::size_t slot);
  /// Two threads ask a batch at once, one of them turned by half of it, over and over; `answers` are the right ones.
  void ask_turned_from_threads(const Arguments& here, const std::vector<std::byte>& answers,
                               std::size_t count, const Rounds& rounds, std::uint64_t from,
                               const std::string& how);
  /// Asks each of the first `most` elements again right after the same at another level.
  void ask_slot_after_another_level(std::size_t slot, std::size_t most = batch_size);
  /// Asks each element, of several numbers, right after one of the level that was asked before, with the same first number;
  /// and keeps this level's for the next one.
  void ask_slot_after_one_of_the_level_before(std::size_t slot);
  /// `other` is that level; an index is shifted to the right by so many bits.
  void ask_slot_after(std::size_t slot, std::uint32_t other, unsigned less_bits, std::size_t most);
  /// Asks a batch again as often as fills a large one; then two threads do, one of them the same turned by half of it.
  void ask_slot_many_times_over(std::size_t slot);
  /// Asks a batch again with its elements in another order: none may depend on its neighbours.
  void ask_slot_in_another_order(std::size_t slot);
  /// Asks runs of one of its elements with another one inside, at each place but the ends: what is the same at both ends
  /// need not be the same between.
  void ask_slot_in_runs(std::size_t slot);
  /// Asks element order[k] of a batch at place k, then from two threads.  Domain: order has as many as the batch.
  void ask_slot_rearranged(std::size_t slot, const std::vector<std::size_t>& order, const std::string& how);
  /// Asks a batch again with each array, and the answers, at addresses of their own modulo 64.
  void ask_slot_at_other_places(std::size_t slot);
  /// Asks element order[k] of a batch at place k, the answers at a guard page (tails.cpp).
  void ask_slot_elements(std::size_t slot, const std::vector<std::size_t>& order, const std::string& how);
  /// Asks elements of a batch in batches of each size up to that of two vectors.
  void ask_slot_in_each_size(std::size_t slot);
  /// Asks elements, together and one by one, right after others of the batch that differ in one number alone, and in one
  /// of its bits alone (neighbours.cpp).
  void ask_slot_after_neighbours(std::size_t slot);
  /// Asks the first elements, together and one by one, right after the same in each other format that has them, and
  /// those that were asked in another one before right after that.
  void ask_slot_after_another_format(std::size_t slot);
  /// `ask_after` is called with each element of a kept batch, and where it is in this one.
  void ask_slot_after_kept_formats(std::size_t slot,
                                   const std::function<void(const Arguments&, std::size_t)>& ask_after);
  bool first_at_this_level() const;
  void mark_level();

  /// A map, a code or a case (blobs.cpp).
  void run_on_blob();
  Arguments whole(std::byte* out, std::uint64_t room) const;
  /// The map or code at another place: it is bytes, and may lie anywhere, as texels of attributes may. A case of topic
  /// bake stays where it is, its texels are numbers.
  const std::uint8_t* blob_elsewhere();
  /// Where the map or code lies for a question's first call, and for its second.
  struct Blobs {
    const std::uint8_t *first, *second;
  };
  Blobs blobs();
  /// Calls with the output at its guard page, filled with `filling` before.
  std::uint64_t call_at_guard(std::uint64_t room, unsigned char filling, const std::uint8_t* blob);
  /// The same for a map, a code or a case.
  FromThreads blob_from_threads_first();
  /// Compares those with the answer of `size` bytes in its place, of which as many as `room` were asked for.
  void compare_first(const FromThreads& before, std::uint64_t room, std::uint64_t size);
  void encode(bool thorough);
  void answer(bool thorough);
  /// Asks a map, a code or a block again right after what `before` asks.  Domain: `size` was returned for it, its answer
  /// is in again_.
  void ask_blob_after(const Arguments& before, const std::uint8_t* blob, std::uint64_t size,
                      const std::string& how);
  /// The same after bytes that a memo may take for these: the same words in another order, the same first half, the same
  /// second half.  Domain: any bytes are a map, or a block, of the question.
  void ask_blob_after_like_ones(const std::uint8_t* blob);
  /// Asks a map again right after its bytes were asked as one of the level below.
  /// Domain: it was taken, its answer is in its place and in again_.
  void ask_blob_after_level_below(const std::uint8_t* blob);
  /// Asks a question again right after its bytes were asked in each other format that has them (neighbours.cpp).
  void ask_blob_after_another_format(const std::uint8_t* blob, std::uint64_t size);
  /// The same right after questions that were asked in another format before: the last one, and those on the same bytes.
  /// Then keeps this one.
  void ask_blob_after_kept_formats(const std::uint8_t* blob, std::uint64_t size);
  /// Elements that are looked up in a short code, or that lie in the blob themselves; else 0 (tails.cpp).
  std::size_t elements_of_blob() const;
  /// Asks element order[k] of those at place k.  Domain: the answers are in again_.
  void ask_blob_elements(const std::uint8_t* blob, const std::vector<std::size_t>& order,
                         const std::string& how);
  /// Asks those in another order; of the first questions in batches of each small size, and as often as fills one of more
  /// than 2^16.
  void ask_blob_in_each_size(const std::uint8_t* blob);
  /// Asks elements with every value in each byte, alone and then each right after each other one.  Domain: any bytes are
  /// an element.
  void ask_codes_after_each_other();
  /// Both threads ask the question; then the other one asks an earlier one to the same entry point, where there is one.
  /// Domain: the answer of `size` bytes is in its place.
  void ask_blob_from_threads(std::uint64_t size);
  /// A question on a blob, and its answer.
  struct Question {
    Arguments arguments{};
    std::vector<std::byte> blob, arrays[most_arrays], answer;
    std::uint64_t size = 0;  ///< as the call returned it
  };
  /// Domain: as ask_blob_from_threads().
  Question this_question(std::uint64_t size) const;
  std::byte* blob_answer(std::uint64_t size) const;
  /// The first questions of a kind, and one in so many of the later ones.
  bool thorough() const;

  std::byte* const base_;
  const Layout layout_;
  Mailbox& mailbox_;
  const mmverify_subject_t& subject_;
  const pid_t self_ = getpid();
  const std::uint64_t mode_;                   ///< of the floating-point unit, as every call must leave it
  const std::uint64_t mode_of_loading_;        ///< as loading the library left it
  cpu_set_t everywhere_;                       ///< processors that this process had before the tool moved it
  std::uint64_t probed_[calls][formats] = {};  ///< bit n: the entry point was asked at level n
  /// A level's first batch.
  struct Batch {
    std::uint32_t level = 0;
    std::vector<std::byte> arrays[most_arrays];
  };
  std::optional<Batch> level_before_[calls][formats];
  /// Questions on blobs by entry point, level and format: the first ones, and the last one.
  std::map<std::array<std::uint32_t, 3>, std::deque<Question>> kept_;
  std::optional<Question> earlier_[calls];                ///< the last one that was asked from two threads
  std::vector<std::byte> again_;                          ///< the other of two answers to one question
  std::vector<std::byte> elsewhere_;                      ///< holds blob_elsewhere()
  std::vector<std::byte> arrays_elsewhere_[most_arrays];  ///< and what is looked up in it
  bool elsewhere_first_[calls] = {};                      ///< of an entry point's last question
};

}  // namespace mmverify::dock
