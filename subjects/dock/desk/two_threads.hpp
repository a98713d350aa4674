// Questions from two threads at once.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <string>

#include "subjects/dock/desk/caller.hpp"

namespace mmverify::dock {

constexpr char from_two_threads[] = "asked from two threads at once",
               first_from_two_threads[] = "asked from two threads at once, the first time at this level",
               in_another_kind[] = ", one of them at another level or in another format, order or mode";

/// The question of one of two threads. `see` gets each answer of up to `bytes` bytes, written over
/// `blank_again`.
struct ThreadQuestion {
  Arguments arguments;
  std::size_t bytes;
  std::function<void(const std::byte* answer, std::uint64_t size)> see;
};

using TwoAnswers = std::array<Answers, 2>;

/// The number of rounds in a thread: at least `least`, then more until `within` is over, up to `most`.
struct Rounds {
  std::size_t least = 2, most = 2;
  std::chrono::microseconds within{0};
};
/// Rounds for a level's first batch: a race shows only if one thread reads between two stores of the other.
constexpr Rounds often{2, 256, std::chrono::milliseconds(4)};

/// Two threads at once repeat a question each. Empty if the subject is single-threaded. A mode that is left
/// changed counts against `element`. Throws std::system_error if no thread can be started.
TwoAnswers answers_from_threads(const Caller& caller, const ThreadQuestion& here, const ThreadQuestion& there,
                                const Rounds& rounds, std::uint64_t element);
/// Asks from two threads and lets the questions see the answers. Exceptions count against `element`.
void ask_from_threads(const Caller& caller, const ThreadQuestion& here, const ThreadQuestion& there,
                      const Rounds& rounds, std::uint64_t element);
/// Repeats elements in two threads, one of them with the elements rotated by half their number.
void ask_turned_from_threads(const Caller& caller, const Question& question, const Rounds& rounds,
                             const std::string& how);

}  // namespace mmverify::dock
