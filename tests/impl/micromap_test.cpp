// impl/micromap, impl/micromap_level and impl/micromap_array against the specification: every small map, and
// lengths around the word.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "impl/micromap/append.hpp"
#include "impl/micromap/level.hpp"
#include "spec/micromap/array.hpp"
#include "spec/micromap/level.hpp"
#include "spec/micromap/lossy.hpp"
#include "tests/sanitized.hpp"

namespace impl_micromap_test {

namespace fast = mmverify::impl::micromap;
namespace slow = mmverify::spec::micromap;
using fast::Bytes;

constexpr fast::Format fast_format(slow::Format f) { return static_cast<fast::Format>(f); }

slow::States random_states(std::mt19937& random, std::uint64_t count, slow::Format f) {
  slow::States states;
  // Runs, so that whole words and blocks are equal now and then.
  while (states.size() < count) {
    const auto s = static_cast<slow::State>(random() % (f == slow::Format::two_state ? 2 : 4));
    states.insert(states.end(), std::min<std::size_t>(1 + random() % 9, count - states.size()), s);
  }
  return states;
}

std::vector<fast::State> as_fast(const slow::States& states) {
  std::vector<fast::State> out;
  for (const slow::State s : states) out.push_back(static_cast<fast::State>(s));
  return out;
}

// Padding that a reader must ignore.
Bytes with_dirty_padding(Bytes bytes, std::uint64_t count, slow::Format f) {
  const std::uint64_t used = count * bits(f) % 8;
  if (used != 0 && !bytes.empty())
    bytes.back() = static_cast<std::uint8_t>(bytes.back() | (0xff << used & 0xff));
  return bytes;
}

constexpr slow::Format formats[] = {slow::Format::two_state, slow::Format::four_state};
constexpr auto two = slow::Format::two_state, four = slow::Format::four_state;

// Every function on one map.
void expect_as_specified(const slow::States& states, slow::Format f) {
  const std::uint64_t count = states.size();
  const Bytes packed = slow::pack(states, f), dirty = with_dirty_padding(packed, count, f);
  const auto size = [&](std::uint64_t n, slow::Format g) {
    return Bytes(static_cast<std::size_t>(slow::packed_bytes(n, g)), 0xa5);
  };

  Bytes out = size(count, f);
  fast::pack(as_fast(states), fast_format(f), out);
  ASSERT_EQ(out, packed);
  std::vector<fast::State> unpacked(count, fast::State::UO);
  fast::unpack(dirty, fast_format(f), unpacked);
  ASSERT_EQ(unpacked, as_fast(states));

  const auto one = slow::uniform(states);
  const auto got = fast::uniform(dirty, fast_format(f), count);
  ASSERT_EQ(got.has_value(), one.has_value());
  ASSERT_TRUE(!one || static_cast<int>(*got) == static_cast<int>(*one));

  fast::StateCounts counts{};
  for (const slow::State s : states) ++counts[slow::code(s)];
  ASSERT_EQ(fast::count_states(dirty, fast_format(f), count), counts);

  if (f == two) {
    out = size(count, four);
    fast::widen(dirty, count, out);
    ASSERT_EQ(out, slow::pack(states, four));
  } else {
    out = size(count, two);
    fast::force2(dirty, count, out);
    ASSERT_EQ(out, slow::pack(slow::force2(states), two));
    for (const auto mode : {slow::Mode::T_O, slow::Mode::T_C, slow::Mode::O_C}) {
      const auto fast_mode = static_cast<fast::Mode>(mode);
      slow::States bits_of_states;
      for (const slow::State s : states)
        bits_of_states.push_back(slow::bit_of(s, mode) ? slow::State::O : slow::State::T);
      fast::to_mode(dirty, count, fast_mode, out);
      ASSERT_EQ(out, slow::pack(bits_of_states, two));
      Bytes back = size(count, four);
      fast::from_mode(with_dirty_padding(out, count, two), count, fast_mode, back);
      ASSERT_EQ(back, slow::pack(slow::through(states, mode), four));
      std::uint64_t asked = 0;
      for (const slow::State s : slow::through(states, mode)) asked += slow::unknown(s);
      ASSERT_EQ(fast::cost(counts, fast_mode).any_hit, asked);
      ASSERT_EQ(fast::cost(counts, fast_mode).bits, count);
    }
    ASSERT_EQ(fast::cost(counts).bits, 2 * count);
    ASSERT_EQ(fast::cost(counts).any_hit, counts[2] + counts[3]);
  }

  out = size(4 * count, f);
  fast::up(dirty, fast_format(f), count, out);
  ASSERT_EQ(out, slow::pack(slow::up(states), f));
  if (count != 0 && count % 4 == 0) {
    out = size(count / 4, f);
    fast::down(dirty, fast_format(f), count / 4, out);
    ASSERT_EQ(out, slow::pack(f == two ? slow::down_two_state(states) : slow::down(states), f));
  }
}

// ---- Packed maps

TEST(ImplMicromap, EveryLengthAroundTheWordIsAsSpecified) {
  std::mt19937 random(1);
  for (std::uint64_t count = 0; count <= 150; ++count)
    for (const slow::Format f : formats)
      for (int k = 0; k < 4; ++k) expect_as_specified(random_states(random, count, f), f);
}

TEST(ImplMicromap, RefusesSpansOfAnotherSize) {
  Bytes one(1), two_bytes(2);
  std::vector<fast::State> states(5, fast::State::T);
  EXPECT_THROW(fast::pack(states, fast::Format::four_state, one), std::invalid_argument);
  EXPECT_THROW(fast::unpack(one, fast::Format::four_state, states), std::invalid_argument);
  EXPECT_THROW(fast::force2(one, 5, one), std::invalid_argument);
  EXPECT_THROW(fast::widen(one, 5, one), std::invalid_argument);
  EXPECT_THROW(fast::uniform(one, fast::Format::two_state, 9), std::invalid_argument);
  EXPECT_THROW(fast::count_states(one, fast::Format::two_state, 9), std::invalid_argument);
  EXPECT_THROW(fast::up(one, fast::Format::four_state, 4, two_bytes), std::invalid_argument);
  EXPECT_THROW(fast::down(one, fast::Format::four_state, 4, one), std::invalid_argument);
  EXPECT_THROW(fast::to_mode(one, 5, fast::Mode::T_C, one), std::invalid_argument);
  EXPECT_THROW(fast::from_mode(one, 4, fast::Mode::T_C, two_bytes), std::invalid_argument);
  EXPECT_THROW(fast::substitutions(one, two_bytes, 5), std::invalid_argument);
  states.resize(4, fast::State::T);
  states[2] = fast::State::UT;
  EXPECT_THROW(fast::pack(states, fast::Format::two_state, one), std::invalid_argument);
  states[2] = static_cast<fast::State>(4);
  EXPECT_THROW(fast::pack(states, fast::Format::four_state, one), std::invalid_argument);
  EXPECT_EQ(one, Bytes{0});
}

TEST(ImplMicromap, SubstitutionsAreCountedByPair) {
  std::mt19937 random(3);
  for (std::uint64_t count = 0; count <= 70; ++count) {
    const slow::States was = random_states(random, count, four), is = random_states(random, count, four);
    std::array<fast::StateCounts, 4> expected{};
    for (std::size_t i = 0; i < count; ++i) ++expected[slow::code(was[i])][slow::code(is[i])];
    const auto got = fast::substitutions(with_dirty_padding(slow::pack(was, four), count, four),
                                         slow::pack(is, four), count);
    ASSERT_EQ(got.count, expected);
  }
}

// ---- Arrays

struct Both {
  slow::Array slow_array;
  fast::Array fast_array;

