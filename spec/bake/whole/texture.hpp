// A texture whose texels are whole numbers, with a bit for each texel and each side of alpha.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "spec/bake/whole/sides.hpp"

namespace mmverify::spec::bake::whole {

/// Rows of bits.
class BitRows {
 public:
  BitRows() = default;
  BitRows(std::uint32_t width, std::uint32_t height)
      : words_((std::size_t{width} + 63) / 64), bits_(words_ * height) {}

  void set(std::uint32_t i, std::uint32_t j) { bits_[j * words_ + i / 64] |= std::uint64_t{1} << i % 64; }
  bool at(std::uint32_t i, std::uint32_t j) const { return (bits_[j * words_ + i / 64] >> i % 64 & 1) != 0; }
  /// Whether one of the bits first..last of row j is set.  Domain: first <= last, below the width.
  bool any(std::uint32_t j, std::uint32_t first, std::uint32_t last) const {
    const std::uint64_t* const row = bits_.data() + j * words_;
    const std::size_t from = first / 64, to = last / 64;
    const std::uint64_t head = ~std::uint64_t{0} << first % 64, tail = ~std::uint64_t{0} >> (63 - last % 64);
    if (from == to) return (row[from] & head & tail) != 0;
    if ((row[from] & head) != 0 || (row[to] & tail) != 0) return true;
    for (std::size_t k = from + 1; k < to; ++k)
      if (row[k] != 0) return true;
    return false;
  }

 private:
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

/// wrapped(), at once for an index that every mode leaves as it is.
inline std::optional<std::uint32_t> texel_index(Wrap wrap, std::int64_t i, std::uint32_t size) {
  if (i >= 0 && i < std::int64_t{size}) return static_cast<std::uint32_t>(i);
  return wrapped(wrap, i, size);
}

/// The wrapped indices first..last; none is the border.
struct Run {
  std::optional<std::uint32_t> first, last;
};

/// Calls take(run) for runs that together mean the texels of an interval, each at most twice.
template <class Take>
void for_each_run(Wrap wrap, const Interval& indices, std::uint32_t size, Take take) {
  const std::int64_t n = size;
  if (indices.first >= 0 && indices.last < n)
    return take(Run{static_cast<std::uint32_t>(indices.first), static_cast<std::uint32_t>(indices.last)});
  const Interval all = distinct(wrap, indices, size);
  for (std::int64_t i = all.first; i <= all.last;) {
    const std::int64_t tile = i >= 0 ? i / n : -((n - 1 - i) / n),
                       last = std::min(all.last, tile * n + n - 1);
    // Within a tile the wrapped indices go up or down by one, or stay.
    const auto p = texel_index(wrap, i, size), q = texel_index(wrap, last, size);
    take(Run{std::min(p, q), std::max(p, q)});
    i = last + 1;
  }
}

/// A texture as integers: each texel as a side of the cutoff or a number, scaled once.
class WholeTexture {
 public:
  /// The mode is Mask, MaskAbove or Blend, in rationals.  Domain: a texture that outlives this object.
  /// Errors: std::invalid_argument for a texture whose texels are not width x height or none, or a factor that is not
  /// finite.
  template <class Texel, class Mode>
  WholeTexture(const TextureOf<Texel>& t, const Mode& mode)
      : width_(t.width),
        height_(t.height),
        wrap_x_(t.wrap_x),
        wrap_y_(t.wrap_y),
        filter_(t.filter),
        texels_(t.alpha) {
    if (t.alpha.empty() || t.alpha.size() != static_cast<std::size_t>(t.width) * t.height)
      throw std::invalid_argument("bake: the texels are not width x height");
    Rational unit = stored_unit(t);
    if (!is_supported_) return;
    for (const Binary32 factor : {t.factor, t.vertex_factor}) unit *= number<Rational>(factor);
    for (const AlphaSide& side : whole::sides(mode)) sides_.emplace_back(side, unit);
    border_ = stored(t.border);
    mark_all();
  }

  /// Whether all texels are whole multiples, of 62 bits, of one number.
  bool is_supported() const { return is_supported_; }
  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  Filter filter() const { return filter_; }
  Wrap wrap_y() const { return wrap_y_; }
  const StoredSide& side(std::size_t k) const { return sides_[k]; }
  /// The bits of the greatest height of any texel over any side.
  int height_bits() const { return height_bits_; }

