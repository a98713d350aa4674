// Batches of every small size, and elements in a blob: tests the remainder after a vector's last whole one,
// and effects of one element on another.
#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include "subjects/dock/desk/desk.hpp"
#include "subjects/dock/other_formats.hpp"

namespace mmverify::dock {
namespace {

/// One more than the bytes of the longest vector, 64: covers each remainder, with and without a whole vector
/// before it.
constexpr std::size_t largest_small = 65;
/// The number of questions of a kind whose elements are asked in each size, and alone.
constexpr std::uint32_t first_in_sizes = 2;
/// The same of those whose elements are asked in the orders of callers.
constexpr std::uint32_t first_in_orders = 8;

std::string in_batches_of(std::size_t size) { return "asked in a batch of " + std::to_string(size); }

/// `size` numbers below `count`, from `from` on, cyclically.
std::vector<std::size_t> some(std::size_t from, std::size_t size, std::size_t count) {
  std::vector<std::size_t> order(size);
  for (std::size_t k = 0; k < size; ++k) order[k] = (from + k) % count;
  return order;
}

/// The numbers below `count`, from the last to the first.
std::vector<std::size_t> descending(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.rbegin(), order.rend(), std::size_t{0});
  return order;
}

/// The even numbers below `count`, then the odd ones.
std::vector<std::size_t> by_twos(std::size_t count) {
  const std::size_t evens = (count + 1) / 2;
  std::vector<std::size_t> order(count);
  for (std::size_t k = 0; k < count; ++k) order[k] = k < evens ? 2 * k : 2 * (k - evens) + 1;
  return order;
}

/// Runs of one number each: of more than 8 bits count, and of no multiple of a vector's length.
std::vector<std::size_t> long_runs(std::size_t count) {
  constexpr std::size_t length = 300, most_runs = 8;
  const std::size_t runs = std::min(most_runs, count);
  std::vector<std::size_t> order;
  for (std::size_t run = 0; run < runs; ++run)
    order.insert(order.end(), length + run, (count - 1) * (run + 1) / runs);
  return order;
}

/// Orders that a caller may have, each with its name.
struct Order {
  std::vector<std::size_t> order;
  const char* how;
};
std::array<Order, 3> orders_of_callers(std::size_t count) {
  return {{{descending(count), "asked in descending order"},
           {by_twos(count), "asked by twos, every other one first"},
           {long_runs(count), "asked in runs of more than 256 equal ones"}}};
}

/// All pairs of different numbers below `count`, one after the other.
std::vector<std::size_t> each_after_each(std::size_t count) {
  std::vector<std::size_t> order;
  for (std::size_t a = 1; a < count; ++a)
    for (std::size_t b = 0; b < a; ++b) order.insert(order.end(), {a, b});
  return order;
}

}  // namespace

void Desk::ask_slot_elements(std::size_t slot, const std::vector<std::size_t>& order,
                             const std::string& how) {
  const std::size_t from = slot * batch_size, wide = asked().answer_bytes,
                    bytes = asked().signature.number_bytes;
  if (order.empty()) return;
  Arguments a = piece(slot, 0, order.size(), nullptr);
  std::vector<std::byte> inputs[most_arrays];
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array] = gathered(a.arrays[array], bytes, order.size(), [&](std::size_t k) { return order[k]; });
    a.arrays[array] = inputs[array].data();
  }
  // The output ends at a guard page, which stops a store of a whole vector over the tail.
  a.out = blob_answer(order.size() * wide);
  set_canary(a.out);
  std::memset(a.out, blank_again, order.size() * wide);
  guarded(a, from);
  check_canary(a.out, from);
  for (std::size_t k = 0; k < order.size(); ++k)
    compare(slot_answer(slot) + order[k] * wide, a.out + k * wide, 1, from + order[k], how);
}

void Desk::ask_slot_in_each_size(std::size_t slot) {
  const std::size_t count = in_slot(mailbox_.count, slot);
  std::size_t at = 0;
  for (std::size_t size = 1; size <= largest_small; at += size++)
    ask_slot_elements(slot, some(at, size, count), in_batches_of(size));
}

void Desk::ask_slot_in_orders_of_callers(std::size_t slot) {
  for (const Order& one : orders_of_callers(in_slot(mailbox_.count, slot)))
    ask_slot_elements(slot, one.order, one.how);
}

