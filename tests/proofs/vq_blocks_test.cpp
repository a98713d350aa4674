// [release] The blocks that decoders of square maps are tried on: what the laws' domains and docs/SOUNDNESS.md say of them.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "proofs/engine/random.hpp"
#include "proofs/vq/blocks.hpp"
#include "proofs/vq/fields.hpp"
#include "tests/sanitized.hpp"

namespace vq_blocks_test {

using namespace mmverify::proofs::vq;
using mmverify::proofs::Random;
using mmverify::spec::vq::bytes;
using mmverify::spec::vq::decode;
using mmverify::spec::vq::from_bytes;

template <class Format>
constexpr std::uint32_t values_of_index = 1u << Format::index_bits;

std::size_t quadrant_of_vector(std::uint32_t vector) {
  return static_cast<std::size_t>(mmverify::spec::vq::quadrant_of(vector % 8, vector / 8));
}

template <class Format>
struct VqBlocks : testing::Test {};
using Formats = testing::Types<Vq2, Vq4>;
TYPED_TEST_SUITE(VqBlocks, Formats);

// ---- region_is_map

TYPED_TEST(VqBlocks, EachEntryHoldsEachChosenWordUnderEachTransformOfEachQuadrant) {
  const auto& words = chosen_words<TypeParam>();
  std::array<std::vector<std::uint8_t>, 3 * entries<TypeParam>> turned;  // a bit a transform
  for (auto& of_word : turned) of_word.resize(std::size_t{1} << 20);
  for (std::uint64_t k = 0; k < word_blocks<TypeParam>(); ++k) {
    const TypeParam fields = word_block<TypeParam>(k);
    const auto values = values_of_bits<TypeParam>(bytes(fields));
    std::array<std::array<std::uint32_t, values_of_index<TypeParam>>, 4> times{};
    for (std::uint32_t vector = 0; vector < 64; ++vector)
      ++times[quadrant_of_vector(vector)][fields.indices[vector]];
    for (const auto& of_quadrant : times)
      for (const std::uint32_t count : of_quadrant) ASSERT_EQ(count, 16 / values_of_index<TypeParam>);
    for (std::size_t entry = 0; entry < entries<TypeParam>; ++entry)
      for (std::size_t q = 1; q < 4; ++q) {
        auto& seen = turned[3 * entry + q - 1][values[67 + entry]];
        seen = static_cast<std::uint8_t>(seen | 1u << fields.transforms[q].number());
      }
  }
  for (std::size_t entry = 0; entry < entries<TypeParam>; ++entry)
    for (const std::uint32_t word : words)
      for (std::size_t q = 0; q < 3; ++q)
        ASSERT_EQ(turned[3 * entry + q][word & ((1u << places<TypeParam>[67 + entry].bits) - 1)], 0xFF);
}

TYPED_TEST(VqBlocks, EachIndexIsAtEachPlaceUnderEachTripleOfTransforms) {
  constexpr std::uint32_t size = values_of_index<TypeParam>;
  std::vector<std::uint32_t> seen(64 * 512);  // a bit a value
  for (std::uint64_t k = 0; k < index_blocks<TypeParam>; ++k) {
    const TypeParam fields = index_block<TypeParam>(k);
    const std::uint32_t triple = fields.transforms[1].number() + 8 * fields.transforms[2].number() +
                                 64 * fields.transforms[3].number();
    for (std::uint32_t vector = 0; vector < 64; ++vector)
      seen[64 * triple + vector] |= 1u << fields.indices[vector];
  }
  for (const std::uint32_t values : seen) ASSERT_EQ(values, (1u << size) - 1);
}

TYPED_TEST(VqBlocks, TwoIndexFieldsHaveEveryPairOfValuesInVq2UnderEachTransform) {
  constexpr std::uint32_t size = values_of_index<TypeParam>;
  // VQ4 is tested without transforms.
  constexpr std::uint32_t turns = TypeParam::side == 2 ? 8 : 1, stride = sanitized ? 13 : 1;
  std::vector<std::array<std::uint8_t, 67>> all;
  for (std::uint64_t k = 0; k < index_blocks<TypeParam>; ++k) {
    const auto values = values_of_bits<TypeParam>(bytes(index_block<TypeParam>(k)));
    std::copy_n(values.begin(), 67, all.emplace_back().begin());
  }
  for (std::size_t q = 64; q < 67; ++q)
    for (std::size_t a = 0; a < 64; a += stride)
      for (std::size_t b = a + 1; b < 64; ++b) {
        std::array<std::uint32_t, size * size * turns> times{};
        for (const auto& values : all) ++times[values[a] + size * (values[b] + size * (values[q] % turns))];
        for (const std::uint32_t count : times) ASSERT_EQ(count, all.size() / times.size()) << a << ' ' << b;
      }
}

// For any two index fields and any two values that they hold, at every region of the vector: some block shows
// that the one was read for the other.
TYPED_TEST(VqBlocks, NoIndexFieldCanBeReadForAnother) {
  constexpr std::size_t side = TypeParam::side, size = values_of_index<TypeParam>;
  constexpr std::uint32_t every = (1u << side * side) - 1, stride = sanitized ? 13 : 1;
  std::vector<std::uint16_t> seen(64 * 64 * size * size);  // a bit a region
  for (std::uint64_t k = 0; k < index_blocks<TypeParam>; ++k) {
    const TypeParam fields = index_block<TypeParam>(k);
    // The regions in which two entries of a quadrant differ, after its transform.
    std::array<std::array<std::array<std::uint16_t, size>, size>, 4> differ{};
    for (std::size_t q = 0; q < 4; ++q) {
      std::array<Vector<side>, size> entry;
      for (std::uint32_t i = 0; i < size; ++i)
        entry[i] = mmverify::spec::vq::applied<side>(
            fields.transforms[q], fields.entry(static_cast<mmverify::spec::vq::Quadrant>(q), i));
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j)
          for (std::size_t r = 0; r < side * side; ++r)
            if (entry[i][r] != entry[j][r])
              differ[q][i][j] = static_cast<std::uint16_t>(differ[q][i][j] | 1u << r);
    }
    for (std::uint32_t a = 0; a < 64; a += stride)
      for (std::uint32_t b = 0; b < 64; ++b) {
        const std::size_t i = fields.indices[a], j = fields.indices[b];
        auto& regions = seen[j + size * (i + size * (b + 64 * a))];
        regions = static_cast<std::uint16_t>(regions | differ[quadrant_of_vector(a)][i][j]);
      }
  }
  for (std::size_t a = 0; a < 64; a += stride)
    for (std::size_t b = 0; b < 64; ++b)
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j)
          if (a != b && i != j) {
            ASSERT_EQ(seen[j + size * (i + size * (b + 64 * a))], every)
                << a << ' ' << b << ' ' << i << ' ' << j;
          }
}

