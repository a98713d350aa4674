// Asks with one array for two inputs that hold the same numbers: nothing forbids a caller to do so.
#include <algorithm>
#include <cstring>
#include <string>

#include "subjects/dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

constexpr char with_one_array[] = "asked with one array for inputs that are equal";
/// Elements that are asked so at once.
constexpr std::size_t most_equal = 512;
/// The number of questions of a kind that are.
constexpr std::uint32_t first_with_one_array = 8;

/// The number of arrays before those that may be one: a lookup's maps are no barycentrics.
std::size_t before_like_arrays(const Signature& signature) {
  constexpr std::size_t u_and_v = 2;
  return signature.of_points ? signature.arrays - u_and_v : 0;
}

/// The sets of arrays that may be one: all pairs, and all of three.
std::vector<std::vector<std::size_t>> like_arrays(const Signature& signature) {
  std::vector<std::vector<std::size_t>> sets;
  const std::size_t first = before_like_arrays(signature);
  for (std::size_t a = first; a < signature.arrays; ++a)
    for (std::size_t b = a + 1; b < signature.arrays; ++b) sets.push_back({a, b});
  if (signature.arrays - first == 3) sets.push_back({first, first + 1, first + 2});
  return sets;
}

/// The first elements whose numbers in all arrays of `same` are equal.
std::vector<std::size_t> elements_with_equal(const Arguments& a, const std::vector<std::size_t>& same,
                                             std::size_t bytes) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < a.count && found.size() < most_equal; ++k)
    if (std::all_of(same.begin(), same.end(), [&](std::size_t array) {
          return std::memcmp(a.arrays[same[0]] + k * bytes, a.arrays[array] + k * bytes, bytes) == 0;
        }))
      found.push_back(k);
  return found;
}

/// Coordinates of `floats` or doubles, whose (u, u) is a point, too.
bool is_up_to_a_half(const std::byte* number, bool floats) {
  if (floats) {
    float u = 0;
    std::memcpy(&u, number, sizeof u);
    return u <= 0.5f;
  }
  double u = 0;
  std::memcpy(&u, number, sizeof u);
  return u <= 0.5;
}

}  // namespace

void Desk::ask_with_one_array(const Arguments& question, const std::vector<std::size_t>& same,
                              const std::vector<std::size_t>& order, const std::byte* right,
                              std::uint64_t from) {
  const std::size_t bytes = asked().signature.number_bytes, wide = asked().answer_bytes;
  if (order.empty()) return;
  Arguments a = question;
  a.count = order.size();
  if (asked().signature.of_blob) a.room = order.size();
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array] =
        gathered(question.arrays[array], bytes, order.size(), [&](std::size_t k) { return order[k]; });
    a.arrays[array] = inputs[array].data();
  }
  for (const std::size_t array : same) a.arrays[array] = a.arrays[same[0]];
  Fenced out(order.size() * wide, blank_again);
  guarded(a, out, from);
  const std::vector<std::byte> expected =
      gathered(right, wide, order.size(), [&](std::size_t k) { return order[k]; });
  compare(expected.data(), out.data(), order.size(), from, with_one_array);
}

void Desk::ask_diagonal_with_one_array(Arguments question, std::size_t first) {
  const std::size_t bytes = asked().signature.number_bytes, wide = asked().answer_bytes;
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < question.count && order.size() < most_equal; ++k)
    if (is_up_to_a_half(question.arrays[first] + k * bytes, bytes == sizeof(float))) order.push_back(k);
  if (order.empty()) return;
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    const std::byte* const numbers = question.arrays[std::min(array, first)];
    inputs[array] = gathered(numbers, bytes, order.size(), [&](std::size_t k) { return order[k]; });
  }
  for (std::size_t array = 0; array < asked().signature.arrays; ++array)
    question.arrays[array] = inputs[array].data();
  question.count = order.size();
  Fenced with_two(order.size() * wide, blank), with_one(order.size() * wide, blank_again);
  // The law need not ask these points: a crash on them is none of its cases.
  mailbox_.another_level.store(1, std::memory_order_relaxed);
  guarded(question, with_two, 0);
  question.arrays[first + 1] = question.arrays[first];
  guarded(question, with_one, 0);
  mailbox_.another_level.store(0, std::memory_order_relaxed);
  compare(with_two.data(), with_one.data(), order.size(), mailbox_.count, with_one_array);
}

void Desk::ask_slot_with_one_array(std::size_t slot) {
  const Signature& signature = asked().signature;
  const Arguments a = piece(slot, 0, in_slot(mailbox_.count, slot), nullptr);
  for (const std::vector<std::size_t>& same : like_arrays(signature))
    ask_with_one_array(a, same, elements_with_equal(a, same, signature.number_bytes), slot_answer(slot),
                       slot * batch_size);
  if (signature.of_points && mailbox_.this_level_alone == 0)
    ask_diagonal_with_one_array(a, before_like_arrays(signature));
}

void Desk::ask_blob_with_one_array(const std::uint8_t* blob) {
  const Signature& signature = asked().signature;
  if (signature.arrays < 2 || mailbox_.asked_before >= first_with_one_array) return;
  Arguments a = whole(nullptr, again_.size());
  a.blob = blob;
  for (const std::vector<std::size_t>& same : like_arrays(signature))
    ask_with_one_array(a, same, elements_with_equal(a, same, signature.number_bytes), again_.data(), 0);
}

}  // namespace mmverify::dock
