#include "proofs/vq/blocks.hpp"

#include "proofs/engine/random.hpp"
#include "proofs/vq/fields.hpp"

namespace mmverify::proofs::vq {
namespace {

// Laws that prove name their blocks, whatever the seed of a run: these are drawn from one that is fixed.  A use
// of it has a stream.
constexpr std::uint64_t fixed_seed = 0;
enum Stream : std::uint64_t {
  orders_of_words = 64,
  places_of_words = 80,
  entries_of_indices = 82,
  scattered_bits = 84,
  places_of_every_word = 86,
  random_bits = 88,
  bits_of_fields = 90,
  few_indices = 92,
  runs = 94,
  alike_entries = 96,
};

template <class Format>
std::uint64_t stream(Stream use) {
  return use + (Format::side == 2 ? 0 : 1);
}

template <class Items>
void shuffle(Items& items, Random& random) {
  for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[random.below(k)]);
}

template <class Format>
constexpr std::uint32_t bits_of_entry(std::size_t entry) {
  return places<Format>[67 + entry].bits;
}

/// The block whose entry k is the low bits of word(k).
template <class Format, class Word>
Format filled(const Word& word) {
  Values<Format> values{};
  for (std::size_t k = 0; k < entries<Format>; ++k)
    values[67 + k] = word(k) & ((1u << bits_of_entry<Format>(k)) - 1);
  return with<Format>(values);
}

/// Every index in each quadrant as often as any other, in an order of the quadrant's own.
template <class Format>
void scatter_indices(Format& fields, Random& random) {
  for (std::size_t q = 0; q < 4; ++q) {
    std::array<std::uint8_t, 16> order;
    for (std::size_t k = 0; k < 16; ++k) order[k] = static_cast<std::uint8_t>(k % (1u << Format::index_bits));
    shuffle(order, random);
    for (std::size_t k = 0; k < 16; ++k)
      fields.indices[k % 4 + 4 * (q % 2) + 8 * (k / 4 + (q < 2 ? 4 : 0))] = order[k];
  }
}

/// Turns 0..7 give each of the three every transform, however far they are ahead of each other.
template <class Format>
void turn(Format& fields, std::uint32_t by, Random& ahead) {
  for (std::size_t q = 1; q < 4; ++q)
    fields.transforms[q] = Transform::of((by + static_cast<std::uint32_t>(ahead.below(8))) % 8);
}

std::vector<std::uint32_t> few_bits(std::uint32_t bits) {
  std::vector<std::uint32_t> all;
  const std::uint32_t ones = (1u << bits) - 1;
  for (std::uint32_t word = 0; word <= ones; ++word) {
    const auto set = static_cast<std::uint32_t>(__builtin_popcount(word));
    if (set <= 3 || set + 3 >= bits) all.push_back(word);
  }
  return all;
}

/// The chosen words, in an order for each entry.
template <class Format>
const std::array<std::vector<std::uint32_t>, entries<Format>>& orders() {
  static const auto all = [] {
    std::array<std::vector<std::uint32_t>, entries<Format>> shuffled;
    for (std::size_t entry = 0; entry < shuffled.size(); ++entry) {
      Random random(fixed_seed, stream<Format>(orders_of_words), entry);
      shuffled[entry] = chosen_words<Format>();
      shuffle(shuffled[entry], random);
    }
    return shuffled;
  }();
  return all;
}

/// The product of two polynomials over GF(2) of fewer than `bits` coefficients, modulo x^bits + x + 1, which
/// has no divisors for 3 and 4.
constexpr std::uint32_t product(std::uint32_t a, std::uint32_t b, std::uint32_t bits) {
  std::uint32_t p = 0;
  for (std::uint32_t k = 0; k < bits; ++k) {
    if ((b >> k & 1) != 0) p ^= a;
    a <<= 1;
    if ((a >> bits & 1) != 0) a ^= 1u << bits | 3;
  }
  return p;
}

template <class Format>
constexpr auto products = [] {
  constexpr std::uint32_t size = 1u << Format::index_bits;
  std::array<std::array<std::uint8_t, size>, size> all{};
  for (std::uint32_t a = 0; a < size; ++a)
    for (std::uint32_t b = 0; b < size; ++b)
      all[a][b] = static_cast<std::uint8_t>(product(a, b, Format::index_bits));
  return all;
}();

template <class Format>
BlockBytes<Format> bits(Random random) {
  BlockBytes<Format> block;
  for (std::size_t k = 0; k < block.size(); k += 8) {
    const std::uint64_t word = random.next();
    for (std::size_t byte = 0; byte < 8; ++byte)
      block[k + byte] = static_cast<std::uint8_t>(word >> 8 * byte);
  }
  return block;
}

/// A word for each number of 20 bits, in an order of the field's own: each step can be undone.
constexpr std::uint32_t ordered_word(std::uint32_t number, std::size_t field) {
  constexpr std::uint32_t mask = (1u << 20) - 1;
  std::uint32_t word = number ^ (0x9E37u * static_cast<std::uint32_t>(field + 1) & mask);
  for (const std::uint32_t odd : {0x2C1B3u, 0x97A2Du}) {
    word = word * (odd + 2 * static_cast<std::uint32_t>(field)) & mask;
    word ^= word >> 9;
  }
  return word;
}

}  // namespace

