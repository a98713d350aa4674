// A baker of one mip level.  Internal to impl/bake.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "impl/bake/touched.hpp"
#include "impl/bake/triangles.hpp"

namespace mmverify::impl::bake::detail {

class MipBaker {
 public:
  virtual ~MipBaker() = default;
  /// TriangleBaker::bake_moving() for one mip level; the domain is not checked.
  /// Only: the nodes to bake; null: all.
  virtual BakeCounts bake(const MovingTriangle& uv, std::uint32_t level, std::uint8_t* map,
                          const std::vector<Node>* only) const = 0;
  /// Whether a box lies in the mip level.
  virtual bool holds(const Box& box) const = 0;
  /// Whether alpha at some place of a rectangle, in UV, may depend on a texel of the box.
  virtual bool may_read(const UvBox& places, const Box& box) const = 0;
};

/// Errors: std::invalid_argument as for TriangleBaker's constructor.
std::unique_ptr<const MipBaker> mip_baker(const Texels& texels, const AlphaMode& mode,
                                          const Sampling& sampling);

}  // namespace mmverify::impl::bake::detail
