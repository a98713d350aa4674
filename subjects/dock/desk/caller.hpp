// Calls the subject, looks at what each call leaves behind, and compares answers.
#pragma once

#include <sched.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "subjects/dock/desk/fenced.hpp"
#include "subjects/dock/desk/left.hpp"
#include "subjects/dock/desk/promised.hpp"
#include "subjects/dock/desk/questions.hpp"
#include "subjects/dock/layout.hpp"

namespace mmverify::dock {

class Caller {
 public:
  /// Thrown to end a command; the outcome is in the mailbox.
  struct Stop {};

  /// Domain: `base` is from map(), `subject` from cannot_load(); mode_before_loading is this thread's
  /// float_mode() before the library was loaded.
  Caller(std::byte* base, const Layout& layout, const mmverify_subject_t& subject, const Promised& promised,
         std::uint64_t mode_before_loading);

  Mailbox& mailbox() const { return mailbox_; }
  std::byte* base() const { return base_; }
  const Layout& layout() const { return layout_; }
  const mmverify_subject_t& subject() const { return subject_; }
  /// The entry point of the command, and the entry point's number.
  const EntryPoint& entry() const { return entry_point(mailbox_.call); }
  std::size_t entry_number() const { return static_cast<std::size_t>(mailbox_.call); }
  /// The process's processors before the tool moved it.
  const cpu_set_t& processors() const { return processors_; }
  bool is_single_threaded() const { return (subject_.flags & MMVERIFY_SINGLE_THREADED) != 0; }

  void finish(Outcome outcome, std::uint64_t element, const std::string& message) const;
  [[noreturn]] void stop(Outcome outcome, std::uint64_t element, const std::string& message) const;

  /// Makes the call, and stops the command if it throws, or leaves a mode or register changed; `element` is
  /// blamed. Returns the bytes of the answer: see call().
  std::uint64_t guarded(const Arguments& a, std::uint64_t element) const;
  /// The same with the answer in `out`; nothing around it may change.
  std::uint64_t guarded(Arguments a, Fenced& out, std::uint64_t element) const;
  /// The same for a question that is none of the command's: the law need not ask it, so a crash on it is no case.
  std::uint64_t guarded_beyond(const Arguments& a, Fenced& out, std::uint64_t element) const;
  /// Says to the tool that a question of another level, format or map begins, or has ended.
  void mark_beyond(bool begins) const;
  /// Makes a call in a thread, and adds the result and what it left behind to `mine`. False if it threw.
  bool call_in_thread(const Arguments& a, Answers& mine) const;

  /// Stops the command if the mode, or that of loading, is not what every call must leave.
  void check_mode(std::uint64_t left, std::uint64_t element, const char* where) const;
  void check_mode_of_loading() const { check_mode(mode_of_loading_, 0, "since it was loaded"); }
  void check_fence(const Fenced& out, std::uint64_t element) const;
  /// Stops the command if a thread's calls left something changed.
  void check_left(const Left& left, std::uint64_t element, const char* where) const;
  /// Stops the command if the signal mask or the subject's struct is no longer what it was: after the first
  /// commands and later one in some. Commands 0, 1, 2, 4, 8, ... also call mmverify_subject_v1() again.
  void check_the_process(std::uint64_t number) const;
  bool signals_changed() const { return blocked_signals() != signals_; }

  /// The place of an output of `bytes` bytes that ends at a guard page.
  std::byte* at_guard_page(std::size_t bytes) const { return base_ + layout_.blob_answer_at(bytes); }
  /// The same as guarded() with the answer in that place, over bytes of `filling`.
  std::uint64_t guarded_at_page(Arguments a, std::size_t bytes, unsigned char filling,
                                std::uint64_t element) const;
  /// Marks the bytes before an output, and stops the command if they changed.
  static void set_canary(std::byte* out);
  void check_canary(const std::byte* out, std::uint64_t element) const;

  /// Compares `count` elements of an answer with the repeated one, which was written over bytes of
  /// `blank_again`. `how` describes the repetition; `first` is the first element's number in the command.
  void compare(const std::byte* before, const std::byte* again, std::size_t count, std::uint64_t first,
               const std::string& how) const;
  /// Compares elements of `wide` bytes: the repeated answer has element order[k] at place k.
  void compare_in_order(const std::byte* before, const std::byte* again, std::size_t wide,
                        const std::vector<std::size_t>& order, std::uint64_t first,
                        const std::string& how) const;
  /// Compares the result of a call, and the answer that it wrote, with the question's.
  void compare(const Question& question, std::uint64_t size, const std::byte* answer,
               const std::string& how) const;

 private:
  std::byte* const base_;
  const Layout layout_;
  Mailbox& mailbox_;
  const mmverify_subject_t& subject_;
  const Promised& promised_;
  const std::uint64_t mode_;                         ///< floating-point mode that every call must leave
  const std::uint64_t mode_of_loading_;              ///< floating-point mode after the library was loaded
  const std::uint64_t signals_ = blocked_signals();  ///< mask that every call must leave
  cpu_set_t processors_;
};

}  // namespace mmverify::dock