template <class Format>
const std::vector<std::uint32_t>& chosen_words() {
  static const std::vector<std::uint32_t> words = few_bits(Format::side == 2 ? 5 : 20);
  return words;
}

template <class Format>
std::uint64_t word_blocks() {
  return 8 * chosen_words<Format>().size();
}

template <class Format>
Format word_block(std::uint64_t k) {
  const auto& words = orders<Format>();
  Format fields = filled<Format>([&](std::size_t entry) { return words[entry][k / 8]; });
  Random of_word(fixed_seed, stream<Format>(places_of_words), k / 8);
  turn(fields, static_cast<std::uint32_t>(k % 8), of_word);
  Random of_block(fixed_seed, stream<Format>(places_of_words), (std::uint64_t{1} << 32) + k);
  scatter_indices(fields, of_block);
  return fields;
}

template <class Format>
Format index_block(std::uint64_t k) {
  Random random(fixed_seed, stream<Format>(entries_of_indices), k);
  Format fields =
      filled<Format>([&](std::size_t) { return static_cast<std::uint32_t>(random.next() >> 32); });
  std::array<std::uint32_t, 4> t{};
  for (std::size_t q = 1; q < 4; ++q) {
    t[q] = static_cast<std::uint32_t>(k >> 3 * (q - 1)) % 8;
    fields.transforms[q] = Transform::of(t[q]);
  }
  const auto& times = products<Format>;
  const std::uint32_t of_x = t[1] ^ times[2][t[3]], of_y = t[2] ^ times[4][t[3]];
  for (std::uint32_t y = 0; y < 8; ++y)
    for (std::uint32_t x = 0; x < 8; ++x)
      fields.indices[x + 8 * y] =
          static_cast<std::uint8_t>(times[x][y] ^ times[x][of_x] ^ times[y][of_y] ^ k / 512);
  return fields;
}

template <class Format>
BlockBytes<Format> scattered_block(std::uint64_t k) {
  return bits<Format>(Random(fixed_seed, stream<Format>(scattered_bits), k));
}

