// Questions that are repeated from threads or kept for later, with their answers.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <vector>

#include "subjects/dock/desk/arguments.hpp"
#include "subjects/dock/desk/fenced.hpp"
#include "subjects/dock/layout.hpp"

namespace mmverify::dock {

/// More elements than 16 bits count, and no multiple of a vector's length.
constexpr std::size_t odd_batch = large_batch_size + 7;

/// The element, of `count`, at place k of a longer batch: all in order, then all from the second on, and so
/// forth. If each turn began with the first, places a power of two apart would have the same element.
constexpr std::size_t element_over_and_over(std::size_t k, std::size_t count) {
  return (k + k / count) % count;
}

/// `count` elements of `bytes` bytes each: at place k the element of(k).
template <class Of>
std::vector<std::byte> gathered(const std::byte* elements, std::size_t bytes, std::size_t count, Of of) {
  std::vector<std::byte> all(count * bytes);
  for (std::size_t k = 0; k < count; ++k)
    std::memcpy(all.data() + k * bytes, elements + of(k) * bytes, bytes);
  return all;
}

/// The longest code, in bytes, whose lookups are repeated: a lookup in a longer one takes more time.
constexpr std::uint64_t longest_code = 512;

constexpr char asked_from_threads[] = "asked from two threads at once",
               in_another_kind[] = ", one of them at another level or in another format, order or mode";

/// The question of one of two threads. `see` gets each answer of up to `bytes` bytes, written over
/// `blank_again`.
struct Asked {
  Arguments arguments;
  std::size_t bytes;
  std::function<void(const std::byte* answer, std::uint64_t size)> see;
};

/// Changes that a thread's calls left behind.
struct Left {
  std::optional<std::uint64_t> mode;  ///< the floating-point mode
  bool registers = false;             ///< values in x87 or MMX registers
  bool signals = false;               ///< the signal mask
};

/// The answers that a thread got, round by round.
struct Answers {
  std::vector<Fenced> rooms;
  std::vector<std::uint64_t> sizes;
  bool threw = false, lacks_memory = false;
  Left left;
  std::size_t first_address = 0, value_bytes = 1;  ///< answers take each place in turn
  const std::byte* in_round(std::size_t round) const { return rooms[round].data(); }
};

using FromThreads = std::array<Answers, 2>;

/// The number of rounds in a thread: at least `least`, then more until `within` is over, up to `most`.
struct Rounds {
  std::size_t least = 2, most = 2;
  std::chrono::microseconds within{0};
};

/// A question on a blob, with its answer.
struct KeptQuestion {
  Arguments arguments{};
  std::vector<std::byte> blob, arrays[most_arrays], answer;
  std::uint64_t size = 0;  ///< the result of the call
};

}  // namespace mmverify::dock
