// What a worker process works at: the shared memory, the subject, and calls whose exceptions are caught.
#pragma once

#include <sched.h>

#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>

#include "dock/mailbox.hpp"
#include "sdk/mmverify_subject.h"

namespace mmverify::dock {

/// Ends a command; the outcome is in the mailbox.
struct Stop {};

class Desk {
 public:
  Desk(std::byte* base, const Layout& layout, const mmverify_subject_t& subject)
      : base(base),
        layout(layout),
        mailbox(*reinterpret_cast<Mailbox*>(base)),
        subject(subject),
        mode_(float_mode()) {
    CPU_ZERO(&everywhere_);
    sched_getaffinity(0, sizeof everywhere_, &everywhere_);
  }

  void finish(Outcome outcome, std::uint64_t element, const std::string& message) {
    mailbox.outcome = outcome;
    mailbox.element = element;
    std::snprintf(mailbox.message, sizeof mailbox.message, "%s", message.c_str());
  }

  [[noreturn]] void stop(Outcome outcome, std::uint64_t element, const std::string& message) {
    finish(outcome, element, message);
    throw Stop();
  }

  /// call(), with what it throws and the modes it leaves behind caught.
  template <class F>
  void guarded(F call, std::uint64_t element) {
    try {
      call();
    } catch (const std::exception& e) {
      stop(Outcome::threw, element, e.what());
    } catch (...) {
      stop(Outcome::threw, element, "");
    }
    if (float_mode() != mode_) stop(Outcome::changed_mode, element, "");
  }

  /// The calling thread goes where it likes, not where the tool brought this process: two threads that ask at
  /// once would take turns there.
  void leave_processor() const { sched_setaffinity(0, sizeof everywhere_, &everywhere_); }

  std::byte* const base;
  const Layout layout;
  Mailbox& mailbox;
  const mmverify_subject_t& subject;

 private:
  /// The processor's rounding, flush and exception-mask bits.
  static std::uint32_t float_mode() {
#if defined(__x86_64__)
    return __builtin_ia32_stmxcsr() & 0xffc0u;
#else
    return static_cast<std::uint32_t>(std::fegetround());
#endif
  }
  std::uint32_t mode_;
  cpu_set_t everywhere_;
};

}  // namespace mmverify::dock