// ---- no_other_bit

template <class Format>
auto& code_of(Format& fields, std::size_t q, std::uint32_t index) {
  if constexpr (Format::side == 2)
    return index < 6 ? fields.shared[index - 3] : fields.own[q][index - 6];
  else
    return fields.codebook[index - 3];
}

/// The field of a code in the order of a block's fields.
template <class Format>
std::size_t field_of(std::size_t q, std::uint32_t index) {
  return 67 + (Format::side == 2 && index > 5 ? 2 * q + index - 3 : index - 3);
}

/// The two bits of a block that a region of a quadrant's vectors is made of, found by trying: one makes C of T,
/// the other O.
template <class Format>
std::array<std::uint32_t, 2> bits_of_entry(std::size_t q, std::uint32_t index, std::uint32_t transform,
                                           std::uint32_t region) {
  constexpr std::uint32_t side = Format::side;
  Format fields;
  fields.transforms[q] = Transform::of(transform);
  const std::uint32_t vector = (q % 2 == 0 ? 0u : 4u) + (q < 2 ? 32u : 0u);
  fields.indices[vector] = static_cast<std::uint8_t>(index);
  std::array<std::uint32_t, 2> found{};
  const BitField place = places<Format>[field_of<Format>(q, index)];
  for (std::uint32_t bit = 0; bit < place.bits; ++bit) {
    auto& code = code_of(fields, q, index);
    code = static_cast<std::remove_reference_t<decltype(code)>>(1u << bit);
    const State s = mmverify::spec::vq::decode_region(
        fields, {side * (vector % 8) + region % side, side * (vector / 8) + region / side});
    if (s != State::T) found[s == State::C ? 0 : 1] = place.first + bit;
  }
  return found;
}

