// The main loop of a worker process. It runs the commands in the mailbox, and repeats every question to see
// whether the subject's answers stay the same.
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
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "subjects/dock/desk/left.hpp"
#include "subjects/dock/desk/lent.hpp"
#include "subjects/dock/desk/places.hpp"
#include "subjects/dock/desk/promised.hpp"
#include "subjects/dock/desk/questions.hpp"
#include "subjects/dock/layout.hpp"

namespace mmverify::dock {

class Desk {
 public:
  /// Domain: `base` is from map(), `subject` from cannot_load(); mode_before_loading is this thread's
  /// float_mode() before the library was loaded.
  Desk(std::byte* base, const Layout& layout, const mmverify_subject_t& subject, const Promised& promised,
       std::uint64_t mode_before_loading);

  /// Runs commands until the tool ends the process.
  [[noreturn]] void serve();

 private:
  /// Thrown to end a command; the outcome is in the mailbox.
  struct Stop {};

  /// Runs the command in the mailbox, command `number` of this process.
  void run(std::uint64_t number);
  void finish(Outcome outcome, std::uint64_t element, const std::string& message);
  [[noreturn]] void stop(Outcome outcome, std::uint64_t element, const std::string& message);

  const EntryPoint& asked() const { return entry_point(mailbox_.call); }

  /// Makes call(), and stops the command if it throws, or leaves a mode or register changed; `element` is blamed.
  std::uint64_t guarded(const Arguments& a, std::uint64_t element);

  /// The same with the answer in `out`; nothing around it may change.
  std::uint64_t guarded(Arguments a, Fenced& out, std::uint64_t element);
  /// Stops the command if `left` is not the floating-point mode that every call must leave.
  void check_mode(std::uint64_t left, std::uint64_t element, const char* where);
  void check_fence(const Fenced& out, std::uint64_t element);
  /// Stops the command if a thread's calls left something changed.
  void check_left(const Left& left, std::uint64_t element, const char* where);
  /// Stops the command if the signal mask or the subject's struct is no longer what it was: after the first
  /// commands and later one in some. Commands 0, 1, 2, 4, 8, ... also call mmverify_subject_v1() again.
  void check_the_process(std::uint64_t number);

  /// Marks the bytes before an output.
  static void set_canary(std::byte* out);
  void check_canary(const std::byte* out, std::uint64_t element);

  /// Rounds for a level's first batch: a race shows only if one thread reads between two stores of the other.
  static constexpr Rounds often{2, 256, std::chrono::milliseconds(4)};
  /// Two threads at once repeat a question each. Empty if the subject is single-threaded. A mode
  /// that is left changed counts against `element`. Throws std::system_error if no thread can be started.
  FromThreads answers_from_threads(const Asked& here, const Asked& there, const Rounds& rounds,
                                   std::uint64_t element);
  /// Makes a call in a thread, and adds the result and what it left behind to `mine`. False if it threw.
  bool call_in_thread(const Arguments& a, Answers& mine) const;
  /// Asks from two threads and lets the questions see the answers. Exceptions count against `element`.
  void ask_from_threads(const Asked& here, const Asked& there, const Rounds& rounds, std::uint64_t element);

  /// Compares `count` elements of an answer with the repeated one, which was written over bytes of
  /// `blank_again`. `how` describes the repetition; `first` is the first element's number in the command.
  void compare(const std::byte* before, const std::byte* again, std::size_t count, std::uint64_t first,
               const std::string& how);

