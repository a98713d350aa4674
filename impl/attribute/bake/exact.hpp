// One micro-vertex or micro-triangle in whole numbers: always exact, and the slowest.  Internal to impl/attribute.
#pragma once

#include <array>
#include <cstdint>

#include "impl/attribute/bake/source.hpp"
#include "impl/common/binary.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::attribute::detail {

/// The exact values of a base triangle.
template <class Channel>
class Exact {
 public:
  /// Domain: that of AttributeBaker; for faces at most 2^15 texels along an axis.
  Exact(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level);

  RgbaOf<Channel> vertex(const index::Vertex& at) const;
  RgbaOf<Channel> face(const index::Corners& corners) const;

 private:
  using Axis = std::array<Binary, 3>;

  template <class Int>
  Int along(const Axis& axis, std::uint32_t texels, const index::Vertex& at) const;
  template <class Int>
  RgbaOf<Channel> vertex_in(const index::Vertex& at) const;
  template <class Int>
  RgbaOf<Channel> face_in(const index::Corners& corners) const;

  const Source<Channel>& source_;
  Axis u_, v_;
  int level_;
  int below_point_ = 1;  ///< bits of u and v below the point, at least 1 for half a texel
  int cell_bits_;        ///< bits of the number of texels that a micro-triangle spans at most
};

}  // namespace mmverify::impl::attribute::detail
