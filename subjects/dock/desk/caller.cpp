#include "subjects/dock/desk/caller.hpp"

#include <algorithm>
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

namespace mmverify::dock {
namespace {

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

Caller::Caller(std::byte* base, const Layout& layout, const mmverify_subject_t& subject,
               const Promised& promised, std::uint64_t mode_before_loading)
    : base_(base),
      layout_(layout),
      mailbox_(*reinterpret_cast<Mailbox*>(base)),
      subject_(subject),
      promised_(promised),
      mode_(mode_before_loading),
      mode_of_loading_(float_mode()) {
  CPU_ZERO(&processors_);
  sched_getaffinity(0, sizeof processors_, &processors_);
}

void Caller::finish(Outcome outcome, std::uint64_t element, const std::string& message) const {
  Report& report = mailbox_.report;
  report.outcome = outcome;
  report.element = element;
  std::snprintf(report.message, sizeof report.message, "%s", message.c_str());
}

void Caller::stop(Outcome outcome, std::uint64_t element, const std::string& message) const {
  finish(outcome, element, message);
  throw Stop();
}

std::uint64_t Caller::guarded(const Arguments& a, std::uint64_t element) const {
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

std::uint64_t Caller::guarded(Arguments a, Fenced& out, std::uint64_t element) const {
  a.out = out.data();
  const std::uint64_t size = guarded(a, element);
  check_fence(out, element);
  return size;
}

std::uint64_t Caller::guarded_beyond(const Arguments& a, Fenced& out, std::uint64_t element) const {
  mark_beyond(true);
  const std::uint64_t size = guarded(a, out, element);
  mark_beyond(false);
  return size;
}

void Caller::mark_beyond(bool begins) const {
  mailbox_.another_level.store(begins ? 1 : 0, std::memory_order_relaxed);
}

bool Caller::call_in_thread(const Arguments& a, Answers& mine) const {
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

void Caller::check_mode(std::uint64_t left, std::uint64_t element, const char* where) const {
  if (left == mode_) return;
  stop(differ_in_masks_alone(left, mode_) ? Outcome::unmasked_exceptions : Outcome::changed_mode, element,
       where);
}

void Caller::check_left(const Left& left, std::uint64_t element, const char* where) const {
  if (left.mode) check_mode(*left.mode, element, where);
  if (left.registers) stop(Outcome::left_registers, element, where);
  if (left.signals) stop(Outcome::changed_signals, element, where);
}

void Caller::check_the_process(std::uint64_t number) const {
  // A change stays, so that a later look finds it, too; each look costs system calls.
  constexpr std::uint64_t first = 64, one_in = 16;
  if (number >= first && number % one_in != 0) return;
  if (signals_changed()) check_left({{}, false, true}, 0, "");
  std::string change = promised_.change();
  if (change.empty() && (number == 0 || std::has_single_bit(number)))
    change = promised_.change_when_asked_again();
  if (!change.empty()) stop(Outcome::changed_struct, 0, change);
}

void Caller::check_fence(const Fenced& out, std::uint64_t element) const {
  if (!out.is_whole_before()) stop(Outcome::wrote_before, element, "");
  if (!out.is_whole_behind()) stop(Outcome::wrote_behind, element, "");
}

std::uint64_t Caller::guarded_at_page(Arguments a, std::size_t bytes, unsigned char filling,
                                      std::uint64_t element) const {
  a.out = at_guard_page(bytes);
  set_canary(a.out);
  std::memset(a.out, filling, bytes);
  const std::uint64_t size = guarded(a, element);
  check_canary(a.out, element);
  return size;
}

void Caller::set_canary(std::byte* out) { std::memset(out - canary_size, canary, canary_size); }

void Caller::check_canary(const std::byte* out, std::uint64_t element) const {
  if (!all(out - canary_size, canary_size, canary)) stop(Outcome::wrote_before, element, "");
}

void Caller::compare(const std::byte* before, const std::byte* again, std::size_t count, std::uint64_t first,
                     const std::string& how) const {
  const std::size_t wide = entry().answer_bytes;
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
  const Signature& signature = entry().signature;
  const auto byte = [&](const std::byte* at) { return text(std::to_integer<unsigned>(*at)); };
  const auto word = [&](const std::byte* at) {
    if (signature.value_bytes == 1) return byte(at);
    return signature.answers_floats ? number_at<float>(at) : number_at<std::uint32_t>(at);
  };
  stop(Outcome::non_deterministic, first + t,
       how + (signature.of_blob ? ": byte " + text(t) + " was " + byte(was) + ", then " + byte(is)
                                : ": " + word(was + number) + " before, " + word(is + number) + " then"));
}

void Caller::compare_in_order(const std::byte* before, const std::byte* again, std::size_t wide,
                              const std::vector<std::size_t>& order, std::uint64_t first,
                              const std::string& how) const {
  const std::size_t answers = wide / entry().answer_bytes;
  for (std::size_t k = 0; k < order.size(); ++k)
    compare(before + order[k] * wide, again + k * wide, answers, first + order[k] * answers, how);
}

void Caller::compare(const Question& question, std::uint64_t size, const std::byte* answer,
                     const std::string& how) const {
  if (size != question.size)
    stop(Outcome::non_deterministic, question.element,
         how + ": " + std::to_string(question.size) + " returned, then " + std::to_string(size));
  if (size != 0)
    compare(question.answer, answer, question.bytes / entry().answer_bytes, question.element, how);
}

}  // namespace mmverify::dock
