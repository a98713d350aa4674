// Topic vq: an encoder of 32x32 maps that takes what keeps the most next.
// Source: Compressed Opacity Maps, 5.1, table 2 and 5.2.
#include <map>
#include <mutex>
#include <utility>

#include "tests/foreign/inside/encode.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::vq;

/// The sets of regions that have one palette each in the entry of an index.
std::span<const std::uint32_t> parts_of(std::uint32_t index) {
  static constexpr std::uint32_t simple[] = {0xffff}, vertical[] = {0x3333, 0xcccc},
                                 horizontal[] = {0x00ff, 0xff00},
                                 generic[] = {0x0033, 0x00cc, 0x3300, 0xcc00};
  if (index < 6) return simple;
  if (index == 6) return vertical;
  if (index == 7) return horizontal;
  return generic;
}

/// The regions of a vector that an entry can hold: each part keeps only its O or only its T, whichever are more.
Masks held(const Masks& source, std::uint32_t index) {
  Masks out;
  for (const std::uint32_t part : parts_of(index)) {
    const std::uint32_t o = source.o & part, t = source.t & part;
    (std::popcount(o) >= std::popcount(t) ? out.o : out.t) |= std::popcount(o) >= std::popcount(t) ? o : t;
  }
  return out;
}
std::uint32_t code(const Masks& e, std::uint32_t index) {
  const std::uint32_t checked = ~(e.o | e.t) & 0xffff;
  std::uint32_t out = 0, part = 0;
  for (const std::uint32_t regions : parts_of(index)) {
    const std::uint32_t flag = (e.o & regions) != 0 ? 1 : 0;
    if (index < 8) {
      out |= (checked & regions) | flag << (16 + part);
    } else {
      const std::uint32_t corner = part % 2 * 2 + part / 2 * 8, at = checked >> corner;
      out |= ((at & 3) | (at >> 2 & 12) | flag << 4) << 5 * part;
    }
    ++part;
  }
  return out;
}
unsigned keeps(const Masks& entry, const Masks& source) {
  if ((entry.o & ~source.o) != 0 || (entry.t & ~source.t) != 0) return 0;
  return static_cast<unsigned>(std::popcount(entry.o | entry.t));
}

Masks vector_at(const Map<Vq4>& map, std::uint32_t v, std::uint32_t transform) {
  Masks m;
  for (std::uint32_t k = 0; k < 16; ++k) {
    const std::uint32_t to = taken(results[transform], 4, k);
    const State s = map[v % 8 * 4 + to % 4 + 32 * (v / 8 * 4 + to / 4)];
    m.o |= static_cast<std::uint32_t>(s == State::O) << k;
    m.t |= static_cast<std::uint32_t>(s == State::T) << k;
  }
  return m;
}
std::uint32_t quadrant(std::uint32_t v) { return (v % 8 < 4 ? 0u : 1u) + (v / 8 < 4 ? 2u : 0u); }

Solved4 under(const Map<Vq4>& map, const std::array<std::uint32_t, 4>& transforms, const Search4& search) {
  std::array<Masks, 64> source;
  std::array<unsigned, 64> kept{};
  Solved4 out;
  unsigned known = 0;
  for (std::size_t q = 0; q < 4; ++q) out.block.transforms[q] = Transform::of(transforms[q]);
  for (std::uint32_t v = 0; v < 64; ++v) {
    source[v] = vector_at(map, v, transforms[quadrant(v)]);
    known += static_cast<unsigned>(std::popcount(source[v].o | source[v].t));
    const bool o = source[v].o == 0xffff, t = source[v].t == 0xffff;
    kept[v] = o || t ? 16 : 0;
    out.block.indices[v] = o ? 2 : t ? 0 : 1;
  }
  for (const std::uint32_t index : {8u, 9u, 10u, 11u, 12u, 13u, 14u, 15u, 6u, 7u, 3u, 4u, 5u}) {
    const auto takes = [&](std::uint32_t v, const Masks& e) {
      const unsigned k = index == search.unused && quadrant(v) == search.unused_in ? 0 : keeps(e, source[v]);
      return k > kept[v] ? k - kept[v] : 0;
    };
    Masks best;
    unsigned most = 0;
    for (std::uint32_t s = 0; s < 64; ++s) {
      if (kept[s] == 16) continue;
      const Masks e = held(source[s], index);
      unsigned gain = 0;
      for (std::uint32_t v = 0; v < 64; ++v) gain += takes(v, e);
      if (gain > most) {
        most = gain;
        best = e;
      }
    }
    out.block.codebook[index - 3] = code(best, index);
    for (std::uint32_t v = 0; v < 64; ++v)
      if (const unsigned gain = takes(v, best); gain > 0) {
        kept[v] += gain;
        out.block.indices[v] = static_cast<std::uint8_t>(index);
      }
  }
  unsigned sum = 0;
  for (const unsigned k : kept) sum += k;
  out.lost = known - sum;
  return out;
}

Solved4 tried(const Map<Vq4>& map, const Search4& search) {
  std::array<std::uint32_t, 4> at{};
  Solved4 best = under(map, at, search);
  for (std::uint32_t q = 1; q < 4 && !search.identity_alone && best.lost > 0; ++q) {
    std::uint32_t chosen = 0;
    for (std::uint32_t t = 1; t < 8; ++t) {
      if (q == search.quadrant && t == search.untried) continue;
      at[q] = t;
      if (const Solved4 now = under(map, at, search); now.lost < best.lost) {
        best = now;
        chosen = t;
      }
    }
    at[q] = chosen;
  }
  return best;
}

}  // namespace

Solved4 solved(const Map<Vq4>& map, const Search4& search) {
  // The laws ask of the same maps again and again.
  static std::map<std::pair<Search4, Map<Vq4>>, Solved4> known;
  static std::mutex guard;
  const std::pair key(search, map);
  {
    const std::lock_guard lock(guard);
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  const Solved4 answer = tried(map, search);
  const std::lock_guard lock(guard);
  return known[key] = answer;
}

}  // namespace mmverify::tests::foreign
