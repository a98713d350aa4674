#include "subjects/dock/desk/desk.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <system_error>
#include <thread>

#include "subjects/dock/desk/call.hpp"
#include "subjects/dock/desk/float_mode.hpp"
#include "subjects/dock/futex.hpp"

namespace mmverify::dock {
namespace {

constexpr int patience = 1'000'000;  ///< turns of a loop that waits for another thread; a few milliseconds

/// Whether the process cannot get 16 MiB of memory now.
bool no_memory_can_be_had() {
  const std::unique_ptr<std::byte[]> some(new (std::nothrow) std::byte[16 << 20]);
  return some == nullptr;
}

/// Whether the process cannot start a thread now.
bool no_thread_can_be_had() {
  try {
    std::thread([] {}).join();
    return false;
  } catch (const std::system_error&) {
    return true;
  }
}

template <class Number>
std::string number_at(const std::byte* bytes) {
  Number number{};
  std::memcpy(&number, bytes, sizeof number);
  if constexpr (std::is_integral_v<Number>) return std::to_string(number);
  char text[32];
  std::snprintf(text, sizeof text, "%a", static_cast<double>(number));
  return text;
}

}  // namespace

Desk::Desk(std::byte* base, const Layout& layout, const mmverify_subject_t& subject, const Promised& promised,
           std::uint64_t mode_before_loading)
    : base_(base),
      layout_(layout),
      mailbox_(*reinterpret_cast<Mailbox*>(base)),
      subject_(subject),
      mode_(mode_before_loading),
      promised_(promised),
      mode_of_loading_(float_mode()) {
  CPU_ZERO(&everywhere_);
  sched_getaffinity(0, sizeof everywhere_, &everywhere_);
}

void Desk::serve() {
  for (std::uint64_t number = 0;; ++number) {
    while (mailbox_.turn.load(std::memory_order_acquire) != 1) futex_wait(mailbox_.turn, 0, 1000);
    run(number);
    // A process that the subject forked reaches this line, too.
    if (getpid() != self_) _exit(0);
    mailbox_.turn.store(0, std::memory_order_release);
    futex_wake(mailbox_.turn);
  }
}

void Desk::run(std::uint64_t number) {
  finish(Outcome::answered, 0, "");
  try {
    check_mode(mode_of_loading_, 0, "since it was loaded");
    if (asked().signature.of_blob)
      run_on_blob();
    else
      run_on_numbers(number);
    check_the_process(number);
  } catch (const Stop&) {
  } catch (const std::system_error& e) {  // from std::thread; guarded() catches the subject's exceptions
    finish(Outcome::no_resources, 0, std::string("cannot start a thread: ") + e.what());
  } catch (const std::bad_alloc&) {
    finish(Outcome::no_resources, 0, "cannot get memory");
  }
}

void Desk::finish(Outcome outcome, std::uint64_t element, const std::string& message) {
  Report& report = mailbox_.report;
  report.outcome = outcome;
  report.element = element;
  std::snprintf(report.message, sizeof report.message, "%s", message.c_str());
}

void Desk::stop(Outcome outcome, std::uint64_t element, const std::string& message) {
  finish(outcome, element, message);
  throw Stop();
}

std::uint64_t Desk::guarded(const Arguments& a, std::uint64_t element) {
  std::uint64_t size = 0;
  mailbox_.calls.fetch_add(1, std::memory_order_relaxed);
  try {
    size = call(subject_, mailbox_.call, a);
  } catch (const std::system_error& e) {
    // A library that starts threads or takes memory is not blamed if the machine has none left.
    const bool of_machine = e.code() == std::errc::resource_unavailable_try_again && no_thread_can_be_had();
    stop(of_machine ? Outcome::no_resources : Outcome::threw, element, e.what());
  } catch (const std::bad_alloc& e) {
    stop(no_memory_can_be_had() ? Outcome::no_resources : Outcome::threw, element, e.what());
  } catch (const std::exception& e) {
    stop(Outcome::threw, element, e.what());
  } catch (...) {
    stop(Outcome::threw, element, "");
  }
  check_mode(float_mode(), element, "");
  if (!x87_registers_are_free()) check_left({{}, true, false}, element, "");
  return size;
}

void Desk::check_mode(std::uint64_t left, std::uint64_t element, const char* where) {
  if (left == mode_) return;
  stop(differ_in_masks_alone(left, mode_) ? Outcome::unmasked_exceptions : Outcome::changed_mode, element,
       where);
}

void Desk::check_left(const Left& left, std::uint64_t element, const char* where) {
  if (left.mode) check_mode(*left.mode, element, where);
  if (left.registers) stop(Outcome::left_registers, element, where);
  if (left.signals) stop(Outcome::changed_signals, element, where);
}

void Desk::check_the_process(std::uint64_t number) {
  // A change stays, so that a later look finds it, too; each look costs system calls.
  constexpr std::uint64_t first = 64, one_in = 16;
  if (number >= first && number % one_in != 0) return;
  if (blocked_signals() != signals_) check_left({{}, false, true}, 0, "");
  std::string change = promised_.change();
  if (change.empty() && (number == 0 || std::has_single_bit(number)))
    change = promised_.change_when_asked_again();
  if (!change.empty()) stop(Outcome::changed_struct, 0, change);
}

std::uint64_t Desk::guarded(Arguments a, Fenced& out, std::uint64_t element) {
  a.out = out.data();
  const std::uint64_t size = guarded(a, element);
  check_fence(out, element);
  return size;
}

void Desk::check_fence(const Fenced& out, std::uint64_t element) {
  if (!out.is_whole_before()) stop(Outcome::wrote_before, element, "");
  if (!out.is_whole_behind()) stop(Outcome::wrote_behind, element, "");
}

void Desk::set_canary(std::byte* out) { std::memset(out - canary_size, canary, canary_size); }

void Desk::check_canary(const std::byte* out, std::uint64_t element) {
  if (!all(out - canary_size, canary_size, canary)) stop(Outcome::wrote_before, element, "");
}

bool Desk::call_in_thread(const Arguments& a, Answers& mine) const {
  mailbox_.calls.fetch_add(1, std::memory_order_relaxed);
  try {
    mine.sizes.push_back(call(subject_, mailbox_.call, a));
  } catch (...) {
    mine.threw = true;
    return false;
  }
  if (const std::uint64_t left = float_mode(); left != mode_) mine.left.mode = left;
  mine.left.registers = mine.left.registers || !x87_registers_are_free();
  return true;
}

FromThreads Desk::answers_from_threads(const Asked& here, const Asked& there, const Rounds& rounds,
                                       std::uint64_t element) {
  FromThreads answers;
  if ((subject_.flags & MMVERIFY_SINGLE_THREADED) != 0) return answers;
  std::atomic<int> ready = 0;
  const auto ask = [&](const Asked& what, Answers& mine) {
    mine.first_address = mailbox_.asked_before;
    mine.value_bytes = asked().signature.value_bytes;
    // Both begin at once: a batch is shorter than the start of a thread, or the return from a yield.
    ++ready;
    for (int turns = 0; ready < 2; ++turns)
      if (turns > patience) std::this_thread::yield();
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + rounds.within;
    for (std::size_t k = 0; k < rounds.least || (k < rounds.most && Clock::now() < end); ++k) {
      Arguments own = what.arguments;
      const std::size_t behind = place_behind_line(mine.first_address + k, mine.value_bytes);
      own.out = mine.rooms.emplace_back(what.bytes, blank_again, behind, Fenced::wide_margin).data();
      mine.sizes.reserve(k + 1);
      if (!call_in_thread(own, mine)) return;
    }
    mine.left.signals = blocked_signals() != signals_;
  };
  const auto ask_within_memory = [&](const Asked& what, Answers& mine) {
    try {
      ask(what, mine);
    } catch (const std::bad_alloc&) {
      mine.lacks_memory = true;
    }
  };
  std::thread other([&] {
    // This thread may run anywhere: on the process's own processor the two threads would take turns.
    sched_setaffinity(0, sizeof everywhere_, &everywhere_);
    ask_within_memory(there, answers[1]);
  });
  try {
    // A thread of its own: the subject's thread-local data of the last question may get in the way.
    std::thread one([&] { ask_within_memory(here, answers[0]); });
    one.join();
  } catch (const std::system_error&) {
    ready = 2;  // the other one waits for it
    other.join();
    throw;
  }
  other.join();
  for (const Answers& mine : answers) {
    if (mine.lacks_memory) throw std::bad_alloc();
    // Threads inherit this thread's mode. Exceptions are reported when the answers are compared.
    check_left(mine.left, element, "in a thread");
    for (const Fenced& room : mine.rooms) check_fence(room, element);
  }
  return answers;
}

void Desk::ask_from_threads(const Asked& here, const Asked& there, const Rounds& rounds,
                            std::uint64_t element) {
  for (const FromThreads answers = answers_from_threads(here, there, rounds, element);
       const Answers& one : answers) {
    if (one.threw) stop(Outcome::threw, element, "when called from two threads at once");
    for (std::size_t round = 0; round < one.sizes.size(); ++round)
      (&one == answers.data() ? here : there).see(one.in_round(round), one.sizes[round]);
  }
}

void Desk::compare(const std::byte* before, const std::byte* again, std::size_t count, std::uint64_t first,
                   const std::string& how) {
  const std::size_t wide = asked().answer_bytes;
  if (count == 0 || std::memcmp(before, again, count * wide) == 0) return;
  const std::byte* const differs = std::mismatch(before, before + count * wide, again).first;
  const std::size_t t = static_cast<std::size_t>(differs - before) / wide;
  const std::byte *was = before + t * wide, *is = again + t * wide;
  if (all(is, wide, blank_again)) stop(Outcome::unwritten, first + t, "");
  const auto text = [](auto number) { return std::to_string(number); };
  // If an element has several numbers, the number that differs is reported.
  const std::size_t number = wide > sizeof(std::uint32_t) ? static_cast<std::size_t>(differs - was) /
                                                                sizeof(std::uint32_t) * sizeof(std::uint32_t)
                                                          : 0;
  const Signature& signature = asked().signature;
  const auto byte = [&](const std::byte* at) { return text(std::to_integer<unsigned>(*at)); };
  const auto word = [&](const std::byte* at) {
    if (signature.value_bytes == 1) return byte(at);
    return signature.answers_floats ? number_at<float>(at) : number_at<std::uint32_t>(at);
  };
  stop(Outcome::non_deterministic, first + t,
       how + (signature.of_blob ? ": byte " + text(t) + " was " + byte(was) + ", then " + byte(is)
                                : ": " + word(was + number) + " before, " + word(is + number) + " then"));
}

}  // namespace mmverify::dock