  /// Runs a command on numbers in slots (numbers.cpp).
  void run_on_numbers(std::uint64_t number);
  /// Runs such a command for a subject of MMVERIFY_LARGE_BATCHES (large.cpp): a call takes several slots, and
  /// fewer questions are repeated.
  void run_on_large_batches(std::uint64_t number);
  /// Asks `count` elements from `from` on, of several slots, in one call, over bytes of `filling`.
  Fenced ask_at_once(std::size_t from, std::size_t count, unsigned char filling);
  /// The arguments for `count` elements of a slot from `at` on.
  Arguments piece(std::size_t slot, std::size_t at, std::size_t count, std::byte* out) const;
  /// Asks `count` elements of a slot from `at` on into their place in `out`, which is blank from there on.
  void ask_piece(std::size_t slot, std::size_t at, std::size_t count, Fenced& out);
  std::byte* slot_answer(std::size_t slot) const;
  void call_slot(std::size_t slot);
  /// Asks the batch from two threads before any other question of its level: a table that the first call
  /// fills must be complete before another call reads it. Exceptions are ignored: later calls throw, too.
  FromThreads slot_from_threads_first(std::size_t slot);
  /// Repeats a batch in pieces of another size, and so at other places and addresses.
  void ask_slot_again(std::size_t slot, std::size_t size, std::size_t most = batch_size);
  /// Repeats the batch in two threads; then again with one thread's batch rotated by half its length.
  void ask_slot_from_threads(std::size_t slot);
  /// Repeats a batch in two threads, one of them with the batch rotated by half its length; `answers` are the
  /// right ones.
  void ask_turned_from_threads(const Arguments& here, const std::byte* answers, std::size_t count,
                               const Rounds& rounds, std::uint64_t from, const std::string& how);
  /// Repeats each of the first `most` elements right after the same element at another level.
  void ask_slot_after_another_level(std::size_t slot, std::size_t most = batch_size);
  /// Repeats each element of several numbers right after an element of the previous level with the same first
  /// number; then keeps this level's batch for the next level.
  void ask_slot_after_one_of_the_level_before(std::size_t slot);
  /// Repeats elements right after the same at level `other`; an index is shifted right by less_bits.
  void ask_slot_after(std::size_t slot, std::uint32_t other, unsigned less_bits, std::size_t most);
  /// Repeats a batch until it fills a large one; then in two threads, one of them with the batch rotated by
  /// half its length.
  void ask_slot_many_times_over(std::size_t slot);
  /// Repeats a batch in another order: no element may depend on its neighbours.
  void ask_slot_in_another_order(std::size_t slot);
  /// Repeats one element in runs, with a different element at each inner place: equal ends need not mean an
  /// equal middle.
  void ask_slot_in_runs(std::size_t slot);
  /// Asks element order[k] of a batch at place k, then from two threads. Domain: `order` is as long as the
  /// batch.
  void ask_slot_rearranged(std::size_t slot, const std::vector<std::size_t>& order, const std::string& how);
  /// Repeats a batch with each array, and the answers, at different addresses modulo 64.
  void ask_slot_at_other_places(std::size_t slot);
  /// Repeats a batch over outputs that hold other answers, or the right ones in part (priors.cpp).
  void ask_slot_over_answers(std::size_t slot);
  /// Asks element order[k] of a batch at place k, with the answers at a guard page (tails.cpp).
  void ask_slot_elements(std::size_t slot, const std::vector<std::size_t>& order, const std::string& how);
  /// Asks elements of a batch in batches of each size up to two vectors.
  void ask_slot_in_each_size(std::size_t slot);
  /// Asks a batch in descending order, every other element first, and in long runs of one element.
  void ask_slot_in_orders_of_callers(std::size_t slot);
  /// Repeats elements, together and one by one, right after others of the batch that differ in one number
  /// only, and in one bit of it only (neighbours.cpp).
  void ask_slot_after_neighbours(std::size_t slot);
  /// Repeats the first elements, together and one by one, right after the same in each other valid format;
  /// and elements that were asked in another format before, right after that.
  void ask_slot_after_another_format(std::size_t slot);
  /// Calls ask_after with each element of a kept batch, and its place in this one.
  void ask_slot_after_kept_formats(std::size_t slot,
                                   const std::function<void(const Arguments&, std::size_t)>& ask_after);
  /// Repeats a batch in one thread, and the first batches of earlier levels and formats in another one; then
  /// keeps this one (two_questions.cpp).
  void ask_slot_beside_another_kind(std::size_t slot);
  /// Repeats a batch as other callers ask: with memory that is theirs for the call only, below 2 and 4 GiB
  /// too, and in each manner (circumstances.cpp).
  void ask_slot_in_circumstances(std::size_t slot);
  /// The same for a question on a blob: the first ones in all ways, later ones in one of them in turn.
  /// Domain: as ask_blob_into().
  void ask_blob_in_circumstances(const std::uint8_t* blob, std::uint64_t size);
  /// Makes the call with copies of its inputs, and its output, in memory that is taken back afterwards. The
  /// answer, of `bytes` bytes, is copied to lent_answer_.
  std::uint64_t guarded_in_lent(const Arguments& question, std::size_t bytes, Lent::Where where,
                                std::uint64_t element);
  /// Repeats elements that have the same number in two arrays with one array for both (one_array.cpp).
  void ask_slot_with_one_array(std::size_t slot);
  void ask_blob_with_one_array(const std::uint8_t* blob);
  /// Asks elements `order` with one array for all arrays of `same`; `right` are the answers in their order.
  void ask_with_one_array(const Arguments& question, const std::vector<std::size_t>& same,
                          const std::vector<std::size_t>& order, const std::byte* right, std::uint64_t from);
  /// Asks points (u, u) with two arrays and with one.
  void ask_diagonal_with_one_array(Arguments question, std::size_t first);
  /// Repeats a short question while another thread writes the bytes next to its output (beside.cpp).
  void ask_slot_beside_a_writer(std::size_t slot);
  void ask_blob_beside_a_writer(const std::uint8_t* blob, std::uint64_t size);
  void ask_beside_a_writer(const Arguments& question, const std::byte* right, std::size_t bytes,
                           std::uint64_t size, std::uint64_t element);
  /// Asks a short question from many new threads that are in the subject at once (many_threads.cpp).
  void ask_slot_from_many_threads(std::size_t slot);
  void ask_blob_from_many_threads(const std::uint8_t* blob, std::uint64_t size);
  void ask_from_many_threads(const Arguments& question, const std::byte* right, std::size_t bytes,
                             std::uint64_t size, std::uint64_t element);
  /// Repeats a question in all of these ways. Domain: as ask_blob_into().
  void ask_blob_as_other_callers(const std::uint8_t* blob, std::uint64_t size);
  bool first_at_this_level() const;
  void mark_level();

