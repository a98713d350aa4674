#include "scene/bake/texel_ranges.hpp"

#include <optional>
#include <variant>

#include "impl/bake/texture/wrap.hpp"
#include "scene/bake/wrap.hpp"

namespace mmverify::scene {
namespace {

constexpr int bits_of_step = 2;          ///< squares are four of the next smaller ones a side
constexpr std::int64_t most_a_side = 8;  ///< of squares, or texels, that are looked at one by one

std::int64_t floored_quotient(std::int64_t k, std::int64_t n) { return k / n - (k % n < 0 ? 1 : 0); }

}  // namespace

std::vector<IndexRange> wrapped_ranges(Wrap wrap, const IndexRange& indices, std::int64_t size) {
  const auto at = [&](std::int64_t k) { return impl::bake::wrapped(wrap_of(wrap), k, size); };
  const std::int64_t first = at(indices.first), last = at(indices.last);
  if (wrap == Wrap::clamp_to_edge) return {{first, last}};
  if (indices.last - indices.first + 1 >= size) return {{0, size - 1}};
  const std::int64_t period = floored_quotient(indices.first, size);
  const bool is_within_one = period == floored_quotient(indices.last, size);
  if (wrap == Wrap::repeat) {
    if (is_within_one) return {{first, last}};
    return {{first, size - 1}, {0, last}};
  }
  if (is_within_one) return {{std::min(first, last), std::max(first, last)}};
  // Mirrored, even periods go up to the last texel, where the next one begins; odd ones go down to the first.
  if (period % 2 == 0) return {{std::min(first, last), size - 1}};
  return {{0, std::max(first, last)}};
}

TexelRanges::TexelRanges(const Image& image) : image_(image) {
  std::int64_t across = image.width, down = image.height;
  while (across > most_a_side || down > most_a_side) {
    const std::int64_t wide = across, high = down;
    across = (across + 3) >> bits_of_step;
    down = (down + 3) >> bits_of_step;
    Squares squares{across, {}};
    const Squares* const smaller = squares_.empty() ? nullptr : &squares_.back();
    for (std::int64_t y = 0; y < down; ++y)
      for (std::int64_t x = 0; x < across; ++x) {
        const auto at = [&](std::int64_t i, std::int64_t j) {
          if (smaller != nullptr) return smaller->all[static_cast<std::size_t>(i + smaller->across * j)];
          return TexelRange{texel(i, j), texel(i, j)};
        };
        TexelRange all = at(4 * x, 4 * y);
        for (std::int64_t j = 4 * y; j < std::min(4 * y + 4, high); ++j)
          for (std::int64_t i = 4 * x; i < std::min(4 * x + 4, wide); ++i) all.take(at(i, j));
        squares.all.push_back(all);
      }
    squares_.push_back(std::move(squares));
  }
}

float TexelRanges::texel(std::int64_t x, std::int64_t y) const {
  const auto at = static_cast<std::size_t>(x + std::int64_t{image_.width} * y);
  return std::visit([at](const auto& alpha) { return static_cast<float>(alpha[at]); }, image_.alpha);
}

TexelRange TexelRanges::within(IndexRange columns, IndexRange rows) const {
  std::size_t k = 0;
  while (columns.last - columns.first >= most_a_side || rows.last - rows.first >= most_a_side) {
    ++k;
    columns = {columns.first >> bits_of_step, columns.last >> bits_of_step};
    rows = {rows.first >> bits_of_step, rows.last >> bits_of_step};
  }
  const auto at = [&](std::int64_t x, std::int64_t y) {
    if (k == 0) return TexelRange{texel(x, y), texel(x, y)};
    return squares_[k - 1].all[static_cast<std::size_t>(x + squares_[k - 1].across * y)];
  };
  TexelRange all = at(columns.first, rows.first);
  for (std::int64_t y = rows.first; y <= rows.last; ++y)
    for (std::int64_t x = columns.first; x <= columns.last; ++x) all.take(at(x, y));
  return all;
}

TexelRange TexelRanges::of(const IndexRange& columns, const IndexRange& rows, const Sampler& sampler) const {
  std::optional<TexelRange> all;
  for (const IndexRange& across : wrapped_ranges(sampler.wrap_u, columns, image_.width))
    for (const IndexRange& down : wrapped_ranges(sampler.wrap_v, rows, image_.height)) {
      const TexelRange some = within(across, down);
      if (all)
        all->take(some);
      else
        all = some;
    }
  return all.value();
}

}  // namespace mmverify::scene
