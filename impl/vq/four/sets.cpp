#include "impl/vq/four/sets.hpp"

#include <algorithm>
#include <cstring>

#include "impl/vq/four/layout.hpp"

namespace mmverify::impl::vq::detail {
namespace {

/// Whether these regions have one palette.
constexpr bool one_palette(Set4 v, std::uint32_t regions) {
  return (v & regions) == 0 || (v & regions << 16) == 0;
}

constexpr std::uint32_t left = 0x3333, right = 0xcccc, low = 0x00ff, high = 0xff00;

constexpr bool simple(Set4 v) { return one_palette(v, 0xffff); }
constexpr bool vertical(Set4 v) { return one_palette(v, left) && one_palette(v, right); }
constexpr bool horizontal(Set4 v) { return one_palette(v, low) && one_palette(v, high); }

/// The greatest part of a set with one palette in each half; of equal ones T.
constexpr Set4 in_halves(Set4 v, std::uint32_t first, std::uint32_t second) {
  Set4 out = 0;
  for (const std::uint32_t half : {first, second}) {
    const Set4 t = v & half, o = v & half << 16;
    out |= size(o) > size(t) ? o : t;
  }
  return out;
}

/// The place to which a transform moves region k.
constexpr auto moves = [] {
  std::array<std::array<std::uint8_t, 16>, 8> table{};
  for (std::uint32_t t = 0; t < 8; ++t)
    for (std::uint32_t k = 0; k < 16; ++k) table[t][k] = static_cast<std::uint8_t>(moved<4>(t, k));
  return table;
}();

constexpr std::uint32_t opaque(Set4 v, std::uint32_t regions) { return (v & regions << 16) != 0 ? 1 : 0; }

/// The code of a set at index 3 + place.  Domain: the set fits there.
std::uint32_t code_of(std::size_t place, Set4 v) {
  const std::uint32_t checked = ~(v | v >> 16) & 0xffff;
  switch (kind4[3 + place]) {
    case 0: return checked | opaque(v, 0xffff) << 16;
    case 1: return checked | opaque(v, left) << 16 | opaque(v, right) << 17;
    case 2: return checked | opaque(v, low) << 16 | opaque(v, high) << 17;
    default: break;
  }
  std::uint32_t code = 0;
  for (std::uint32_t mini = 0; mini < 4; ++mini) {
    const std::uint32_t corner = 2 * (mini % 2) + 8 * (mini / 2);
    const std::uint32_t bits = (checked >> corner & 3) | (checked >> (corner + 4) & 3) << 2;
    code |= (bits | opaque(v, 0x33u << corner) << 4) << (5 * mini);
  }
  return code;
}

std::uint32_t kept(std::span<const Set4> entries, std::span<const Set4> sources) {
  std::uint32_t sum = 0;
  for (const Set4 v : sources) {
    std::uint32_t most = 0;
    for (const Set4 e : entries)
      if ((e & ~v) == 0) most = std::max(most, size(e));
    sum += most;
  }
  return sum;
}

void put_code(Block4& block, std::size_t index, std::uint32_t code) {
  const std::uint32_t byte = std::min(code_at4[index] / 8u, 56u);
  std::uint64_t word;
  std::memcpy(&word, block.data() + byte, sizeof word);
  word |= std::uint64_t{code} << (code_at4[index] - 8 * byte);
  std::memcpy(block.data() + byte, &word, sizeof word);
}

}  // namespace

Vectors4 vectors_of(const Map4& map) {
  Vectors4 vectors{};
  for (std::uint32_t k = 0; k < 1024; ++k) {
    const std::uint32_t x = k % 32, y = k / 32, at = x % 4 + 4 * (y % 4);
    const Set4 state = map[k] == State::T ? 1u : map[k] == State::O ? 0x10000u : 0;
    vectors[x / 4 + 8 * (y / 4)] |= state << at;
  }
  return vectors;
}

Set4 codable(Set4 v) noexcept {
  for (const std::uint32_t mini : {0x0033u, 0x00ccu, 0x3300u, 0xcc00u}) {
    const Set4 t = v & mini, o = v & mini << 16;
    if (t != 0 && o != 0) v &= ~(size(t) < size(o) ? t : o);
  }
  return v;
}

std::array<Set4, 8> stored(Set4 v) noexcept {
  std::array<Set4, 8> out{};
  for (std::uint32_t t = 0; t < 8; ++t)
    for (std::uint32_t k = 0; k < 16; ++k) out[t] |= (v >> moves[t][k] & 0x10001u) << k;
  return out;
}

std::optional<Places> places_of(const std::vector<Set4>& entries) {
  Places places;
  places.fill(-1);
  if (entries.size() > stored_entries) return std::nullopt;
  std::size_t next_simple = 0, next_generic = 5;
  const auto take = [&](std::size_t place, std::int8_t k) {
    if (places[place] >= 0) return false;
    places[place] = k;
    return true;
  };
  const auto take_generic = [&](std::int8_t k) {
    return next_generic < stored_entries && take(next_generic++, k);
  };
  // Sets with fewer possible places choose first.
  for (const int round : {0, 1, 2, 3})
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const Set4 v = entries[e];
      const auto k = static_cast<std::int8_t>(e);
      const bool is_v = vertical(v), is_h = horizontal(v);
      if (round != (simple(v) ? 3 : is_v && is_h ? 2 : is_v || is_h ? 1 : 0)) continue;
      if (simple(v) && next_simple < 3) {
        places[next_simple++] = k;
        continue;
      }
      if ((is_v && take(3, k)) || (is_h && take(4, k)) || take_generic(k)) continue;
      return std::nullopt;
    }
  return places;
}