namespace {

/// The block with one index everywhere but at one place, in one row, column or quadrant, or on every second
/// place, and with one entry that is another's: what decoders have short ways for.
template <class Format>
BlockBytes<Format> with_few_indices(const BlockBytes<Format>& block, Random random) {
  Values<Format> values = values_of_bits<Format>(block);
  const std::uint64_t all = 1u << Format::index_bits;
  // The first three entries of VQ4 are uniform, as a fast path would ask first.
  const auto common = static_cast<std::uint32_t>(random.below(random.below(2) == 0 ? 3 : all)),
             other = static_cast<std::uint32_t>(random.below(all));
  const std::uint64_t pattern = random.below(5), at = random.below(64);
  for (std::uint64_t place = 0; place < 64; ++place) {
    const std::uint64_t x = place % 8, y = place / 8, at_x = at % 8, at_y = at / 8;
    const bool differs = pattern == 0   ? place == at
                         : pattern == 1 ? y == at_y
                         : pattern == 2 ? x == at_x
                         : pattern == 3 ? x / 4 == at_x / 4 && y / 4 == at_y / 4
                                        : (x + y) % 2 == at % 2;
    values[place] = differs ? other : common;
  }
  const std::uint64_t from = 67 + random.below(entries<Format>), to = 67 + random.below(entries<Format>);
  values[to] = values[from] & ((1u << places<Format>[to].bits) - 1);
  return bits_of_values<Format>(values);
}

/// The block with a run of entries, or all, of which each is the one 1, 2 or 4 before it.
template <class Format>
BlockBytes<Format> with_alike_entries(const BlockBytes<Format>& block, Random random) {
  Values<Format> values = values_of_bits<Format>(block);
  const std::uint64_t all = entries<Format>, first = random.below(2) == 0 ? 0 : random.below(all),
                      end = random.below(2) == 0 ? all : first + random.below(all - first + 1),
                      period = std::uint64_t{1} << random.below(3);
  for (std::uint64_t k = first + period; k < end; ++k)
    values[67 + k] = values[67 + k - period] & ((1u << places<Format>[67 + k].bits) - 1);
  return bits_of_values<Format>(values);
}

/// Up to 64 bits that follow each other are others: what a decoder has in mind of the block before may be all else.
template <class Format>
BlockBytes<Format> with_a_run_drawn_again(BlockBytes<Format> block, Random random) {
  const std::uint64_t all = 8 * block.size(), first = random.below(all),
                      end = std::min(all, first + 1 + random.below(64));
  for (std::uint64_t bit = first; bit < end; ++bit)
    if (bit == first || random.below(2) != 0)
      block[bit / 8] = static_cast<std::uint8_t>(block[bit / 8] ^ 1u << bit % 8);
  return block;
}

}  // namespace

template <class Format>
BlockBytes<Format> random_block(std::uint64_t seed, std::uint64_t k) {
  if (k % 8 == 6)
    return with_a_run_drawn_again<Format>(random_block<Format>(seed, k - 1),
                                          Random(seed, stream<Format>(runs), k));
  const BlockBytes<Format> block = bits<Format>(Random(seed, stream<Format>(random_bits), k));
  if (k % 8 == 4) return with_alike_entries<Format>(block, Random(seed, stream<Format>(alike_entries), k));
  return k % 4 == 3 ? with_few_indices<Format>(block, Random(seed, stream<Format>(few_indices), k)) : block;
}

Vq4 every_word_block(std::uint64_t k) {
  const auto number = static_cast<std::uint32_t>(k % (1u << 20));
  Vq4 fields = filled<Vq4>([&](std::size_t entry) { return ordered_word(number, entry); });
  Random of_word(fixed_seed, places_of_every_word, number);
  turn(fields, static_cast<std::uint32_t>(k >> 20), of_word);
  Random of_block(fixed_seed, places_of_every_word, (std::uint64_t{1} << 32) + k);
  scatter_indices(fields, of_block);
  return fields;
}

template <class Format>
BlockBytes<Format> field_block(std::uint64_t k) {
  if constexpr (Format::side == 2) {
    return bits<Format>(Random(fixed_seed, bits_of_fields, k));
  } else {
    Values<Format> values{};
    for (std::size_t field = 0; field < values.size(); ++field)
      values[field] =
          ordered_word(static_cast<std::uint32_t>(k), field) & ((1u << places<Format>[field].bits) - 1);
    return bits_of_values<Format>(values);
  }
}

template const std::vector<std::uint32_t>& chosen_words<Vq2>();
template const std::vector<std::uint32_t>& chosen_words<Vq4>();
template std::uint64_t word_blocks<Vq2>();
template std::uint64_t word_blocks<Vq4>();
template Vq2 word_block<Vq2>(std::uint64_t);
template Vq4 word_block<Vq4>(std::uint64_t);
template Vq2 index_block<Vq2>(std::uint64_t);
template Vq4 index_block<Vq4>(std::uint64_t);
template BlockBytes<Vq2> scattered_block<Vq2>(std::uint64_t);
template BlockBytes<Vq4> scattered_block<Vq4>(std::uint64_t);
template BlockBytes<Vq2> field_block<Vq2>(std::uint64_t);
template BlockBytes<Vq4> field_block<Vq4>(std::uint64_t);
template BlockBytes<Vq2> random_block<Vq2>(std::uint64_t, std::uint64_t);
template BlockBytes<Vq4> random_block<Vq4>(std::uint64_t, std::uint64_t);

}  // namespace mmverify::proofs::vq
