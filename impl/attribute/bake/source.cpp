// A sum of floats is kept in two numbers: the rounded sum, and what rounding took from it so far (Knuth: exact).  The
// stored sum is within 1.01 u m n for n texels up to m: docs/ATTRIBUTE_BOUNDS.md, "A face of floats".
#include "impl/attribute/bake/source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace mmverify::impl::attribute::detail {

namespace {

template <class View>
const View& checked(const View& texture) {
  if (texture.width == 0 || texture.width > 16384 || texture.height == 0 || texture.height > 16384)
    throw std::invalid_argument("attribute: a texture has 1 to 16384 texels along each side");
  return texture;
}

}  // namespace

template <class Channel>
Source<Channel>::Source(const View& texture, const Sampling& sampling)
    : texture_(checked(texture)), sampling_(sampling), coding_(texture, sampling) {}

template <class Channel>
std::array<double, 4> Source<Channel>::greatest_in(const TexelBox& box) const noexcept {
  std::array<double, 4> greatest{};
  if constexpr (std::is_same_v<Channel, float>) {
    const std::optional<InPicture> at = in_picture(box);
    for (std::int64_t j = 0; j < box.height; ++j) {
      const std::int64_t y = at ? at->y + j : row(box.top + j);
      for (std::int64_t i = 0; i < box.width; ++i) {
        const float* const from = texel(at ? at->x + i : column(box.left + i), y);
        for (std::size_t k = 0; k < 4; ++k) greatest[k] = std::max(greatest[k], std::fabs(double{from[k]}));
      }
    }
  } else {
    for (std::size_t k = 0; k < 4; ++k) greatest[k] = coding_.full(k);
  }
  return greatest;
}

template <class Channel>
std::optional<typename Source<Channel>::InPicture> Source<Channel>::in_picture(
    const TexelBox& box) const noexcept {
  const auto moved = [](Wrap wrap, std::int64_t at, std::int64_t n) {
    return wrap == Wrap::repeat && (at < 0 || at >= n) ? bake::detail::modulo(at, n) : at;
  };
  const std::int64_t x = moved(sampling_.u, box.left, texture_.width),
                     y = moved(sampling_.v, box.top, texture_.height);
  if (x < 0 || x + box.width > texture_.width || y < 0 || y + box.height > texture_.height)
    return std::nullopt;
  return InPicture{x, y};
}

template <class Channel>
template <class Sum>
void Source<Channel>::add_row(std::int64_t y, std::int64_t left, std::int64_t width, Sum* to) const {
  std::array<Sum, 4> sum{};
  std::array<double, 4> rest{};  // of floats
  const auto put = [&](const Channel* from) {
    for (std::size_t k = 0; k < 4; ++k) {
      if constexpr (std::is_same_v<Channel, float>) {
        *to++ = sum[k] + rest[k];
        const double x = double{from[k]}, next = sum[k] + x, taken = next - sum[k];
        rest[k] += (sum[k] - (next - taken)) + (x - taken);
        sum[k] = next;
        continue;
      }
      *to++ = sum[k];
      if constexpr (std::is_same_v<Sum, float>)
        sum[k] += static_cast<Sum>(from[k]);  // linear: the code is the number
      else
        sum[k] += coding_.value(from[k], k);
    }
  };
  if (y >= 0 && left >= 0 && left + width <= texture_.width) {
    const Channel* const from = texel(left, y);
    for (std::int64_t i = 0; i < width; ++i) put(from + 4 * i);
  } else {
    for (std::int64_t i = 0; i < width; ++i) put(texel(column(left + i), y));
  }
  for (std::size_t k = 0; k < 4; ++k)
    if constexpr (std::is_same_v<Channel, float>)
      *to++ = sum[k] + rest[k];
    else
      *to++ = sum[k];
}

template <class Channel>
template <class Sum>
RowSums<Sum> Source<Channel>::sums(const TexelBox& box, std::vector<Sum>& room) const {
  const auto pitch = static_cast<std::size_t>(box.width) + 1, rows = static_cast<std::size_t>(box.height);
  if (room.size() < 4 * pitch * rows) room.resize(4 * pitch * rows);
  const std::optional<InPicture> at = in_picture(box);
  for (std::size_t j = 0; j < rows; ++j) {
    const auto down = static_cast<std::int64_t>(j);
    add_row(at ? at->y + down : row(box.top + down), at ? at->x : box.left, box.width,
            room.data() + 4 * pitch * j);
  }
  return {room.data(), pitch};
}

template <class Channel>
template <class Sum>
std::vector<Sum>& Source<Channel>::kept() const {
  if constexpr (std::is_same_v<Sum, float>)
    return floats_;
  else
    return doubles_;
}

template <class Channel>
template <class Sum>
RowSums<Sum> Source<Channel>::sums_from(const InPicture& at) const {
  std::call_once(once_, [&] {
    sums(TexelBox{0, 0, std::int64_t{texture_.width}, std::int64_t{texture_.height}}, kept<Sum>());
  });
  const std::size_t pitch = std::size_t{texture_.width} + 1;
  return {kept<Sum>().data() + 4 * (static_cast<std::size_t>(at.x) + static_cast<std::size_t>(at.y) * pitch),
          pitch};
}

template class Source<std::uint8_t>;
template RowSums<float> Source<std::uint8_t>::sums(const TexelBox&, std::vector<float>&) const;
template RowSums<double> Source<std::uint8_t>::sums(const TexelBox&, std::vector<double>&) const;
template RowSums<float> Source<std::uint8_t>::sums_from(const InPicture&) const;
template RowSums<double> Source<std::uint8_t>::sums_from(const InPicture&) const;
template class Source<std::uint16_t>;
template RowSums<double> Source<std::uint16_t>::sums(const TexelBox&, std::vector<double>&) const;
template RowSums<double> Source<std::uint16_t>::sums_from(const InPicture&) const;
template class Source<float>;
template RowSums<double> Source<float>::sums(const TexelBox&, std::vector<double>&) const;

}  // namespace mmverify::impl::attribute::detail