void fit_places(std::vector<Set4>& entries, std::span<const Set4> sources) {
  while (!places_of(entries)) {
    std::uint32_t most = 0;
    std::size_t at = 0;
    Set4 smaller = 0;
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const Set4 whole = entries[e];
      for (const Set4 part :
           {in_halves(whole, 0xffff, 0), in_halves(whole, left, right), in_halves(whole, low, high)}) {
        if (part == whole) continue;
        entries[e] = part;
        const std::uint32_t now = kept(entries, sources);
        if (smaller != 0 && now <= most) continue;
        most = now;
        at = e;
        smaller = part;
      }
      entries[e] = whole;
    }
    entries[at] = smaller;
  }
}

Encoded4 written(const Vectors4& vectors, const Transforms& transforms, const std::vector<Set4>& entries) {
  Encoded4 out{};
  const Places places = places_of(entries).value();
  std::uint32_t three = 0;
  for (std::uint32_t q = 1; q < 4; ++q) three |= std::uint32_t{transforms[q]} << (3 * (q - 1));
  out.block[32] = static_cast<std::uint8_t>(three);
  out.block[33] = static_cast<std::uint8_t>(three >> 8);
  for (std::size_t place = 0; place < stored_entries; ++place)
    if (places[place] >= 0)
      put_code(out.block, 3 + place, code_of(place, entries[static_cast<std::size_t>(places[place])]));

  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const Set4 v = vectors[vector];
    std::uint32_t index = static_cast<std::uint32_t>(State::C), most = 0;
    if (uniform(v)) {
      index = static_cast<std::uint32_t>(v == all_t ? State::T : v == all_o ? State::O : State::C);
      most = size(v);
    } else {
      const Set4 as_stored = stored(v)[transforms[quadrant_of_vector4(vector)]];
      for (std::uint32_t place = 0; place < stored_entries; ++place) {
        if (places[place] < 0) continue;
        const Set4 e = entries[static_cast<std::size_t>(places[place])];
        if ((e & ~as_stored) != 0 || size(e) <= most) continue;
        most = size(e);
        index = 3 + place;
      }
    }
    out.substitutions += size(v) - most;
    out.block[vector / 2] = static_cast<std::uint8_t>(out.block[vector / 2] | index << (4 * (vector % 2)));
  }
  return out;
}

}  // namespace mmverify::impl::vq::detail
