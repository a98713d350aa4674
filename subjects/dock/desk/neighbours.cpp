// Repeats questions right after others that differ in one argument only: a cache that ignores an argument
// then gives a wrong answer.
#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <unordered_map>

#include "subjects/dock/desk/provocations.hpp"
#include "subjects/dock/other_formats.hpp"

namespace mmverify::dock {
namespace {

/// Elements of a batch that are searched for neighbours; elements that are repeated in another format;
/// elements that are tried, and pairs that are asked, for a bit.
constexpr std::size_t most_elements = 2048, most_in_another_format = 256, most_tried = 256, most_found = 32;
/// Questions on blobs that are kept for each level and format, and the most bytes of one.
constexpr std::size_t most_kept = 64, most_kept_bytes = 512;
/// Elements of a batch that are repeated after one of the level before.
constexpr std::size_t most_after_the_level_before = 512;
constexpr char after_same_in_another_format[] = "asked after the same in another format, order or mode";

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
                                    Order& order) {
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
                                       std::size_t bytes, Order& order) {
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

/// Repeats elements right after the same at level `other`; an index is shifted right by less_bits.
void after_level(const Batch& batch, std::uint32_t other, unsigned less_bits) {
  Fenced there(batch.answer_bytes(), blank);
  for (std::size_t k = 0; k < std::min(batch.count(), batch.one_by_one); ++k) {
    Arguments before = batch.piece(k, 1);
    before.level = other;
    std::uint32_t index = 0;
    if (less_bits != 0) {
      std::memcpy(&index, before.arrays[0], sizeof index);
      index >>= less_bits;
      before.arrays[0] = reinterpret_cast<const std::byte*>(&index);
    }
    batch.caller.guarded_beyond(before, there, batch.first() + k);
    batch.ask_element(k, "asked after level " + std::to_string(other));
  }
}

std::uint32_t first_number(const std::byte* at) {
  std::uint32_t number = 0;
  std::memcpy(&number, at, sizeof number);
  return number;
}

/// Asks `what`, which has another format, then repeats the elements from `at` on.
void after_format(const Batch& batch, const Arguments& what, std::size_t at) {
  const std::size_t bytes = what.count * batch.answer_bytes(), element = batch.first() + at;
  Fenced there(bytes, blank), here(bytes, blank_again);
  batch.caller.guarded_beyond(what, there, element);
  batch.caller.guarded(batch.piece(at, what.count), here, element);
  batch.caller.compare(batch.answer(at), here.data(), what.count, element, after_same_in_another_format);
}

/// Repeats elements right after the same ones of batches that were kept in other formats.
void after_kept_formats(const Batch& batch) {
  const std::size_t arrays = batch.signature().arrays, bytes = batch.signature().number_bytes;
  const Mailbox& mailbox = batch.caller.mailbox();
  const Arguments whole = batch.piece(0, batch.count());
  Places places;
  for (std::uint32_t other = 0; other < formats; ++other) {
    const std::optional<WorkerMemory::Batch>& kept =
        batch.kept.level_before[batch.caller.entry_number()][other];
    if (other == mailbox.format % formats || !kept || kept->level != mailbox.level) continue;
    for (std::size_t k = 0; places.empty() && k < batch.count(); ++k)
      places.emplace(numbers_of(whole, arrays, bytes, k), k);
    Arguments before = batch.piece(0, 1);
    before.format = other;
    for (std::size_t k = 0; (k + 1) * bytes <= kept->arrays[0].size(); ++k) {
      for (std::size_t array = 0; array < arrays; ++array)
        before.arrays[array] = kept->arrays[array].data() + k * bytes;
      if (const auto same = places.find(numbers_of(before, arrays, bytes, 0)); same != places.end())
        after_format(batch, before, same->second);
    }
  }
}

/// The bytes with `change` done to those from `from` to `to`.
template <class Change>
std::vector<std::uint8_t> changed(std::span<const std::uint8_t> bytes, std::size_t from, std::size_t to,
                                  Change change) {
  std::vector<std::uint8_t> other(bytes.begin(), bytes.end());
  for (std::size_t k = from; k < to; ++k) other[k] = static_cast<std::uint8_t>(change(other[k], k));
  return other;
}
std::vector<std::uint8_t> inverted(std::span<const std::uint8_t> bytes, std::size_t from, std::size_t to) {
  return changed(bytes, from, to, [](std::uint8_t byte, std::size_t) { return ~byte; });
}

}  // namespace

void after_another_level(const Batch& batch) {
  const Caller& caller = batch.caller;
  if (caller.mailbox().this_level_alone != 0) return;
  const std::uint32_t level = caller.mailbox().level, last = caller.subject().max_level;
  // Three vertices of a face at one level need not be a face at another.
  if (caller.mailbox().call == Call::attribute_face_of) return;
  if (level < last) after_level(batch, level + 1, 0);
  if (batch.signature().of_points) {
    if (level == last && level != 0) after_level(batch, level - 1, 0);
    return;
  }
  // An index is valid at a lower level only if shortened: to the parent's index, or to its first digit.
  if (batch.signature().arrays != 1) return;
  if (level > 0) after_level(batch, level - 1, 2);
  if (level > 2) after_level(batch, 1, 2 * (level - 1));
}

void after_the_level_before(const Batch& batch) {
  const Signature& signature = batch.signature();
  const Mailbox& mailbox = batch.caller.mailbox();
  if (signature.arrays < 2 || signature.of_points || mailbox.this_level_alone != 0) return;
  const std::size_t bytes = signature.number_bytes;
  std::optional<WorkerMemory::Batch>& kept =
      batch.kept.level_before[batch.caller.entry_number()][mailbox.format % formats];
  std::unordered_map<std::uint32_t, std::size_t> places;
  for (std::size_t k = 0; kept && kept->level != mailbox.level && k * bytes < kept->arrays[0].size(); ++k)
    places.emplace(first_number(kept->arrays[0].data() + k * bytes), k);
  Fenced there(batch.answer_bytes(), blank);
  std::size_t matches = 0;
  for (std::size_t k = 0; k < batch.count() && matches < most_after_the_level_before && !places.empty();
       ++k) {
    Arguments before = batch.piece(k, 1);
    const auto same = places.find(first_number(before.arrays[0]));
    if (same == places.end()) continue;
    ++matches;
    before.level = kept->level;
    for (std::size_t array = 0; array < signature.arrays; ++array)
      before.arrays[array] = kept->arrays[array].data() + same->second * bytes;
    batch.caller.guarded_beyond(before, there, batch.first() + k);
    batch.ask_element(
        k, "asked after one of level " + std::to_string(kept->level) + " with the same first number");
  }
  kept = WorkerMemory::Batch{mailbox.level, {}};
  const Arguments whole = batch.piece(0, batch.count());
  for (std::size_t array = 0; array < signature.arrays; ++array)
    kept->arrays[array].assign(whole.arrays[array], whole.arrays[array] + batch.count() * bytes);
}

void after_neighbours(const Batch& batch) {
  const std::size_t arrays = batch.signature().arrays, bytes = batch.signature().number_bytes;
  if (arrays < 2) return;  // any two elements differ in one number
  const std::size_t count = std::min(batch.count(), most_elements);
  const Arguments whole = batch.piece(0, count);
  std::vector<std::string> numbers;
  Places places;
  for (std::size_t k = 0; k < count; ++k) {
    numbers.push_back(numbers_of(whole, arrays, bytes, k));
    places.emplace(numbers.back(), k);
  }
  Order order;
  add_pairs_that_differ_in_a_bit(numbers, places, order);
  add_pairs_that_differ_in_a_number(numbers, arrays, bytes, order);
  constexpr char how[] = "asked after one that differs in one number";
  batch.ask_at_page(order, how);
  for (const std::size_t k : order) batch.ask_element(k, how);
}

void after_another_format(const Batch& batch) {
  const Mailbox& mailbox = batch.caller.mailbox();
  if (mailbox.this_level_alone != 0) return;
  const std::size_t count = std::min(batch.count(), most_in_another_format);
  for (const std::uint32_t other : other_formats(mailbox.call, mailbox.level, mailbox.format)) {
    const auto after_other = [&](std::size_t at, std::size_t size) {
      Arguments what = batch.piece(at, size);
      what.format = other;
      after_format(batch, what, at);
    };
    after_other(0, count);
    for (std::size_t at = 0; at < count; ++at) after_other(at, 1);
  }
  after_kept_formats(batch);
}

void after_another_format(const Blob& blob) {
  const Mailbox& mailbox = blob.caller.mailbox();
  const std::span<const std::uint8_t> bytes(blob.bytes, static_cast<std::size_t>(blob.blob_bytes()));
  for (const std::uint32_t other : other_formats(mailbox.call, mailbox.level, mailbox.format)) {
    const std::vector<std::uint8_t> same = as_of_format(mailbox.call, mailbox.level, other, bytes);
    Fenced answer(2 * static_cast<std::size_t>(std::max(blob.room(), blob.size)), blank);
    Arguments before =
        blob.arguments(blob.bytes, blob.signature().sizes_answer ? answer.size() : blob.room());
    before.format = other;
    // Something else comes first: otherwise a cache still has this question's answer, and gives it for the
    // other format. It is a code of no bytes, or the inverted bytes; an inverted array is invalid, so arrays
    // go without.
    const bool of_code = mailbox.call == Call::tree_decode || mailbox.call == Call::dag_decode;
    const std::vector<std::uint8_t> unlike =
        as_of_format(mailbox.call, mailbox.level, other, inverted(bytes, 0, bytes.size()));
    before.blob = unlike.data();
    if (of_code) before.blob_bytes = 0;
    if (mailbox.call != Call::array_save) blob.caller.guarded_beyond(before, answer, 0);
    before.blob = same.data();
    before.blob_bytes = bytes.size();
    blob.ask_after(before, answer, "asked after the same bytes in another format, order or mode");
  }
}

void after_kept_formats(const Blob& blob) {
  const Mailbox& mailbox = blob.caller.mailbox();
  if (mailbox.format == 0 || blob.blob_bytes() > most_kept_bytes) return;
  const auto of = [&](std::uint32_t format) -> std::deque<QuestionCopy>& {
    return blob.kept.of_format[{static_cast<std::uint32_t>(mailbox.call), mailbox.level, format}];
  };
  const auto* const here = reinterpret_cast<const std::byte*>(blob.bytes);
  const auto is_here = [&](const QuestionCopy& q) {
    return std::equal(q.blob.begin(), q.blob.end(), here, here + blob.blob_bytes());
  };
  for (const std::uint32_t other : {MMVERIFY_2_STATE, MMVERIFY_4_STATE}) {
    if (other == mailbox.format) continue;
    for (const std::deque<QuestionCopy>& all = of(other); const QuestionCopy& q : all) {
      if (&q != &all.back() && !is_here(q)) continue;
      Fenced answer(q.answer.size(), blank_again);
      if (blob.caller.guarded_beyond(q.arguments, answer, 0) != q.size ||
          (q.size != 0 && !std::equal(q.answer.begin(), q.answer.end(), answer.data())))
        blob.caller.stop(Outcome::non_deterministic, 0,
                         "a question in another format, asked before, was answered otherwise after this one");
      blob.ask_after(q.arguments, answer, "asked after a question in another format");
    }
  }
  std::deque<QuestionCopy>& mine = of(mailbox.format);
  if (mine.size() >= most_kept) mine.pop_back();  // replaces the last one
  mine.push_back(blob.copy());
}

void after_like_ones(const Blob& blob) {
  constexpr std::size_t word = 8;
  const auto size = static_cast<std::size_t>(blob.blob_bytes());
  if (size < 2 * word) return;
  Fenced answer(static_cast<std::size_t>(blob.room()), blank);
  Arguments before = blob.arguments(blob.bytes, blob.room());
  const std::span<const std::uint8_t> these(blob.bytes, size);
  // Something else comes first: otherwise a cache still has the answer for these bytes, and not for the
  // similar ones.
  const std::vector<std::uint8_t> unlike =
      changed(these, 0, size, [](std::uint8_t byte, std::size_t k) { return byte + 1 + 3 * k; });
  const auto after = [&](const std::vector<std::uint8_t>& bytes, const char* how) {
    before.blob = unlike.data();
    blob.caller.guarded_beyond(before, answer, 0);
    before.blob = bytes.data();
    blob.ask_after(before, answer, how);
  };
  std::vector<std::uint8_t> turned(these.begin(), these.end());
  std::rotate(turned.begin(), turned.begin() + word,
              turned.begin() + static_cast<std::ptrdiff_t>(size / word * word));
  after(turned, "asked after the same words of eight bytes in another order");
  after(inverted(these, size / 2, size), "asked after other bytes with the same first half");
  after(inverted(these, 0, size / 2), "asked after other bytes with the same second half");
}

void after_the_level_below(const Blob& blob) {
  const std::uint32_t level = blob.caller.mailbox().level;
  if (level < 2) return;
  // This asks the first quarter of the bytes.
  Fenced answer(static_cast<std::size_t>(blob.room()), blank);
  Arguments before = blob.arguments(blob.bytes, blob.room());
  before.level = level - 1;
  blob.ask_after(before, answer, "asked after level " + std::to_string(before.level));
}

}  // namespace mmverify::dock
