// Batches in other orders and sizes: the remainder after a vector's last whole one, and effects of one element on
// another.
#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include "subjects/dock/desk/provocations.hpp"
#include "subjects/dock/desk/two_threads.hpp"
#include "subjects/dock/other_formats.hpp"

namespace mmverify::dock {
namespace {

/// One more than the bytes of the longest vector, 64: covers each remainder, with and without a whole vector
/// before it.
constexpr std::size_t largest_small = 65;
/// The number of questions of a kind whose elements are asked in each size, and alone.
constexpr std::uint32_t first_in_sizes = 2;
/// The same for the orders of callers.
constexpr std::uint32_t first_in_orders = 8;

std::string in_batches_of(std::size_t size) { return "asked in a batch of " + std::to_string(size); }

/// `size` numbers below `count`, from `from` on, cyclically.
Order some(std::size_t from, std::size_t size, std::size_t count) {
  Order order(size);
  for (std::size_t k = 0; k < size; ++k) order[k] = (from + k) % count;
  return order;
}

/// The numbers below `count`, from the last to the first.
Order descending(std::size_t count) {
  Order order(count);
  std::iota(order.rbegin(), order.rend(), std::size_t{0});
  return order;
}

/// The even numbers below `count`, then the odd ones.
Order by_twos(std::size_t count) {
  const std::size_t evens = (count + 1) / 2;
  Order order(count);
  for (std::size_t k = 0; k < count; ++k) order[k] = k < evens ? 2 * k : 2 * (k - evens) + 1;
  return order;
}

/// Runs of one number each: of more than 8 bits count, and of no multiple of a vector's length.
Order long_runs(std::size_t count) {
  constexpr std::size_t length = 300, most_runs = 8;
  const std::size_t runs = std::min(most_runs, count);
  Order order;
  for (std::size_t run = 0; run < runs; ++run)
    order.insert(order.end(), length + run, (count - 1) * (run + 1) / runs);
  return order;
}

/// Runs of one number each, with another one inside.
Order runs_with_another_inside(std::size_t count) {
  Order order(count);
  for (std::size_t k = 0; k < count; ++k) {
    constexpr std::size_t lengths[] = {4, 8, 16, 64};
    const std::size_t length = lengths[4 * k / count], run = k / length;
    const bool odd = k % length == 1 + run % (length - 2);
    order[k] = (run * (length + 1) + (odd ? count / 2 + run : 0)) % count;
  }
  return order;
}

/// All pairs of different numbers below `count`, one after the other.
Order each_after_each(std::size_t count) {
  Order order;
  for (std::size_t a = 1; a < count; ++a)
    for (std::size_t b = 0; b < a; ++b) order.insert(order.end(), {a, b});
  return order;
}

/// Orders that a caller may have, each with its name.
struct NamedOrder {
  Order order;
  const char* how;
};
std::array<NamedOrder, 3> orders_of_callers(std::size_t count) {
  return {{{descending(count), "asked in descending order"},
           {by_twos(count), "asked by twos, every other one first"},
           {long_runs(count), "asked in runs of more than 256 equal ones"}}};
}

/// Calls visit(order, how) for each size up to largest_small.
template <class Visit>
void for_each_size(std::size_t count, Visit visit) {
  std::size_t at = 0;
  for (std::size_t size = 1; size <= largest_small; at += size++)
    visit(some(at, size, count), in_batches_of(size));
}

/// Asks the elements in an order, then from two threads.
void ask_rearranged(const Batch& batch, const Order& order, const std::string& how) {
  const QuestionCopy copy = batch.ask(order, how);
  // Alternating distant neighbours change shared memory with every element.
  if (batch.slot == 0)
    ask_turned_from_threads(batch.caller,
                            {copy.arguments, copy.answer.data(), copy.answer.size(), 0, batch.first()}, often,
                            how + ", from two threads at once");
}

/// Asks elements of a blob in an order, with the answers at a guard page.
void ask_elements(const Blob& blob, const Order& order, const std::string& how) {
  const auto [in, out] = elements_in_blob(blob.caller.mailbox().call);
  const std::size_t wide = in != 0 ? out : blob.caller.entry().answer_bytes, size = order.size() * wide;
  QuestionCopy copy = rearranged(blob.arguments(blob.bytes, size), blob.signature(), order);
  if (in != 0) {
    copy.blob = gathered(reinterpret_cast<const std::byte*>(blob.bytes), in, order);
    copy.arguments.blob = reinterpret_cast<const std::uint8_t*>(copy.blob.data());
    copy.arguments.blob_bytes = copy.blob.size();
  }
  blob.caller.guarded_at_page(copy.arguments, size, blank_again, 0);
  blob.caller.compare_in_order(blob.answer.data(), blob.caller.at_guard_page(size), wide, order, 0, how);
}

/// The number of elements that are looked up in a short code, or that lie in the blob itself; else 0.
std::size_t elements_of(const Blob& blob) {
  if (const auto [in, out] = elements_in_blob(blob.caller.mailbox().call); in != 0)
    return std::min(batch_size, static_cast<std::size_t>(blob.room()) / out);
  const std::uint64_t count = blob.caller.mailbox().count;
  const bool looked_up = blob.signature().arrays != 0 && blob.room() == count;
  return looked_up && blob.blob_bytes() <= longest_code ? static_cast<std::size_t>(count) : 0;
}

/// Asks elements with every value in each byte, alone and then each right after each other one. Domain: any
/// bytes are an element.
void ask_codes_after_each_other(const Blob& blob) {
  constexpr std::size_t codes = 256;
  const auto [in, out] = elements_in_blob(blob.caller.mailbox().call);
  // Each byte of an element takes all values, since its step is odd, and bytes have different steps.
  std::vector<std::byte> elements(codes * in);
  for (std::size_t k = 0; k < elements.size(); ++k)
    elements[k] = static_cast<std::byte>(k / in * (2 * (k % in) + 1) + k % in);
  const auto ask = [&, out = out, in = in](const std::byte* first, std::size_t count, Fenced& answers) {
    Arguments a = blob.arguments(reinterpret_cast<const std::uint8_t*>(first), count * out);
    a.blob_bytes = count * in;
    blob.caller.guarded(a, answers, 0);
  };
  std::vector<std::byte> alone;
  for (std::size_t k = 0; k < codes; ++k) {
    Fenced one(out, blank_again);
    ask(elements.data() + k * in, 1, one);
    alone.insert(alone.end(), one.data(), one.data() + out);
  }
  const Order order = each_after_each(codes);
  Fenced together(order.size() * out, blank_again);
  ask(gathered(elements.data(), in, order).data(), order.size(), together);
  const std::vector<std::byte> expected = gathered(alone.data(), out, order);
  blob.caller.compare(expected.data(), together.data(), expected.size(), 0,
                      "asked with other codes, each alone and then after each other one");
}

}  // namespace

void in_another_order(const Batch& batch) {
  ask_rearranged(batch, far_apart(batch.count()), "asked in another order");
}

void in_runs(const Batch& batch) {
  ask_rearranged(batch, runs_with_another_inside(batch.count()),
                 "asked in runs of one element with another one inside");
}

void in_each_size(const Batch& batch) {
  for_each_size(batch.count(),
                [&](const Order& order, const std::string& how) { batch.ask_at_page(order, how); });
}

void in_orders_of_callers(const Batch& batch) {
  for (const NamedOrder& one : orders_of_callers(batch.count())) batch.ask_at_page(one.order, one.how);
}

void many_times_over(const Batch& batch) {
  const std::string how = "asked in a batch of " + std::to_string(odd_batch);
  const QuestionCopy copy = batch.ask(over_and_over(odd_batch, batch.count()), how);
  ask_turned_from_threads(batch.caller,
                          {copy.arguments, copy.answer.data(), copy.answer.size(), 0, batch.first()}, {},
                          how + " from two threads at once");
}

void at_other_places(const Batch& batch) {
  const std::size_t count = batch.count(), bytes = batch.signature().number_bytes;
  // First all arrays begin at a line; then each is shifted by another number of elements.
  for (std::size_t turn = 0; turn < 4; ++turn) {
    const auto placed = [](std::vector<std::byte>& room, std::size_t size, std::size_t offset) {
      room.assign(size + 2 * line, std::byte{blank_again});
      return room.data() + before_line(room) + offset % line;
    };
    Question question = batch.whole();
    std::vector<std::byte> inputs[most_arrays];
    for (std::size_t array = 0; array < batch.signature().arrays; ++array) {
      std::byte* const copy = placed(inputs[array], count * bytes, turn * (array + 1) * bytes);
      std::memcpy(copy, question.arguments.arrays[array], count * bytes);
      question.arguments.arrays[array] = copy;
    }
    Fenced again(question.bytes, blank_again,
                 turn * (most_arrays + 1) * batch.signature().value_bytes % line);
    batch.caller.guarded(question.arguments, again, batch.first());
    batch.caller.compare(batch.answers(), again.data(), count, batch.first(),
                         "asked with its arrays at other addresses");
  }
}

void in_each_size(const Blob& blob) {
  const std::size_t count = elements_of(blob);
  if (count == 0) return;
  const auto ask = [&](const Order& order, const std::string& how) { ask_elements(blob, order, how); };
  if (blob.before() < first_in_sizes) {
    for_each_size(count, ask);
    if (count < odd_batch) ask(over_and_over(odd_batch, count), in_batches_of(odd_batch));
  }
  if (blob.before() < first_in_orders)
    for (const NamedOrder& one : orders_of_callers(count)) ask(one.order, one.how);
  ask(far_apart(count), "asked in another order");
  if (elements_in_blob(blob.caller.mailbox().call).bytes != 0 && blob.before() == 0)
    ask_codes_after_each_other(blob);
}

}  // namespace mmverify::dock