  /// The stored number of a texel, wrapped.
  std::int64_t stored_at(std::int64_t i, std::int64_t j) const {
    const auto x = texel_index(wrap_x_, i, width_), y = texel_index(wrap_y_, j, height_);
    return x && y ? stored_at(*x + std::size_t{*y} * width_) : border_;
  }
  /// The marks of a texel, wrapped.
  Marks marks_at(std::int64_t i, std::int64_t j) const {
    const auto x = texel_index(wrap_x_, i, width_), y = texel_index(wrap_y_, j, height_);
    return x && y ? (sets_[0].at(*x, *y) ? not_opaque : 0u) | (sets_[1].at(*x, *y) ? not_transparent : 0u)
                  : border_marks_;
  }
  /// The marks that some of the texels of a row have.
  Marks marks_in_row(std::int64_t j, const Interval& columns) const {
    const auto row = texel_index(wrap_y_, j, height_);
    if (!row) return border_marks_;
    Marks found = 0;
    for_each_run(wrap_x_, columns, width_, [&](const Run& run) {
      if (!run.first)
        found |= border_marks_;
      else
        for (std::size_t k = 0; k < 2; ++k)
          if (sets_[k].any(*row, *run.first, *run.last)) found |= 1u << k;
    });
    return found;
  }

 private:
  using Texels =
      std::variant<std::span<const std::uint8_t>, std::span<const std::uint16_t>, std::span<const Binary32>>;

  /// The number that all texels are multiples of.
  static Rational stored_unit(const TextureOf<std::uint8_t>&) { return {1, 255}; }
  static Rational stored_unit(const TextureOf<std::uint16_t>&) { return {1, 65535}; }
  Rational stored_unit(const TextureOf<Binary32>& t) {
    int least = std::numeric_limits<int>::max(), greatest = std::numeric_limits<int>::min();
    const auto take = [&](Binary32 texel) {
      if ((texel.bits >> 23 & 255) == 255) {
        is_supported_ = false;
        return;
      }
      const Dyadic x = dyadic(texel);
      if (x.m == 0) return;
      least = std::min(least, x.e);
      greatest = std::max(greatest, x.e + bit_length(x.m));
    };
    for (const Binary32 texel : t.alpha) take(texel);
    take(t.border);
    if (least > greatest) least = greatest = 0;
    is_supported_ = is_supported_ && greatest - least <= most_stored_bits;
    exponent_ = least;
    return scaled(1, least);
  }

  static std::int64_t stored(std::uint8_t texel) { return texel; }
  static std::int64_t stored(std::uint16_t texel) { return texel; }
  std::int64_t stored(Binary32 texel) const {
    const Dyadic x = dyadic(texel);
    return x.m == 0 ? 0 : x.m * (std::int64_t{1} << (x.e - exponent_));
  }
  std::int64_t stored_at(std::size_t k) const {
    return std::visit([&](const auto& texels) { return stored(texels[k]); }, texels_);
  }

  void mark_all() {
    const Interval of[2] = {sides_[0].numbers(), sides_[1].numbers()};
    const auto is_in = [](const Interval& some, std::int64_t v) { return some.first <= v && v <= some.last; };
    std::int64_t least = border_, greatest = border_;
    sets_ = {BitRows(width_, height_), BitRows(width_, height_)};
    std::visit(
        [&](const auto& texels) {
          for (std::uint32_t j = 0; j < height_; ++j)
            for (std::uint32_t i = 0; i < width_; ++i) {
              const std::int64_t v = stored(texels[i + std::size_t{j} * width_]);
              least = std::min(least, v);
              greatest = std::max(greatest, v);
              for (std::size_t k = 0; k < 2; ++k)
                if (is_in(of[k], v)) sets_[k].set(i, j);
            }
        },
        texels_);
    for (std::size_t k = 0; k < 2; ++k)
      if (is_in(of[k], border_)) border_marks_ |= 1u << k;
    for (const StoredSide& side : sides_)
      for (const std::int64_t v : {least, greatest})
        height_bits_ = std::max(height_bits_, bit_length(side.height(v)));
    for (const StoredSide& side : sides_)
      height_bits_ = std::max(
          {height_bits_, bit_length(side.a) + most_stored_bits_of(least, greatest), bit_length(side.b)});
  }
  static int most_stored_bits_of(std::int64_t least, std::int64_t greatest) {
    return std::max(bit_length(least), bit_length(greatest));
  }

  static constexpr int most_stored_bits = 62;

  std::uint32_t width_, height_;
  Wrap wrap_x_, wrap_y_;
  Filter filter_;
  Texels texels_;
  int exponent_ = 0;
  bool is_supported_ = true;
  std::vector<StoredSide> sides_;
  std::array<BitRows, 2> sets_;
  std::int64_t border_ = 0;
  Marks border_marks_ = 0;
  int height_bits_ = 0;
};

}  // namespace mmverify::spec::bake::whole
