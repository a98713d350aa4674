// A baker of one mip level.  Internal to impl/bake.
#pragma once

#include <cstdint>
#include <memory>

#include "impl/bake/triangles.hpp"

namespace mmverify::impl::bake::detail {

class MipBaker {
 public:
  virtual ~MipBaker() = default;
  /// TriangleBaker::bake() for one mip level; the domain is not checked.
  virtual BakeCounts bake(const BaseTriangle& uv, std::uint32_t level, std::uint8_t* map) const = 0;
};

/// Errors: std::invalid_argument as for TriangleBaker's constructor.
std::unique_ptr<const MipBaker> mip_baker(const Texels& texels, const AlphaMode& mode,
                                          const Sampling& sampling);

}  // namespace mmverify::impl::bake::detail