TYPED_TEST(VqBlocks, EachOtherBitIsSetAndClearBesideAllThatARegionIsMadeOf) {
  constexpr std::uint32_t side = TypeParam::side, size = values_of_index<TypeParam>,
                          words = TypeParam::bits / 64;
  constexpr std::uint32_t stride = sanitized ? 97 : 1;
  using Bits = std::array<std::uint64_t, words>;
  const auto has = [](const Bits& bits, std::uint32_t k) { return (bits[k / 64] >> k % 64 & 1) != 0; };
  std::vector<Bits> blocks;
  std::vector<TypeParam> fields;
  for (std::uint64_t k = 0; k < scattered_blocks<TypeParam>; ++k) {
    const BlockBytes<TypeParam> block = scattered_block<TypeParam>(k);
    fields.push_back(from_bytes<TypeParam>(block));
    Bits& bits = blocks.emplace_back();
    for (std::uint32_t b = 0; b < block.size(); ++b) bits[b / 8] |= std::uint64_t{block[b]} << b % 8 * 8;
  }
  struct Seen {
    Bits set{}, clear{};
  };
  for (std::uint32_t region = 0; region < side * side; ++region)
    for (std::uint32_t vector = 0; vector < 64; ++vector) {
      if ((region * 64 + vector) % stride != 0) continue;
      const std::size_t q = quadrant_of_vector(vector);
      const std::uint32_t turns = q == 0 ? 1 : 8;
      // The two bits that decide the region, by index and transform. Uniform vectors have none, and form one class.
      std::vector<std::array<std::uint32_t, 2>> own(size * 8);
      for (std::uint32_t index = 3; index < size; ++index)
        for (std::uint32_t t = 0; t < turns; ++t)
          own[8 * index + t] = bits_of_entry<TypeParam>(q, index, t, region);
      std::vector<Seen> seen(size * 8 * 4);
      for (std::size_t k = 0; k < blocks.size(); ++k) {
        const std::uint32_t index = fields[k].indices[vector], t = fields[k].transforms[q].number(),
                            at = 8 * index + t;
        const std::uint32_t pair =
            index < 3 ? 0 : (has(blocks[k], own[at][0]) ? 1u : 0u) + (has(blocks[k], own[at][1]) ? 2u : 0u);
        Seen& s = seen[4 * at + pair];
        for (std::uint32_t w = 0; w < words; ++w) {
          s.set[w] |= blocks[k][w];
          s.clear[w] |= ~blocks[k][w];
        }
      }
      for (std::uint32_t index = 0; index < size; ++index)
        for (std::uint32_t t = 0; t < turns; ++t)
          for (std::uint32_t pair = 0; pair < (index < 3 ? 1u : 4u); ++pair) {
            Bits made_of{};
            const auto makes = [&](std::uint32_t first, std::uint32_t count) {
              for (std::uint32_t k = first; k < first + count; ++k)
                made_of[k / 64] |= std::uint64_t{1} << k % 64;
            };
            makes(places<TypeParam>[vector].first, TypeParam::index_bits);
            if (q != 0) makes(places<TypeParam>[63 + q].first, 3);
            if (index > 2)
              for (const std::uint32_t bit : own[8 * index + t]) makes(bit, 1);
            const Seen& s = seen[4 * (8 * index + t) + pair];
            for (std::uint32_t w = 0; w < words; ++w)
              ASSERT_EQ((s.set[w] & s.clear[w]) | made_of[w], ~std::uint64_t{0})
                  << "region " << region << " of vector " << vector << ", index " << index << ", transform "
                  << t;
          }
    }
}

// ---- field_values, every_code_word

TYPED_TEST(VqBlocks, TwoFieldsHaveEveryPairOfValues) {
  constexpr std::size_t fields = fields_of<TypeParam>;
  constexpr std::uint64_t count = TypeParam::side == 2 ? field_blocks<TypeParam> : 1u << 15;
  constexpr std::size_t stride = sanitized ? 13 : 1;
  std::vector<Values<TypeParam>> all;
  for (std::uint64_t k = 0; k < count; ++k)
    all.push_back(values_of_bits<TypeParam>(field_block<TypeParam>(k)));
  for (std::size_t a = 0; a < fields; a += stride)
    for (std::size_t b = a + 1; b < fields; ++b) {
      const std::uint32_t of_a = 1u << places<TypeParam>[a].bits, of_b = 1u << places<TypeParam>[b].bits;
      if (of_a > 32 || of_b > 32) continue;
      std::array<bool, 1024> seen{};
      for (const auto& values : all) seen[values[a] + of_a * values[b]] = true;
      ASSERT_EQ(std::count(seen.begin(), seen.end(), true), of_a * of_b) << a << ' ' << b;
    }
}

TEST(VqEveryWord, EachEntryHoldsEachOfItsWordsUnderEachTransform) {
  if (sanitized) GTEST_SKIP() << "eight million blocks' words; the release build counts them";
  std::array<std::vector<std::uint8_t>, 13> times;
  for (std::size_t entry = 0; entry < times.size(); ++entry)
    times[entry].resize(std::size_t{1} << places<Vq4>[67 + entry].bits);
  for (std::uint64_t k = 0; k < every_word_blocks / 8; ++k) {
    const Vq4 fields = every_word_block(k);
    for (std::size_t entry = 0; entry < times.size(); ++entry) ++times[entry][fields.codebook[entry]];
    if (k % 4096 != 0) continue;
    std::array<std::set<std::uint32_t>, 4> turns;
    for (std::uint64_t turn = 0; turn < 8; ++turn) {
      const Vq4 turned = every_word_block(k + (turn << 20));
      ASSERT_EQ(turned.codebook, fields.codebook);
      for (std::size_t q = 1; q < 4; ++q) turns[q].insert(turned.transforms[q].number());
    }
    for (std::size_t q = 1; q < 4; ++q) ASSERT_EQ(turns[q].size(), 8u);
  }
  for (const auto& of_entry : times)
    for (const std::uint8_t count : of_entry) ASSERT_EQ(count, (1u << 20) / of_entry.size());
}

}  // namespace vq_blocks_test