void Desk::ask_blob_elements(const std::uint8_t* blob, const std::vector<std::size_t>& order,
                             const std::string& how) {
  const auto [in, out] = elements_in_blob(mailbox_.call);
  const std::size_t bytes = asked().signature.number_bytes, wide = in != 0 ? out : asked().answer_bytes,
                    size = order.size() * wide;
  const auto of = [&](std::size_t k) { return order[k]; };
  std::byte* const answers = blob_answer(size);
  Arguments a = whole(answers, size);
  a.blob = blob;
  a.count = order.size();
  std::vector<std::byte> inputs[most_arrays], elements;
  for (std::size_t array = 0; array < asked().signature.arrays; ++array) {
    inputs[array] = gathered(a.arrays[array], bytes, order.size(), of);
    a.arrays[array] = inputs[array].data();
  }
  if (in != 0) {
    elements = gathered(reinterpret_cast<const std::byte*>(blob), in, order.size(), of);
    a.blob = reinterpret_cast<const std::uint8_t*>(elements.data());
    a.blob_bytes = elements.size();
  }
  set_canary(answers);
  std::memset(answers, blank_again, size);
  guarded(a, 0);
  check_canary(answers, 0);
  for (std::size_t k = 0; k < order.size(); ++k)
    compare(again_.data() + order[k] * wide, answers + k * wide, wide, order[k] * wide, how);
}

std::size_t Desk::elements_of_blob() const {
  if (const auto [in, out] = elements_in_blob(mailbox_.call); in != 0)
    return std::min(batch_size, static_cast<std::size_t>(mailbox_.room) / out);
  const bool looked_up = asked().signature.arrays != 0 && mailbox_.room == mailbox_.count;
  return looked_up && mailbox_.blob_bytes <= longest_code ? static_cast<std::size_t>(mailbox_.count) : 0;
}

void Desk::ask_blob_in_each_size(const std::uint8_t* blob) {
  const std::size_t count = elements_of_blob();
  if (count == 0) return;
  if (mailbox_.asked_before < first_in_sizes) {
    std::size_t at = 0;
    for (std::size_t size = 1; size <= largest_small; at += size++)
      ask_blob_elements(blob, some(at, size, count), in_batches_of(size));
    if (count < odd_batch) {
      std::vector<std::size_t> order(odd_batch);
      for (std::size_t k = 0; k < odd_batch; ++k) order[k] = element_over_and_over(k, count);
      ask_blob_elements(blob, order, in_batches_of(odd_batch));
    }
  }
  if (mailbox_.asked_before < first_in_orders)
    for (const Order& one : orders_of_callers(count)) ask_blob_elements(blob, one.order, one.how);
  std::size_t stride = count * 618 / 1000 + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  std::vector<std::size_t> order(count);
  for (std::size_t k = 0; k < count; ++k) order[k] = k * stride % count;
  ask_blob_elements(blob, order, "asked in another order");
  if (elements_in_blob(mailbox_.call).bytes != 0 && mailbox_.asked_before == 0) ask_codes_after_each_other();
  // Puts the answer back into its place, where later questions expect it.
  std::copy(again_.begin(), again_.end(), blob_answer(mailbox_.room));
}

void Desk::ask_codes_after_each_other() {
  constexpr std::size_t codes = 256;
  const std::size_t in = elements_in_blob(mailbox_.call).bytes,
                    out = elements_in_blob(mailbox_.call).answer_bytes;
  // Each byte of an element takes all values, since its step is odd, and bytes have different steps.
  std::vector<std::byte> elements(codes * in);
  for (std::size_t k = 0; k < elements.size(); ++k)
    elements[k] = static_cast<std::byte>(k / in * (2 * (k % in) + 1) + k % in);
  const auto ask = [&](const std::byte* of, std::size_t count, Fenced& answers) {
    Arguments a = whole(nullptr, count * out);
    a.blob = reinterpret_cast<const std::uint8_t*>(of);
    a.blob_bytes = count * in;
    guarded(a, answers, 0);
  };
  std::vector<std::byte> alone;
  for (std::size_t k = 0; k < codes; ++k) {
    Fenced one(out, blank_again);
    ask(elements.data() + k * in, 1, one);
    alone.insert(alone.end(), one.data(), one.data() + out);
  }
  const std::vector<std::size_t> order = each_after_each(codes);
  const auto of = [&](std::size_t k) { return order[k]; };
  Fenced together(order.size() * out, blank_again);
  ask(gathered(elements.data(), in, order.size(), of).data(), order.size(), together);
  const std::vector<std::byte> expected = gathered(alone.data(), out, order.size(), of);
  compare(expected.data(), together.data(), expected.size(), 0,
          "asked with other codes, each alone and then after each other one");
}

}  // namespace mmverify::dock