  /// Runs a command on a map, a code or a case (blobs.cpp).
  void run_on_blob();
  Arguments whole(std::byte* out, std::uint64_t room) const;
  /// A copy of the map or code at another place. It is bytes and may lie anywhere, as texels of attributes
  /// may. A case of topic bake is not copied: its texels are numbers.
  const std::uint8_t* blob_elsewhere();
  /// The places of the map or code for a question's first and second call.
  struct Blobs {
    const std::uint8_t *first, *second;
  };
  Blobs blobs();
  /// Calls with the output at its guard page, filled with `filling`.
  std::uint64_t call_at_guard(std::uint64_t room, unsigned char filling, const std::uint8_t* blob);
  /// The first calls of a level from two threads, for a map, a code or a case.
  FromThreads blob_from_threads_first();
  /// Compares those calls' answers with the later one, of `size` bytes, in its place; they had `room` bytes.
  void compare_first(const FromThreads& before, std::uint64_t room, std::uint64_t size);
  void encode(bool thorough);
  /// Asks for a code of `size` bytes at a guard page, with `room` for it. The size may not change.
  void encode_within(std::uint64_t room, std::uint64_t size, unsigned char filling, const std::uint8_t* blob);
  /// Calls encode_within(), and compares the answer with the one in again_ if there is room for it.
  void encode_in_room(std::uint64_t room, std::uint64_t size, const std::uint8_t* blob);
  /// Asks for a code with little room, and with more than it needs. Domain: `size` is not 0; the code is in
  /// again_.
  void encode_in_other_rooms(std::uint64_t size, const std::uint8_t* blob);
  void answer(bool thorough);
  /// Repeats the question right after the call `before`. Domain: the question returned `size`, and its answer
  /// is in again_; `out` is room for the answer to `before`.
  void ask_blob_after(const Arguments& before, Fenced& out, const std::uint8_t* blob, std::uint64_t size,
                      const std::string& how);
  /// Repeats the question with its answer in `out`. Domain: as ask_blob_after().
  void ask_blob_into(Fenced& out, const std::uint8_t* blob, std::uint64_t size, const std::string& how);
  /// Repeats one of the first questions with its map or code, and its answer, at each place. Domain: as
  /// ask_blob_after().
  void ask_blob_at_other_places(std::uint64_t size);
  /// Repeats the question after bytes that a cache may mistake for these: the same words in another order,
  /// the same first half, the same second half. Domain: any bytes are a valid map or block for the question.
  void ask_blob_after_like_ones(const std::uint8_t* blob);
  /// Repeats the question right after its bytes were asked as a map of the level below.
  /// Domain: the map was taken; its answer is in its place and in again_.
  void ask_blob_after_level_below(const std::uint8_t* blob);
  /// Repeats a question right after its bytes were asked in each other valid format (neighbours.cpp).
  void ask_blob_after_another_format(const std::uint8_t* blob, std::uint64_t size);
  /// Repeats a question right after earlier questions in another format: the last one, and those on the same
  /// bytes. Then keeps this question.
  void ask_blob_after_kept_formats(const std::uint8_t* blob, std::uint64_t size);
  /// Repeats a question over outputs that hold another answer, or the right one in part (priors.cpp). Domain:
  /// the question returned `size`, and its answer is in again_.
  void ask_blob_over_answers(const std::uint8_t* blob, std::uint64_t size);
  /// The number of elements that are looked up in a short code, or that lie in the blob itself; else 0
  /// (tails.cpp).
  std::size_t elements_of_blob() const;
  /// Asks element order[k] of these at place k. Domain: the answers are in again_.
  void ask_blob_elements(const std::uint8_t* blob, const std::vector<std::size_t>& order,
                         const std::string& how);
  /// Asks these elements in another order; for the first questions also in the orders of callers, in batches of each small size, and
  /// repeated until they fill one of more than 2^16.
  void ask_blob_in_each_size(const std::uint8_t* blob);
  /// Asks elements with every value in each byte, alone and then each right after each other one. Domain: any
  /// bytes are an element.
  void ask_codes_after_each_other();
  /// Repeats the question in two threads; then with an earlier question to the entry point in the second
  /// thread: the last one, or one in another level, format, order or mode, in turn.
  /// Domain: the answer of `size` bytes is in its place.
  void ask_blob_from_threads(std::uint64_t size);
  using Question = KeptQuestion;
  /// An earlier question to the entry point at another level or in another format; null: there was none.
  const Question* question_of_another_kind() const;
  /// Keeps the question in the mailbox for later ones of other kinds, in place of the last one of its own kind
  /// unless that tells more. Domain: as ask_blob_from_threads().
  void keep_for_other_kinds(std::uint64_t size);
  /// A copy of the question in the mailbox; if it is a lookup in a short code, with its elements over and over.
  Question longer_question(std::uint64_t size) const;
  /// A longer batch of a slot's elements, with its answers. Domain: the slot is answered.
  Question batch_over_and_over(std::size_t slot) const;
  /// A copy of the question in the mailbox. Domain: as ask_blob_from_threads().
  Question this_question(std::uint64_t size) const;
  std::byte* blob_answer(std::uint64_t size) const;
  /// Whether the question is repeated in every way: the first ones of a kind, and some of the later ones.
  bool thorough() const;

