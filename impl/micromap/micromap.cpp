#include "impl/micromap/micromap.hpp"

#include <array>

#include "impl/micromap/words.hpp"

namespace mmverify::impl::micromap {
namespace {

using namespace detail;

std::span<const std::uint8_t> as_bytes(std::span<const State> states) {
  return {reinterpret_cast<const std::uint8_t*>(states.data()), states.size()};
}

}  // namespace

void pack(std::span<const State> states, Format f, std::span<std::uint8_t> out) {
  require(out.size() == packed_bytes(states.size(), f), "micromap::pack: out has not packed_bytes bytes");
  const std::span<const std::uint8_t> in = as_bytes(states);
  std::uint64_t any = 0;
  each_word(in, 8 * std::uint64_t{in.size()}, [&](std::uint64_t word, std::uint64_t) { any |= word; });
  const std::uint64_t code_bits = f == Format::two_state ? 0x0101010101010101 : 0x0303030303030303;
  require((any & ~code_bits) == 0, "micromap::pack: a state that the format does not hold");
  const std::uint64_t in_bits = 8 * std::uint64_t{in.size()};
  if (f == Format::two_state)
    each_word<8, 1>(in, in_bits, out, states.size(), bytes_to_bits);
  else
    each_word<8, 2>(in, in_bits, out, 2 * std::uint64_t{states.size()}, bytes_to_pairs);
}

void unpack(std::span<const std::uint8_t> bytes, Format f, std::span<State> out) {
  const std::uint64_t count = out.size();
  require(bytes.size() >= packed_bytes(count, f), "micromap::unpack: too few bytes");
  const std::span<std::uint8_t> to(reinterpret_cast<std::uint8_t*>(out.data()), out.size());
  if (f == Format::two_state)
    each_word<1, 8>(bytes, count, to, 8 * count, bits_to_bytes);
  else
    each_word<2, 8>(bytes, 2 * count, to, 8 * count, pairs_to_bytes);
}

void force2(std::span<const std::uint8_t> four_state, std::uint64_t count,
            std::span<std::uint8_t> two_state) {
  require(four_state.size() >= packed_bytes(count, Format::four_state), "micromap::force2: too few bytes");
  require(two_state.size() == packed_bytes(count, Format::two_state),
          "micromap::force2: out has not packed_bytes bytes");
  each_word<8, 4>(four_state, 2 * count, two_state, count, gathered<64, std::uint64_t>);
}

void widen(std::span<const std::uint8_t> two_state, std::uint64_t count, std::span<std::uint8_t> four_state) {
  require(two_state.size() >= packed_bytes(count, Format::two_state), "micromap::widen: too few bytes");
  require(four_state.size() == packed_bytes(count, Format::four_state),
          "micromap::widen: out has not packed_bytes bytes");
  each_word<4, 8>(two_state, count, four_state, 2 * count, spread<64, std::uint64_t>);
}

std::optional<State> uniform(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count) {
  require(bytes.size() >= packed_bytes(count, f), "micromap::uniform: too few bytes");
  if (count == 0) return std::nullopt;
  const unsigned first = bytes[0] & static_cast<unsigned>(low(bits(f)));
  const std::uint64_t all = f == Format::two_state ? 0 - std::uint64_t{first} : even_bits * first;
  // It looks at a block at a time, so that the inner loop has no branch and an unlike map is left early.
  constexpr std::uint64_t block = 64 * 64;
  const std::uint64_t total = count * bits(f);
  for (std::uint64_t at = 0; at < total; at += block) {
    std::uint64_t unlike = 0;
    each_word(bytes.subspan(static_cast<std::size_t>(at / 8)), total - at < block ? total - at : block,
              [&](std::uint64_t word, std::uint64_t mask) { unlike |= (word ^ all) & mask; });
    if (unlike != 0) return std::nullopt;
  }
  return static_cast<State>(first);
}

namespace {

/// The number of even bits set in each byte, at most 4.  Domain: no odd bit is set.
std::uint64_t even_ones(std::uint64_t x) noexcept {
  x = (x & 0x3333333333333333) + (x >> 2 & 0x3333333333333333);
  return (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0f;
}
std::uint64_t sum_of_bytes(std::uint64_t x) noexcept {
  x = (x & 0x00ff00ff00ff00ff) + (x >> 8 & 0x00ff00ff00ff00ff);
  return x * 0x0001000100010001 >> 48;
}

}  // namespace

StateCounts count_states(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count) {
  require(bytes.size() >= packed_bytes(count, f), "micromap::count_states: too few bytes");
  const auto ones = [](std::uint64_t x) { return static_cast<std::uint64_t>(std::popcount(x)); };
  StateCounts n{};
  if (f == Format::two_state) {
    each_word(bytes, count, [&](std::uint64_t word, std::uint64_t) { n[1] += ones(word); });
  } else {
    // Sums are formed in bytes, without a branch or a call for each word; for a block they stay below 256.
    constexpr std::uint64_t block = 64 * 63;
    const std::uint64_t total = 2 * count;
    for (std::uint64_t at = 0; at < total; at += block) {
      std::array<std::uint64_t, 3> sums{};
      each_word(bytes.subspan(static_cast<std::size_t>(at / 8)), total - at < block ? total - at : block,
                [&](std::uint64_t word, std::uint64_t) {
                  const std::uint64_t l = word & even_bits, h = word >> 1 & even_bits;
                  sums[0] += even_ones(l & ~h);
                  sums[1] += even_ones(h & ~l);
                  sums[2] += even_ones(h & l);
                });
      for (std::size_t k = 0; k < 3; ++k) n[k + 1] += sum_of_bytes(sums[k]);
    }
  }
  n[0] = count - n[1] - n[2] - n[3];
  return n;
}

Substitutions substitutions(std::span<const std::uint8_t> was, std::span<const std::uint8_t> is,
                            std::uint64_t count) {
  const std::uint64_t size = packed_bytes(count, Format::four_state);
  require(was.size() >= size && is.size() >= size, "micromap::substitutions: too few bytes");
  Substitutions found;
  std::uint64_t at = 0;
  each_word(was, 2 * count, [&](std::uint64_t a, std::uint64_t mask) {
    const std::size_t left = static_cast<std::size_t>(size - at);
    const std::uint64_t b = load(is.data() + at, left < 8 ? left : 8) & mask;
    at += 8;
    const auto plane = [&](std::uint64_t word, unsigned s) {
      const std::uint64_t l = s & 1 ? word : ~word, h = s & 2 ? word >> 1 : ~(word >> 1);
      return l & h & even_bits & mask;
    };
    for (unsigned s = 0; s < 4; ++s) {
      const std::uint64_t here = plane(a, s);
      for (unsigned t = 0; t < 4; ++t)
        found.count[s][t] += static_cast<std::uint64_t>(std::popcount(here & plane(b, t)));
    }
  });
  return found;
}

namespace {

// Whether only `these` substitutions happened; bit 4 was + is.
bool only(const std::array<StateCounts, 4>& count, std::uint32_t these) {
  for (unsigned s = 0; s < 4; ++s)
    for (unsigned t = 0; t < 4; ++t)
      if (count[s][t] != 0 && (these >> (4 * s + t) & 1) == 0) return false;
  return true;
}

// The sets of substitutions: rows UO, UT, O, T from the left, each with its columns UO, UT, O, T.
constexpr std::uint32_t allowed_pairs = 0b1100'1100'1110'1101, conservative_pairs = 0b1000'0100'1110'1101,
                        force2_stable_pairs = 0b1000'0100'1010'0101;

}  // namespace

bool Substitutions::allowed() const noexcept { return only(count, allowed_pairs); }
bool Substitutions::conservative() const noexcept { return only(count, conservative_pairs); }
bool Substitutions::force2_stable() const noexcept { return only(count, force2_stable_pairs); }

}  // namespace mmverify::impl::micromap
