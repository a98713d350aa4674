// A texture made ready: its texels by wrapped index, and the sums of its rows.  Internal to impl/attribute.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// The sums of a box's rows: at 4 (i + pitch j) + k, the values of channel k of texels 0 .. i-1 of row j, i in
/// 0..width.  Sum is float if all sums are below 2^24, else double.  Sums of codes are exact.  Sums of float texels are
/// within 1.01 u of the greatest sum that |texels| allow, u = 2^-53 (docs/ATTRIBUTE_BOUNDS.md, "A face of floats").
template <class Sum>
struct RowSums {
  const Sum* first;
  std::size_t pitch;
};

/// A view of a texture, its sampling, and the coding of its channels.
template <class Channel>
class Source {
 public:
  using View = RgbaViewOf<Channel>;
  using Sampling = AttributeSamplingOf<Channel>;

  Source(const View& texture, const Sampling& sampling);

  const View& texture() const { return texture_; }
  const Sampling& sampling() const { return sampling_; }
  const Coding<Channel>& coding() const { return coding_; }

  /// The column, or row, of the picture; -1 means the border.
  std::int64_t column(std::int64_t i) const noexcept { return bake::wrapped(sampling_.u, i, texture_.width); }
  std::int64_t row(std::int64_t j) const noexcept { return bake::wrapped(sampling_.v, j, texture_.height); }
  /// The four channels of the texel at a column() and a row().
  const Channel* texel(std::int64_t x, std::int64_t y) const noexcept {
    return x < 0 || y < 0 ? sampling_.border.data()
                          : texture_.texels + 4 * (static_cast<std::size_t>(x) +
                                                   static_cast<std::size_t>(y) * texture_.pitch);
  }

  /// The place of a box's first texel in the picture, if the whole box lies in the picture.
  struct InPicture {
    std::int64_t x, y;
  };
  std::optional<InPicture> in_picture(const TexelBox& box) const noexcept;

  /// The greatest size of each channel in a box: for codes the greatest possible, for floats the actual one.
  std::array<double, 4> greatest_in(const TexelBox& box) const noexcept;

  /// The sums of a box's rows, made in `room`.
  template <class Sum>
  RowSums<Sum> sums(const TexelBox& box, std::vector<Sum>& room) const;
  /// The sums of the whole picture, from texel `at` on; made on the first call.
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
