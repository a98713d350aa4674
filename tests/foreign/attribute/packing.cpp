// Packed maps.
// Source: docs/ATTRIBUTE_COMPRESSION.md.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tests/foreign/attribute/places.hpp"

namespace mmverify::tests::foreign::attribute {
namespace {

using proofs::attribute::Bytes;
using proofs::attribute::ByteView;
using proofs::attribute::Compression;
using proofs::attribute::MapAt;
using proofs::attribute::PackedShape;
using proofs::attribute::ValueReader;
using Numbers = std::vector<std::int32_t>;

std::int32_t half(std::int32_t x) { return x >> 1; }  // down, of negative ones as well

std::size_t values_at(MapAt at, Level n) {
  return static_cast<std::size_t>(at == MapAt::faces ? std::uint64_t{1} << 2 * n : vertices_of(n));
}
std::size_t roots_at(MapAt at) { return at == MapAt::faces ? 1 : 3; }
std::size_t triples_at(MapAt at, Level m) { return (values_at(at, m) - values_at(at, m - 1)) / 3; }

// ---- Numbers and residuals

std::int32_t number_of(std::uint8_t code, std::int32_t e, Fault wrong) {
  if (wrong == number_without_its_half) return code / (2 * e + 1);
  if (wrong == number_of_even_steps && e > 0) return (code + e) / (2 * e);
  return (code + e) / (2 * e + 1);
}
std::uint8_t code_of(std::int32_t number, std::int32_t e, Fault wrong) {
  const std::int32_t code = number * (2 * e + 1);
  if (wrong == code_of_the_last_wraps) return static_cast<std::uint8_t>(code);
  return static_cast<std::uint8_t>(std::min(255, code));
}

std::int32_t parent_of(const std::array<std::int32_t, 4>& x, Fault wrong) {
  const std::int32_t s = half(x[0] + x[1]), t = half(x[2] + x[3]);
  return wrong == parent_rounds_down ? half(s + t) : half(s + t + 1);
}

/// The ends of the edge that a vertex of level m halves, by their places in Bird.
std::array<std::uint32_t, 2> ends_of(std::uint32_t x, Level m) {
  const Vertex at = vertex_of(VertexOrder::bird, m, x, none);
  Vertex a = at, b = at;
  if (at.i % 2 == 0)
    --a.j, ++b.j;
  else if (at.j % 2 == 0)
    --a.i, ++b.i;
  else
    --a.i, ++a.j, ++b.i, --b.j;
  return {index_of(VertexOrder::bird, m, a, none), index_of(VertexOrder::bird, m, b, none)};
}
std::int32_t predicted(const Numbers& values, std::uint32_t x, Level m, Fault wrong) {
  const auto [a, b] = ends_of(x, m);
  if (wrong == prediction_rounds_down) return half(values[a] + values[b]);
  if (wrong == prediction_of_first_end_from_4 && m >= 4) return values[a];
  return half(values[a] + values[b] + 1);
}

/// Residuals of levels 1 to n, and the roots.
struct Told {
  Numbers roots, residuals;
};

Told told(MapAt at, Level n, Numbers values, Fault wrong) {
  if (at == MapAt::vertices) {
    Told all{{values[0], values[1], values[2]}, {}};
    for (Level m = 1; m <= n; ++m)
      for (auto x = static_cast<std::uint32_t>(vertices_of(m - 1)); x < vertices_of(m); ++x)
        all.residuals.push_back(values[x] - predicted(values, x, m, wrong));
    return all;
  }
  std::vector<Numbers> levels(n + 1);
  for (Level m = n; m > 0; --m) {
    Numbers parents;
    for (std::size_t k = 0; k < values.size(); k += 4) {
      const std::array<std::int32_t, 4> x{values[k], values[k + 1], values[k + 2], values[k + 3]};
      const std::int32_t s = half(x[0] + x[1]), t = half(x[2] + x[3]);
      for (const std::int32_t r : {x[0] - x[1], x[2] - x[3], s - t}) levels[m].push_back(r);
      parents.push_back(parent_of(x, wrong));
    }
    values = parents;
  }
  Told all{values, {}};
  for (const Numbers& level : levels) all.residuals.insert(all.residuals.end(), level.begin(), level.end());
  return all;
}

/// The values of each level, the coarsest first.
std::vector<Numbers> values_from(MapAt at, Level n, const Told& all, Fault wrong) {
  std::vector<Numbers> levels{all.roots};
  std::size_t place = 0;
  for (Level m = 1; m <= n; ++m) {
    Numbers values = at == MapAt::vertices ? levels.back() : Numbers();
    if (at == MapAt::vertices) {
      for (auto x = static_cast<std::uint32_t>(vertices_of(m - 1)); x < vertices_of(m); ++x)
        values.push_back(predicted(levels.back(), x, m, wrong) + all.residuals[place++]);
    } else {
      for (const std::int32_t parent : levels.back()) {
        const std::int32_t ab = all.residuals[place], cd = all.residuals[place + 1],
                           st = all.residuals[place + 2];
        place += 3;
        std::int32_t t = wrong == parent_rounds_down ? parent - half(st) : parent - half(st + 1);
        if (wrong == children_halve_to_zero) t = parent - (st + 1) / 2;
        const std::int32_t s = t + st, b = s - half(ab), d = t - half(cd);
        values.insert(values.end(), {b + ab, b, d + cd, d});
      }
    }
    levels.push_back(std::move(values));
  }
  return levels;
}

// ---- Bytes

/// Triples of each block.
std::vector<std::size_t> blocks_of(MapAt at, Level n, Fault wrong) {
  std::vector<std::size_t> blocks;
  for (Level m = 1; m <= n; ++m) {
    if (m == 2 && wrong != blocks_of_levels_1_and_2) {
      blocks.back() += triples_at(at, 2);
      continue;
    }
    std::size_t left = triples_at(at, m);
    if (wrong == block_tail_joins_the_one_before && left > 16 && left % 16 != 0) {
      for (; left >= 32; left -= 16) blocks.push_back(16);
      blocks.push_back(left);
      continue;
    }
    for (; left > 0; left -= std::min<std::size_t>(left, 16))
      blocks.push_back(std::min<std::size_t>(left, 16));
  }
  return blocks;
}

std::uint32_t folded(std::int32_t r, Fault wrong) {
  if (wrong == folds_positive_to_odd && r != 0) r = -r;
  return static_cast<std::uint32_t>(r >= 0 ? 2 * r : -2 * r - 1);
}
std::int32_t unfolded(std::uint32_t x, Fault wrong) {
  std::int32_t r = x % 2 == 0 ? static_cast<std::int32_t>(x / 2) : -static_cast<std::int32_t>(x / 2) - 1;
  if (wrong == folds_positive_to_odd) r = -r;
  return r;
}

class Bits {
 public:
  Bits() = default;
  explicit Bits(ByteView bytes) : bytes_(bytes.begin(), bytes.end()), size_(8 * bytes_.size()) {}
  void put(std::uint32_t x, unsigned width) {
    for (unsigned k = 0; k < width; ++k, ++size_) {
      if (size_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | (x >> k & 1u) << size_ % 8);
    }
  }
  std::uint32_t take(unsigned width) {
    std::uint32_t x = 0;
    for (unsigned k = 0; k < width; ++k, ++taken_) x |= (bytes_[taken_ / 8] >> taken_ % 8 & 1u) << k;
    return x;
  }
  std::size_t size() const { return size_; }
  const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_ = {};
  std::size_t size_ = 0, taken_ = 0;
};

Bytes pack(const PackedShape& shape, ByteView codes, Fault wrong) {
  const std::size_t values = values_at(shape.at, shape.level), C = shape.channels;
  const std::vector<std::size_t> blocks = blocks_of(shape.at, shape.level, wrong);
  Bytes bytes;
  Bits starts, widths, bits;
  std::size_t block = 0;
  for (std::size_t map = 0; map < shape.maps; ++map) {
    std::vector<Told> channels;
    for (std::size_t c = 0; c < C; ++c) {
      Numbers numbers;
      for (std::size_t x = 0; x < values; ++x)
        numbers.push_back(number_of(codes[(map * values + x) * C + c], shape.error[c], wrong));
      channels.push_back(told(shape.at, shape.level, numbers, wrong));
    }
    for (std::size_t r = 0; r < roots_at(shape.at); ++r)
      for (std::size_t c = 0; c < C; ++c) bytes.push_back(static_cast<std::uint8_t>(channels[c].roots[r]));
    std::size_t first = 0;
    for (const std::size_t triples : blocks) {
      const std::size_t of_map = wrong == starts_count_each_map ? block % blocks.size() : block;
      if (of_map % 8 == 0) starts.put(static_cast<std::uint32_t>(bits.size()), 32);
      for (std::size_t c = 0; c < C; ++c) {
        unsigned width = 0;
        std::size_t looked_at = 3 * triples;
        if (wrong == width_misses_the_last_triple && triples > 1 && shape.level >= 4 && triples < 16)
          looked_at -= 3;
        for (std::size_t k = first; k < first + looked_at; ++k)
          for (std::uint32_t x = folded(channels[c].residuals[k], wrong); x >> width != 0;) ++width;
        if (wrong == width_at_least_1) width = std::max(width, 1u);
        if (wrong == width_8_for_9) width = std::min(width, 8u);
        widths.put(width, 4);
        for (std::size_t k = first; k < first + 3 * triples; ++k)
          bits.put(folded(channels[c].residuals[k], wrong), width);
      }
      first += 3 * triples;
      ++block;
    }
  }
  for (const Bits* part : {&starts, &widths, &bits})
    bytes.insert(bytes.end(), part->bytes().begin(), part->bytes().end());
  if (wrong == bits_in_whole_words && bytes.size() % 4 != 0 && shape.level >= 4)
    bytes.resize(bytes.size() / 4 * 4 + 4);
  return bytes;
}

/// The levels of each channel of each map.
using Opened = std::vector<std::vector<Numbers>>;

std::optional<Opened> opened(const PackedShape& shape, ByteView bytes, Fault wrong) {
  const std::vector<std::size_t> blocks = blocks_of(shape.at, shape.level, wrong);
  const std::size_t C = shape.channels, B = shape.maps * blocks.size(), R = roots_at(shape.at);
  const std::size_t roots = shape.maps * R * C;
  const std::size_t starts =
      4 * (wrong == starts_count_each_map ? shape.maps * ((blocks.size() + 7) / 8) : (B + 7) / 8);
  const std::size_t widths = (B * C + 1) / 2;
  if (bytes.size() < roots + starts + widths) return std::nullopt;
  Bits width(bytes.subspan(roots + starts, widths)), bits(bytes.subspan(roots + starts + widths));
  std::vector<unsigned> all;
  std::size_t needed = 0;
  for (std::size_t k = 0; k < B * C; ++k) {
    all.push_back(width.take(4));
    if (all.back() > 9) return std::nullopt;
    needed += 3 * blocks[k / C % blocks.size()] * all.back();
  }
  if (needed > bits.size()) return std::nullopt;
  Opened maps;
  std::size_t block = 0;
  for (std::size_t map = 0; map < shape.maps; ++map) {
    std::vector<Told> channels(C);
    for (std::size_t r = 0; r < R; ++r)
      for (std::size_t c = 0; c < C; ++c) channels[c].roots.push_back(bytes[(map * R + r) * C + c]);
    for (const std::size_t triples : blocks) {
      for (std::size_t c = 0; c < C; ++c)
        for (std::size_t k = 0; k < 3 * triples; ++k)
          channels[c].residuals.push_back(unfolded(bits.take(all[block * C + c]), wrong));
      ++block;
    }
    for (const Told& channel : channels) maps.push_back(values_from(shape.at, shape.level, channel, wrong));
  }
  return maps;
}

std::optional<Bytes> unpack(const PackedShape& shape, ByteView bytes, Fault wrong) {
  const auto maps = opened(shape, bytes, wrong);
  if (!maps) return std::nullopt;
  const std::size_t values = values_at(shape.at, shape.level), C = shape.channels;
  Bytes codes(shape.maps * values * C);
  for (std::size_t channel = 0; channel < maps->size(); ++channel)
    for (std::size_t x = 0; x < values; ++x) {
      const std::int32_t number = (*maps)[channel].back()[x], e = shape.error[channel % C];
      if (number < 0 || number > (255 + e) / (2 * e + 1)) return std::nullopt;
      codes[(channel / C * values + x) * C + channel % C] = code_of(number, e, wrong);
    }
  const Bytes again = pack(shape, codes, wrong);
  if (wrong == takes_longer_bytes && bytes.size() > again.size()) bytes = bytes.first(again.size());
  if (wrong == takes_any_unused_bits && bytes.size() == again.size() && !again.empty()) {
    // All but the last byte, which unused bits may be in.
    if (std::equal(again.begin(), again.end() - 1, bytes.begin())) return codes;
  }
  if (wrong == takes_any_start && bytes.size() == again.size()) {
    const std::size_t R = shape.maps * roots_at(shape.at) * C,
                      S = (shape.maps * blocks_of(shape.at, shape.level, none).size() + 7) / 8 * 4;
    Bytes with_starts(bytes.begin(), bytes.end());
    for (std::size_t k = R; k < R + S; ++k) with_starts[k] = again[k];
    if (with_starts == again) return codes;
  }
  if (wrong == takes_any_padding_of_widths && bytes.size() == again.size() && shape.channels % 2 == 1) {
    const std::size_t B = shape.maps * blocks_of(shape.at, shape.level, none).size();
    const std::size_t last = shape.maps * roots_at(shape.at) * C + (B + 7) / 8 * 4 + (B * C + 1) / 2 - 1;
    Bytes masked(bytes.begin(), bytes.end());
    if (B * C % 2 == 1) masked[last] &= 0x0f;
    if (masked == again) return codes;
  }
  if (wrong == takes_what_it_can_read) return codes;
  if (wrong != takes_longer_bytes && bytes.size() != again.size()) return std::nullopt;
  if (!std::equal(bytes.begin(), bytes.end(), again.begin(), again.end())) return std::nullopt;
  return codes;
}

ValueReader reader(const PackedShape& shape, ByteView bytes, Fault wrong) {
  const auto maps = std::make_shared<Opened>(opened(shape, bytes, wrong).value());
  return [=](std::uint32_t map, Level level, std::uint32_t index) {
    std::array<std::uint8_t, 4> codes{};
    for (std::size_t c = 0; c < shape.channels; ++c) {
      const std::vector<Numbers>& levels = (*maps)[map * shape.channels + c];
      if (wrong == reader_map_of_16 && map >= 16) return std::array<std::uint8_t, 4>{};
      std::uint32_t x = index;
      if (wrong == reader_last_value_of_5 && level == 5 && index + 1 == levels[5].size()) --x;
      std::int32_t number = levels[level][x];
      if (wrong == reader_lower_faces_by_mean && level < shape.level && shape.at == MapAt::faces) {
        const Numbers& above = levels[level + 1];
        number = half(half(above[4 * x] + above[4 * x + 1] + above[4 * x + 2] + above[4 * x + 3] + 2));
      }
      if (wrong == reader_lower_level_of_4 && level == 3 && shape.level >= 4 && shape.at == MapAt::vertices &&
          x > 40)
        number = levels[2][x % levels[2].size()];
      codes[c] = code_of(number, shape.error[c], wrong);
    }
    if (wrong == reader_fills_with_255)
      for (std::size_t c = shape.channels; c < 4; ++c) codes[c] = 255;
    return codes;
  };
}

}  // namespace

Compression packing_with(Fault wrong) {
  Compression f;
  f.pack = [=](const PackedShape& shape, ByteView codes) { return pack(shape, codes, wrong); };
  f.unpack = [=](const PackedShape& shape, ByteView bytes) { return unpack(shape, bytes, wrong); };
  f.reader = [=](const PackedShape& shape, ByteView bytes) { return reader(shape, bytes, wrong); };
  return f;
}

}  // namespace mmverify::tests::foreign::attribute
