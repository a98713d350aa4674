// Questions that are repeated, or kept for later ones, with their answers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "subjects/dock/desk/arguments.hpp"
#include "subjects/dock/desk/fenced.hpp"
#include "subjects/dock/desk/left.hpp"
#include "subjects/dock/layout.hpp"

namespace mmverify::dock {

/// More elements than 16 bits count, and no multiple of a vector's length.
constexpr std::size_t odd_batch = large_batch_size + 7;

/// The longest code, in bytes, whose lookups are repeated: a lookup in a longer one takes more time.
constexpr std::uint64_t longest_code = 512;

/// A question and its right answer.
struct Question {
  Arguments arguments;  ///< without an output
  const std::byte* answer;
  std::size_t bytes;      ///< of the answer
  std::uint64_t size;     ///< the result of the call
  std::uint64_t element;  ///< the element to blame
};

/// A question with copies of its inputs and of its right answer.
struct QuestionCopy {
  Arguments arguments{};
  std::vector<std::byte> blob, arrays[most_arrays], answer;
  std::uint64_t size = 0;  ///< the result of the call
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

using Order = std::vector<std::size_t>;

/// The elements of `bytes` bytes each, with element order[k] at place k.
inline std::vector<std::byte> gathered(const std::byte* elements, std::size_t bytes, const Order& order) {
  std::vector<std::byte> all(order.size() * bytes);
  for (std::size_t k = 0; k < order.size(); ++k)
    std::memcpy(all.data() + k * bytes, elements + order[k] * bytes, bytes);
  return all;
}

/// The question with element order[k] of its arrays at place k.  It has no answer yet.
inline QuestionCopy rearranged(const Arguments& question, const Signature& signature, const Order& order) {
  QuestionCopy copy;
  copy.arguments = question;
  copy.arguments.count = order.size();
  for (std::size_t array = 0; array < signature.arrays; ++array) {
    copy.arrays[array] = gathered(question.arrays[array], signature.number_bytes, order);
    copy.arguments.arrays[array] = copy.arrays[array].data();
  }
  return copy;
}

/// `size` elements of `count`: all in order, then all from the second on, and so forth. If each turn began
/// with the first, places a power of two apart would have the same element.
Order over_and_over(std::size_t size, std::size_t count);
/// The numbers below `count` with a stride of about 0.618 of it, which separates neighbours.
Order far_apart(std::size_t count);
/// `count` numbers from half of it on, cyclically.
Order turned_by_half(std::size_t count);

}  // namespace mmverify::dock
