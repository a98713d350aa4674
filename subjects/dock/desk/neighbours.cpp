// Repeats questions right after others that differ in one argument only: a cache that ignores an argument
// then gives a wrong answer.
#include <algorithm>
#include <span>
#include <string>
#include <unordered_map>

#include "subjects/dock/desk/desk.hpp"
#include "subjects/dock/other_formats.hpp"

namespace mmverify::dock {
namespace {

/// Elements of a batch that are searched for neighbours; elements that are repeated in another format;
/// elements that are tried, and pairs that are asked, for a bit.
constexpr std::size_t most_elements = 2048, most_in_another_format = 256, most_tried = 256, most_found = 32;
/// Questions on blobs that are kept for each level and format, and the most bytes of one.
constexpr std::size_t most_kept = 64, most_kept_bytes = 512;

/// The bytes of an element's numbers, array after array.
std::string numbers_of(const Arguments& a, std::size_t arrays, std::size_t bytes, std::size_t k) {
  std::string numbers;
  for (std::size_t array = 0; array < arrays; ++array)
    numbers.append(reinterpret_cast<const char*>(a.arrays[array]) + k * bytes, bytes);
  return numbers;
}

using Places = std::unordered_map<std::string, std::size_t>;

/// Adds pairs of elements to `order`: a neighbour, and then the element that differs from it in one bit.
void add_pairs_that_differ_in_a_bit(const std::vector<std::string>& numbers, const Places& places,
                                    std::vector<std::size_t>& order) {
  if (numbers.empty()) return;
  std::string varies(numbers[0].size(), '\0');
  for (const std::string& one : numbers)
    for (std::size_t b = 0; b < one.size(); ++b)
      varies[b] = static_cast<char>(varies[b] | (one[b] ^ numbers[0][b]));
  for (std::size_t bit = 0; bit < 8 * varies.size(); ++bit) {
    const auto flip = static_cast<char>(1u << bit % 8);
    if ((varies[bit / 8] & flip) == 0) continue;
    std::size_t left = most_found;
    // Elements are taken from all over the batch: the first ones may have no neighbour in it.
    const std::size_t step = std::max<std::size_t>(1, numbers.size() / most_tried);
    for (std::size_t k = bit % step; k < numbers.size() && left != 0; k += step) {
      std::string other = numbers[k];
      other[bit / 8] = static_cast<char>(other[bit / 8] ^ flip);
      if (const auto there = places.find(other); there != places.end()) {
        order.insert(order.end(), {there->second, k});
        --left;
      }
    }
  }
}

/// The same of elements that differ in one number.
void add_pairs_that_differ_in_a_number(const std::vector<std::string>& numbers, std::size_t arrays,
                                       std::size_t bytes, std::vector<std::size_t>& order) {
  for (std::size_t array = 0; array < arrays; ++array) {
    Places last;
    std::size_t left = most_tried;
    for (std::size_t k = 0; k < numbers.size() && left != 0; ++k) {
      std::string rest = numbers[k];
      rest.erase(array * bytes, bytes);
      const auto [same, is_new] = last.emplace(std::move(rest), k);
      if (!is_new && numbers[same->second] != numbers[k]) {
        order.insert(order.end(), {same->second, k});
        same->second = k;
        --left;
      }
    }
  }
}

}  // namespace

void Desk::ask_slot_after_neighbours(std::size_t slot) {
  const std::size_t arrays = asked().signature.arrays, bytes = asked().signature.number_bytes,
                    from = slot * batch_size, wide = asked().answer_bytes;
  if (arrays < 2) return;  // any two elements differ in one number
  const std::size_t count = std::min(in_slot(mailbox_.count, slot), most_elements);
  const Arguments a = piece(slot, 0, count, nullptr);
  std::vector<std::string> numbers;
  Places places;
  for (std::size_t k = 0; k < count; ++k) {
    numbers.push_back(numbers_of(a, arrays, bytes, k));
    places.emplace(numbers.back(), k);
  }
  std::vector<std::size_t> order;
  add_pairs_that_differ_in_a_bit(numbers, places, order);
  add_pairs_that_differ_in_a_number(numbers, arrays, bytes, order);
  constexpr char how[] = "asked after one that differs in one number";
  ask_slot_elements(slot, order, how);
  Fenced here(wide, blank_again);
  for (const std::size_t k : order) {
    guarded(piece(slot, k, 1, nullptr), here, from + k);
    compare(slot_answer(slot) + k * wide, here.data(), 1, from + k, how);
  }
}

void Desk::ask_slot_after_another_format(std::size_t slot) {
  if (mailbox_.this_level_alone != 0) return;
  constexpr char how[] = "asked after the same in another format, order or mode";
  const std::size_t count = std::min(in_slot(mailbox_.count, slot), most_in_another_format),
                    from = slot * batch_size, wide = asked().answer_bytes;
  // Asks `what`, which has another format, then repeats the elements from `at` on.
  const auto ask_after = [&](const Arguments& what, std::size_t at) {
    Fenced there(what.count * wide, blank), here(what.count * wide, blank_again);
    mailbox_.another_level.store(1, std::memory_order_relaxed);
    guarded(what, there, from + at);
    mailbox_.another_level.store(0, std::memory_order_relaxed);
    guarded(piece(slot, at, what.count, nullptr), here, from + at);
    compare(slot_answer(slot) + at * wide, here.data(), what.count, from + at, how);
  };
  for (const std::uint32_t other : other_formats(mailbox_.call, mailbox_.level, mailbox_.format)) {
    const auto with_other = [&](std::size_t at, std::size_t size) {
      Arguments what = piece(slot, at, size, nullptr);
      what.format = other;
      return what;
    };
    ask_after(with_other(0, count), 0);
    for (std::size_t at = 0; at < count; ++at) ask_after(with_other(at, 1), at);
  }
  ask_slot_after_kept_formats(slot, ask_after);
}

void Desk::ask_slot_after_kept_formats(std::size_t slot,
                                       const std::function<void(const Arguments&, std::size_t)>& ask_after) {
  const std::size_t arrays = asked().signature.arrays, bytes = asked().signature.number_bytes,
                    count = in_slot(mailbox_.count, slot);
  const Arguments whole_slot = piece(slot, 0, count, nullptr);
  Places places;
  for (std::uint32_t other = 0; other < formats; ++other) {
    const std::optional<Batch>& kept = level_before_[static_cast<std::size_t>(mailbox_.call)][other];
    if (other == mailbox_.format % formats || !kept || kept->level != mailbox_.level) continue;
    for (std::size_t k = 0; places.empty() && k < count; ++k)
      places.emplace(numbers_of(whole_slot, arrays, bytes, k), k);
    Arguments before = whole_slot;
    before.format = other;
    before.count = 1;
    for (std::size_t k = 0; (k + 1) * bytes <= kept->arrays[0].size(); ++k) {
      for (std::size_t array = 0; array < arrays; ++array)
        before.arrays[array] = kept->arrays[array].data() + k * bytes;
      if (const auto same = places.find(numbers_of(before, arrays, bytes, 0)); same != places.end())
        ask_after(before, same->second);
    }
  }
}

void Desk::ask_blob_after_another_format(const std::uint8_t* blob, std::uint64_t size) {
  const std::uint64_t room = mailbox_.room;
  const std::span<const std::uint8_t> bytes(blob, static_cast<std::size_t>(mailbox_.blob_bytes));
  for (const std::uint32_t other : other_formats(mailbox_.call, mailbox_.level, mailbox_.format)) {
    const std::vector<std::uint8_t> same = as_of_format(mailbox_.call, mailbox_.level, other, bytes);
    Fenced answer(2 * static_cast<std::size_t>(std::max(room, size)), blank);
    Arguments before = whole(nullptr, asked().signature.sizes_answer ? answer.size() : room);
    before.format = other;
    // Something else comes first: otherwise a cache still has this question's answer, and gives it for the
    // other format. It is a code of no bytes, or the inverted bytes; an inverted array is invalid, so arrays
    // go without.
    const bool of_code = mailbox_.call == Call::tree_decode || mailbox_.call == Call::dag_decode;
    std::vector<std::uint8_t> inverted(bytes.begin(), bytes.end());
    for (std::uint8_t& byte : inverted) byte = static_cast<std::uint8_t>(~byte);
    const std::vector<std::uint8_t> unlike = as_of_format(mailbox_.call, mailbox_.level, other, inverted);
    before.blob = unlike.data();
    if (of_code) before.blob_bytes = 0;
    if (mailbox_.call != Call::array_save) guarded(before, answer, 0);
    before.blob = same.data();
    before.blob_bytes = bytes.size();
    ask_blob_after(before, answer, blob, size, "asked after the same bytes in another format, order or mode");
  }
}

void Desk::ask_blob_after_kept_formats(const std::uint8_t* blob, std::uint64_t size) {
  if (mailbox_.format == 0 || mailbox_.blob_bytes > most_kept_bytes) return;
  const auto of = [this](std::uint32_t format) -> std::deque<Question>& {
    return kept_[{static_cast<std::uint32_t>(mailbox_.call), mailbox_.level, format}];
  };
  const std::span<const std::uint8_t> here(blob, static_cast<std::size_t>(mailbox_.blob_bytes));
  const auto is_here = [&](const Question& q) {
    return std::equal(q.blob.begin(), q.blob.end(), here.begin(), here.end(),
                      [](std::byte a, std::uint8_t b) { return a == std::byte{b}; });
  };
  for (const std::uint32_t other : {MMVERIFY_2_STATE, MMVERIFY_4_STATE}) {
    if (other == mailbox_.format) continue;
    for (const std::deque<Question>& all = of(other); const Question& q : all) {
      if (&q != &all.back() && !is_here(q)) continue;
      Fenced answer(q.answer.size(), blank_again);
      if (guarded(q.arguments, answer, 0) != q.size ||
          (q.size != 0 && !std::equal(q.answer.begin(), q.answer.end(), answer.data())))
        stop(Outcome::non_deterministic, 0,
             "a question in another format, asked before, was answered otherwise after this one");
      ask_blob_after(q.arguments, answer, blob, size, "asked after a question in another format");
    }
  }
  std::deque<Question>& mine = of(mailbox_.format);
  if (mine.size() >= most_kept) mine.pop_back();  // replaces the last one
  mine.push_back(this_question(size));
}

}  // namespace mmverify::dock
