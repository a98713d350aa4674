// How an answer to one block is judged: the whole map, every region in its order, and regions in others.
#pragma once

#include <numeric>

#include "proofs/vq/fields.hpp"
#include "proofs/vq/law_parts.hpp"
#include "proofs/vq/texts.hpp"

namespace mmverify::proofs::vq {

/// The regions that each transform fills the regions of a vector from.
template <std::size_t side>
const std::array<std::array<std::uint8_t, side * side>, 8>& sources() {
  static const auto table = [] {
    std::array<std::array<std::uint8_t, side * side>, 8> all{};
    for (std::uint32_t t = 0; t < 8; ++t)
      for (std::uint32_t k = 0; k < side * side; ++k) {
        const spec::vq::Region at{k % static_cast<std::uint32_t>(side), k / static_cast<std::uint32_t>(side)},
            from = spec::vq::filled_from<side>(Transform::of(t), at);
        all[t][k] = static_cast<std::uint8_t>(from.x + side * from.y);
      }
    return all;
  }();
  return table;
}

/// The specification's map, each entry decoded once.
template <class Format>
Map<Format> specified(const Format& fields) {
  constexpr std::size_t side = Format::side, indices = std::size_t{1} << Format::index_bits;
  const auto& from = sources<side>();
  std::array<std::array<Vector<side>, indices>, 4> turned;
  for (std::uint32_t index = 0; index < indices; ++index)
    for (std::size_t q = 0; q < 4; ++q) {
      const Vector<side> entry = fields.entry(static_cast<spec::vq::Quadrant>(q), index);
      for (std::size_t k = 0; k < side * side; ++k)
        turned[q][index][k] = entry[from[fields.transforms[q].number()][k]];
    }
  Map<Format> map;
  for (std::size_t vector = 0; vector < 64; ++vector) {
    const std::size_t X = vector % 8, Y = vector / 8;
    const auto q = static_cast<std::size_t>(
        spec::vq::quadrant_of(static_cast<std::uint32_t>(X), static_cast<std::uint32_t>(Y)));
    const Vector<side>& v = turned[q][fields.indices[vector]];
    for (std::size_t y = 0; y < side; ++y)
      std::copy_n(v.begin() + static_cast<std::ptrdiff_t>(side * y), side,
                  map.begin() + static_cast<std::ptrdiff_t>(side * X + 8 * side * (side * Y + y)));
  }
  return map;
}

template <class Format>
Finding wrong_region(const char* who, std::size_t region, State expected, State got) {
  return wrong(
      fmt::format("{} region {},{} {}", who, region % (8 * Format::side), region / (8 * Format::side),
                  letters({&expected, 1})),
      static_cast<unsigned>(got) < 3 ? letters({&got, 1}) : fmt::format("{}", static_cast<unsigned>(got)));
}

/// A number each region, and a call for its columns and rows.
template <class Format>
struct Coordinates {
  std::vector<std::uint32_t> regions, x, y;

  explicit Coordinates(std::vector<std::uint32_t> of) : regions(std::move(of)) {
    for (const std::uint32_t k : regions) {
      x.push_back(k % (8 * Format::side));
      y.push_back(k / (8 * Format::side));
    }
  }
  /// The regions [begin, end), in one call.
  Finding asked(const char* who, const Codec<Format>& codec, const BlockBytes<Format>& block,
                const Map<Format>& expected, std::size_t begin, std::size_t end) const {
    Map<Format> got;
    codec.regions(block, std::span(x).subspan(begin, end - begin), std::span(y).subspan(begin, end - begin),
                  std::span(got).first(end - begin));
    for (std::size_t k = begin; k < end; ++k)
      if (got[k - begin] != expected[regions[k]])
        return wrong_region<Format>(who, regions[k], expected[regions[k]], got[k - begin]);
    return {};
  }
  Finding asked(const char* who, const Codec<Format>& codec, const BlockBytes<Format>& block,
                const Map<Format>& expected) const {
    return asked(who, codec, block, expected, 0, regions.size());
  }
};

template <class Format>
const Coordinates<Format>& everywhere() {
  static const Coordinates<Format> all([] {
    std::vector<std::uint32_t> regions(std::tuple_size_v<Map<Format>>);
    std::iota(regions.begin(), regions.end(), 0u);
    return regions;
  }());
  return all;
}

/// The whole map, where it is decoded; what the block means.
template <class Format>
Finding decoded(const Codec<Format>& codec, const BlockBytes<Format>& block, Map<Format>& expected) {
  expected = specified(spec::vq::from_bytes<Format>(block));
  if (!codec.decode) return {};
  const Map<Format> got = codec.decode(block);
  if (got == expected) return {};
  const auto k =
      static_cast<std::size_t>(std::mismatch(got.begin(), got.end(), expected.begin()).first - got.begin());
  return wrong_region<Format>("decoded", k, expected[k], got[k]);
}

/// Both ways to decode, all regions row by row in one call.
template <class Format>
Finding decodes(const VqSubject& s, const BlockBytes<Format>& block) {
  const Codec<Format>& codec = s.functions.codec<Format>();
  Map<Format> expected;
  if (Finding whole = decoded<Format>(codec, block, expected); !whole.holds) return whole;
  if (codec.regions)
    if (Finding all = everywhere<Format>().asked("asked for", codec, block, expected); !all.holds) return all;
  return {hash_of(block)};
}

/// Both ways to decode, regions in orders that the block's bits choose: a region alone, again in a call of up to
/// 40, some of them twice in turn, then all of them by steps of an odd width.
template <class Format>
Finding decodes_in_any_order(const VqSubject& s, const BlockBytes<Format>& block) {
  const Codec<Format>& codec = s.functions.codec<Format>();
  Map<Format> expected;
  if (Finding whole = decoded<Format>(codec, block, expected); !whole.holds) return whole;
  const std::uint64_t hash = hash_of(block);
  if (!codec.regions) return {hash};
  constexpr std::uint64_t size = std::tuple_size_v<Map<Format>>;
  std::uint64_t bits = hash;
  const auto below = [&](std::uint64_t limit) {
    bits = bits * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>((bits >> 32) * limit >> 32);
  };
  std::vector<std::uint32_t> some(1 + below(40));
  for (std::size_t k = 0; k < some.size(); ++k) some[k] = k > 0 && below(4) == 0 ? some[k - 1] : below(size);
  const Coordinates<Format> few(some);
  if (Finding alone = few.asked("asked alone for", codec, block, expected, 0, 1); !alone.holds) return alone;
  if (Finding found = few.asked("asked among few for", codec, block, expected); !found.holds) return found;
  const std::uint32_t first = below(size), step = 2 * below(size / 2) + 1;
  std::vector<std::uint32_t> all(size);
  for (std::uint32_t k = 0; k < size; ++k) all[k] = (first + step * k) % size;
  if (Finding found = Coordinates<Format>(all).asked("asked in another order for", codec, block, expected);
      !found.holds)
    return found;
  return {hash};
}

}  // namespace mmverify::proofs::vq