  std::byte* const base_;
  const Layout layout_;
  Mailbox& mailbox_;
  const mmverify_subject_t& subject_;
  const pid_t self_ = getpid();
  const std::uint64_t mode_;  ///< floating-point mode that every call must leave
  const Promised& promised_;
  const std::uint64_t signals_ = blocked_signals();  ///< mask that every call must leave
  const std::uint64_t mode_of_loading_;              ///< floating-point mode after the library was loaded
  cpu_set_t everywhere_;                             ///< the process's processors before the tool moved it
  std::uint64_t probed_[calls][formats] = {};        ///< bit n: the entry point was called at level n
  /// The first batch of a level.
  struct Batch {
    std::uint32_t level = 0;
    std::vector<std::byte> arrays[most_arrays];
  };
  std::optional<Batch> level_before_[calls][formats];
  /// Questions on blobs by entry point, level and format: the first ones, and the last one.
  std::map<std::array<std::uint32_t, 3>, std::deque<Question>> kept_;
  std::optional<Question> earlier_[calls];                ///< the last one that two threads asked
  std::deque<Question> other_kinds_[calls];               ///< questions at other levels and in other formats
  std::vector<std::byte> again_;                          ///< the answer to compare another one with
  std::unique_ptr<Lent> taken_back_;                      ///< the last call's memory
  std::vector<std::byte> lent_answer_;                    ///< the answer of that call
  std::vector<std::byte> elsewhere_;                      ///< the copy of blob_elsewhere()
  std::vector<std::byte> arrays_elsewhere_[most_arrays];  ///< the copies of a lookup's arrays
  bool elsewhere_first_[calls] = {};  ///< by entry point: the last question began with the copy
};

}  // namespace mmverify::dock
