// What a worker process works at: it runs the commands in the mailbox, and asks everything again to see whether
// the subject's answers stay the same.
#pragma once

#include <sched.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "dock/desk/arguments.hpp"
#include "dock/layout.hpp"

namespace mmverify::dock {

class Desk {
 public:
  /// Domain: base is map()'s, subject is cannot_load()'s; the rounding and flush modes are those of a fresh
  /// process.
  Desk(std::byte* base, const Layout& layout, const mmverify_subject_t& subject);

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

  /// Two threads ask at once, each `rounds` times, for an answer of up to `bytes` bytes over `blank_again`; they go to
  /// see(answer, size).  Exceptions count against `element`.  Nothing where the subject is for one thread.
  using See = std::function<void(const std::byte* answer, std::uint64_t size)>;
  void ask_from_threads(const Arguments& a, std::size_t bytes, std::size_t rounds, std::uint64_t element,
                        const See& see);

  /// Compares answers of `count` elements with those of being asked again `how`, over bytes of `blank_again`.
  /// `first` is the first element's number in the command.
  void compare(const std::byte* before, const std::byte* again, std::size_t count, std::uint64_t first,
               const std::string& how);

  /// Numbers in slots (numbers.cpp).
  void run_on_numbers(std::uint64_t number);
  /// `count` elements of a slot from `at` on.
  Arguments piece(std::size_t slot, std::size_t at, std::size_t count, std::byte* out) const;
  std::byte* slot_answer(std::size_t slot) const;
  void call_slot(std::size_t slot);
  /// Asks a batch again in pieces of another size, and so at other places and addresses.
  void ask_slot_again(std::size_t slot, std::size_t size);
  void ask_slot_from_threads(std::size_t slot);
  bool first_at_this_level() const;
  void mark_level();

  /// A map, a code or a case (blobs.cpp).
  void run_on_blob();
  Arguments whole(std::byte* out, std::uint64_t room) const;
  /// Calls with the output at its guard page, filled with `filling` before.
  std::uint64_t call_at_guard(std::uint64_t room, unsigned char filling);
  void encode(bool thorough);
  void answer(bool thorough);
  /// Domain: the answer of `size` bytes is in its place.
  void ask_blob_from_threads(std::uint64_t size);
  std::byte* blob_answer(std::uint64_t size) const;
  /// The first questions of a kind, and one in so many of the later ones.
  bool thorough();

  std::byte* const base_;
  const Layout layout_;
  Mailbox& mailbox_;
  const mmverify_subject_t& subject_;
  const pid_t self_ = getpid();
  const std::uint32_t mode_;                    ///< of the floating-point unit, as every call must leave it
  cpu_set_t everywhere_;                        ///< processors that this process had before the tool moved it
  std::uint64_t probed_[calls] = {};            ///< bit n: the entry point was asked at level n
  std::uint32_t questions_[calls][32][3] = {};  ///< so far, by entry point, level and format
  std::vector<std::byte> again_;                ///< the other of two answers to one question
};

}  // namespace mmverify::dock
