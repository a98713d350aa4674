// The exact states of a base triangle's micro-triangles.  Internal to impl/bake.
#pragma once

#include <array>
#include <cstdint>

#include "impl/bake/exact/closing.hpp"
#include "impl/bake/plane/points.hpp"
#include "impl/bake/texture/properties.hpp"
#include "impl/bake/triangles.hpp"
#include "impl/common/binary.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::bake::detail {

class ExactBase {
 public:
  /// Domain: finite coordinates below 2^20 in size; level in 0..12; a dilation in [0, 2^35)
  /// whose sides are multiples of 2^-149.
  ExactBase(const TextureProperties& sides, const BaseTriangle& uv, std::uint32_t width, std::uint32_t height,
            index::Level level, Filter filter = Filter::bilinear, const Dilation& dilation = {});

  struct Answer {
    Marks marks;  ///< both, or the only mark of the micro-triangle
    bool leans_to_opaque;
  };
  /// The answer for micro-triangle `index` on the curve.  `known` is both, if texels within it already bear both marks.
  Answer operator()(std::uint32_t index, Marks known = 0) const;

  /// The closings of the edges of micro-triangles, and of lines along the axes.
  const Closings& closings() const noexcept { return closings_; }

 private:
  using Axis = std::array<Binary, 3>;

  template <class Int>
  Answer in(const index::Corners& corners, Marks known) const;
  template <class Int>
  std::array<Int, 3> along(const Axis& axis, std::uint32_t texels, const index::Corners& corners) const;

  void take_closings();

  const TextureProperties& sides_;
  Axis u_, v_;
  std::uint32_t width_, height_;
  int level_;
  Filter filter_;
  Binary dilate_x_, dilate_y_;
  int below_point_ = 1;  ///< bits of u and v below the point, at least 1 for half a texel
  std::int64_t cells_;   ///< cells that a micro-triangle spans, at most
  Closings closings_;
  int bits_;  ///< bits that impl/bake/exact/seen.hpp and positions need
};

}  // namespace mmverify::impl::bake::detail
