#include "subjects/dock/desk/two_threads.hpp"

#include <atomic>
#include <new>
#include <system_error>
#include <thread>

namespace mmverify::dock {
namespace {

constexpr int patience = 1'000'000;  ///< turns of a loop that waits for another thread; a few milliseconds

/// Asks as often as `rounds` says, as soon as both threads are ready.
void ask(const Caller& caller, const ThreadQuestion& question, const Rounds& rounds, std::atomic<int>& ready,
         Answers& mine) {
  mine.first_address = caller.mailbox().asked_before;
  mine.value_bytes = caller.entry().signature.value_bytes;
  // Both begin at once: a batch is shorter than the start of a thread, or the return from a yield.
  ++ready;
  for (int turns = 0; ready < 2; ++turns)
    if (turns > patience) std::this_thread::yield();
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + rounds.within;
  for (std::size_t k = 0; k < rounds.least || (k < rounds.most && Clock::now() < end); ++k) {
    Arguments own = question.arguments;
    const std::size_t behind = place_behind_line(mine.first_address + k, mine.value_bytes);
    own.out = mine.rooms.emplace_back(question.bytes, blank_again, behind, Fenced::wide_margin).data();
    mine.sizes.reserve(k + 1);
    if (!caller.call_in_thread(own, mine)) return;
  }
  mine.left.signals = caller.signals_changed();
}

}  // namespace

TwoAnswers answers_from_threads(const Caller& caller, const ThreadQuestion& here, const ThreadQuestion& there,
                                const Rounds& rounds, std::uint64_t element) {
  TwoAnswers answers;
  if (caller.is_single_threaded()) return answers;
  std::atomic<int> ready = 0;
  const auto ask_within_memory = [&](const ThreadQuestion& question, Answers& mine) {
    try {
      ask(caller, question, rounds, ready, mine);
    } catch (const std::bad_alloc&) {
      mine.lacks_memory = true;
    }
  };
  std::thread other([&] {
    // This thread may run anywhere: on the process's own processor the two threads would take turns.
    sched_setaffinity(0, sizeof caller.processors(), &caller.processors());
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
    caller.check_left(mine.left, element, "in a thread");
    for (const Fenced& room : mine.rooms) caller.check_fence(room, element);
  }
  return answers;
}

void ask_from_threads(const Caller& caller, const ThreadQuestion& here, const ThreadQuestion& there,
                      const Rounds& rounds, std::uint64_t element) {
  for (const TwoAnswers answers = answers_from_threads(caller, here, there, rounds, element);
       const Answers& one : answers) {
    if (one.threw) caller.stop(Outcome::threw, element, "when called from two threads at once");
    for (std::size_t round = 0; round < one.sizes.size(); ++round)
      (&one == answers.data() ? here : there).see(one.in_round(round), one.sizes[round]);
  }
}

void ask_turned_from_threads(const Caller& caller, const Question& question, const Rounds& rounds,
                             const std::string& how) {
  const Order order = turned_by_half(question.arguments.count);
  QuestionCopy there = rearranged(question.arguments, caller.entry().signature, order);
  there.answer = gathered(question.answer, caller.entry().answer_bytes, order);
  const auto sees = [&](const std::byte* right) {
    return [&, right](const std::byte* theirs, std::uint64_t) {
      caller.compare(right, theirs, order.size(), question.element, how);
    };
  };
  ask_from_threads(caller, {question.arguments, question.bytes, sees(question.answer)},
                   {there.arguments, question.bytes, sees(there.answer.data())}, rounds, question.element);
}

}  // namespace mmverify::dock