  void expect_equal() const {
    ASSERT_EQ(fast_array.data, slow_array.data);
    ASSERT_EQ(fast_array.records.size(), slow_array.records.size());
    ASSERT_EQ(fast::record_buffer(fast_array.records), slow::record_buffer(slow_array.records));
  }

  // The same maps to both; whether they were taken.
  bool append(const std::vector<slow::Map>& maps, const slow::Options& options) {
    std::vector<Bytes> bytes;
    std::vector<fast::PackedMap> packed;
    for (const slow::Map& m : maps)
      bytes.push_back(with_dirty_padding(slow::pack(m.states, m.format), m.states.size(), m.format));
    for (std::size_t t = 0; t < maps.size(); ++t)
      packed.push_back({maps[t].level, fast_format(maps[t].format), bytes[t]});
    const fast::Options same{static_cast<fast::Encoding>(options.encoding), options.base_triangle,
                             options.deduplicate, options.special};
    std::optional<slow::Geometry> expected;
    try {
      expected = slow::append(slow_array, maps, options);
    } catch (const std::length_error&) {
    }
    if (!expected) {
      EXPECT_THROW(fast::append(fast_array, packed, same), std::length_error);
      expect_equal();
      return false;
    }
    const fast::Geometry got = fast::append(fast_array, packed, same);
    EXPECT_EQ(got.indices, expected->indices);
    EXPECT_EQ(got.counts.size(), expected->counts.size());
    for (std::size_t i = 0; i < expected->counts.size(); ++i) {
      EXPECT_EQ(got.counts[i].count, expected->counts[i].count);
      EXPECT_EQ(got.counts[i].level, expected->counts[i].level);
      EXPECT_EQ(got.counts[i].format, expected->counts[i].format);
    }
    expect_equal();
    return true;
  }
};

TEST(ImplMicromap, AppendsToArraysOfAnyOrigin) {
  Both both;
  // A format that is none, bytes that are not there, dirty padding, and twice the same map.
  both.slow_array.records = {{0, 1, 3}, {1, 9, 2}, {0, 0, 2}, {1, 0, 2}, {1, 0, 2}};
  both.slow_array.data = {0xff, 0x02};
  for (const slow::Record& r : both.slow_array.records)
    both.fast_array.records.push_back({r.offset, r.level, r.format});
  both.fast_array.data = both.slow_array.data;
  EXPECT_TRUE(
      both.append({{0, four, {slow::State::UO}}, {0, four, {slow::State::UT}}, {0, two, {slow::State::O}}},
                  {slow::Encoding::u8, 0, true, false}));
  EXPECT_EQ(both.fast_array.records.size(), 6u);
  EXPECT_TRUE(both.append({{0, four, {slow::State::UT}}}, {slow::Encoding::u8, 4, true, false}));
  EXPECT_EQ(both.fast_array.records.size(), 6u);
}

TEST(ImplMicromap, RefusesMapsThatAreNone) {
  fast::Array array;
  const Bytes bytes(4);
  const auto refused = [&](fast::PackedMap map) {
    EXPECT_THROW(fast::append(array, std::span(&map, 1), {}), std::invalid_argument);
    EXPECT_TRUE(array.records.empty() && array.data.empty());
  };
  refused({3, fast::Format::four_state, bytes});
  refused({17, fast::Format::four_state, bytes});
  refused({1, static_cast<fast::Format>(3), bytes});
  fast::PackedMap fine{2, fast::Format::four_state, bytes};
  EXPECT_THROW(fast::append(array, std::span(&fine, 1), {fast::Encoding::u32, 1, true, true}),
               std::invalid_argument);
}

}  // namespace impl_micromap_test
