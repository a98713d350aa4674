// Asks with one array for two inputs that hold the same numbers: nothing forbids a caller to do so.
#include <algorithm>
#include <cstring>

#include "subjects/dock/desk/provocations.hpp"

namespace mmverify::dock {
namespace {

constexpr char with_one[] = "asked with one array for inputs that are equal";
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
Order elements_with_equal(const Arguments& a, const std::vector<std::size_t>& same, std::size_t bytes) {
  Order found;
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

/// Asks elements that are equal in all arrays of `same` with one array for these.
void ask_with_one(const Caller& caller, const Question& question, const std::vector<std::size_t>& same) {
  const Signature& signature = caller.entry().signature;
  const std::size_t wide = caller.entry().answer_bytes;
  const Order order = elements_with_equal(question.arguments, same, signature.number_bytes);
  if (order.empty()) return;
  QuestionCopy copy = rearranged(question.arguments, signature, order);
  copy.arguments.room = order.size() * wide;
  for (const std::size_t array : same) copy.arguments.arrays[array] = copy.arguments.arrays[same[0]];
  Fenced out(order.size() * wide, blank_again);
  caller.guarded(copy.arguments, out, question.element);
  caller.compare_in_order(question.answer, out.data(), wide, order, question.element, with_one);
}

/// Asks points (u, u) with two arrays and with one.
void ask_diagonal(const Batch& batch) {
  const Signature& signature = batch.signature();
  const std::size_t first = before_like_arrays(signature), bytes = signature.number_bytes;
  Arguments points = batch.piece(0, batch.count());
  Order order;
  for (std::size_t k = 0; k < points.count && order.size() < most_equal; ++k)
    if (is_up_to_a_half(points.arrays[first] + k * bytes, bytes == sizeof(float))) order.push_back(k);
  if (order.empty()) return;
  points.arrays[first + 1] = points.arrays[first];
  QuestionCopy copy = rearranged(points, signature, order);
  Fenced with_two(order.size() * batch.answer_bytes(), blank),
      with_one_for_both(order.size() * batch.answer_bytes(), blank_again);
  batch.caller.guarded_beyond(copy.arguments, with_two, 0);
  copy.arguments.arrays[first + 1] = copy.arguments.arrays[first];
  batch.caller.guarded_beyond(copy.arguments, with_one_for_both, 0);
  batch.caller.compare(with_two.data(), with_one_for_both.data(), order.size(), batch.caller.mailbox().count,
                       with_one);
}

}  // namespace

void with_one_array(const Batch& batch) {
  for (const std::vector<std::size_t>& same : like_arrays(batch.signature()))
    ask_with_one(batch.caller, batch.whole(), same);
  if (batch.signature().of_points && batch.caller.mailbox().this_level_alone == 0) ask_diagonal(batch);
}

void with_one_array(const Blob& blob) {
  if (blob.signature().arrays < 2 || blob.before() >= first_with_one_array) return;
  for (const std::vector<std::size_t>& same : like_arrays(blob.signature()))
    ask_with_one(blob.caller, blob.question(), same);
}

}  // namespace mmverify::dock
