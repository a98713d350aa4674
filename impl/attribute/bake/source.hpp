// A texture made ready: its texels by wrapped index, and the sums of its rows.  Internal to impl/attribute.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "impl/attribute/bake/floats.hpp"
#include "impl/bake/texture/wrap.hpp"

namespace mmverify::impl::attribute::detail {

/// Texels [left, left + width) x [top, top + height), before wrapping.
struct TexelBox {
  std::int64_t left, top, width, height;
};

/// Sums of a box's rows: at 4 (i + pitch j) + k, the values of channel k of texels 0 .. i-1 of row j, i in 0..width.
/// Sum: float where all sums are below 2^24, or double; exact in both, but for texels that are floats: those sums are
/// within 1.01 u of the greatest that |texels| allow, u = 2^-53 (source.cpp).
template <class Sum>
struct RowSums {
  const Sum* first;
  std::size_t pitch;
};

/// A view of it, how it is read, and what its channels mean.
template <class Channel>
class Source {
 public:
  using View = RgbaViewOf<Channel>;
  using Sampling = AttributeSamplingOf<Channel>;

  Source(const View& texture, const Sampling& sampling);

  const View& texture() const { return texture_; }
  const Sampling& sampling() const { return sampling_; }
  const Coding<Channel>& coding() const { return coding_; }

  /// Column, or row, of the picture; -1: the border.
  std::int64_t column(std::int64_t i) const noexcept {
    return bake::detail::wrapped(sampling_.u, i, texture_.width);
  }
  std::int64_t row(std::int64_t j) const noexcept {
    return bake::detail::wrapped(sampling_.v, j, texture_.height);
  }
  /// The four channels of a texel by what column() and row() give.
  const Channel* texel(std::int64_t x, std::int64_t y) const noexcept {
    return x < 0 || y < 0 ? sampling_.border.data()
                          : texture_.texels + 4 * (static_cast<std::size_t>(x) +
                                                   static_cast<std::size_t>(y) * texture_.pitch);
  }

  /// Where a box's first texel lies in the picture, if the box leaves it nowhere.
  struct InPicture {
    std::int64_t x, y;
  };
  std::optional<InPicture> in_picture(const TexelBox& box) const noexcept;

  /// The greatest size of each channel in a box: of codes, what it may be; of floats, what it is.
  std::array<double, 4> greatest_in(const TexelBox& box) const noexcept;

  /// The sums of a box's rows, in `room`.
  template <class Sum>
  RowSums<Sum> sums(const TexelBox& box, std::vector<Sum>& room) const;
  /// Those of the whole picture, from a texel of it on; made on the first call.
  template <class Sum>
  RowSums<Sum> sums_from(const InPicture& at) const;

 private:
  template <class Sum>
  std::vector<Sum>& kept() const;
  template <class Sum>
  void add_row(std::int64_t y, std::int64_t left, std::int64_t width, Sum* to) const;

  View texture_;
  Sampling sampling_;
  Coding<Channel> coding_;
  mutable std::once_flag once_;
  mutable std::vector<float> floats_;
  mutable std::vector<double> doubles_;
};

}  // namespace mmverify::impl::attribute::detail
