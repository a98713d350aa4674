// The limits of stored texels for alpha to be opaque, or not transparent, exactly.  Internal to impl/bake.
#pragma once

#include <array>
#include <cstdint>

#include "impl/bake/triangles.hpp"
#include "impl/common/binary.hpp"
#include "impl/common/wide.hpp"

namespace mmverify::impl::bake::detail {

/// A limit of a stored number r: slope r >= limit.  The slope is a product, not below 0; r is a multiple of 2^finest.
struct Limit {
  std::array<Binary, 3> slope;
  Binary limit;
};

/// The limits of an alpha mode.  Alpha is r / full times factors.  MASK at a cutoff c = n/d: opaque if
///   factors d r >= n full.
/// BLEND is opaque if that holds for c = 1, leans to opaque if it does for c = 1/2, and is not transparent if
/// factors r > 0, that is, if -r < 0 and no factor is 0.
struct Limits {
  Limit opaque, lean;
  bool blend = false;
  bool zero = false;  ///< a factor is 0, and so is alpha, whatever the texels
};

/// `full`: the stored number whose alpha is 1.
/// Errors: std::invalid_argument for a cutoff over 0 or not finite; factors not finite or below 0.
Limits limits_of(const AlphaMode& mode, const std::array<float, 2>& factors, std::int64_t full);

/// The height of a stored number: slope r - limit in units of 2^unit, of which all its terms are multiples.
template <class Int>
class Height {
 public:
  /// The height for a limit.  Domain: each r is a multiple of 2^finest.
  Height(const Limit& l, int finest) : finest_(finest) {
    const int slope_e = l.slope[0].e + l.slope[1].e + l.slope[2].e + finest;
    const int unit = l.limit.m == 0 ? slope_e : slope_e < l.limit.e ? slope_e : l.limit.e;
    slope_ = (Int(l.slope[0].m) * Int(l.slope[1].m) * Int(l.slope[2].m)) << (slope_e - unit);
    limit_ = l.limit.m == 0 ? Int(0) : Int(l.limit.m) << (l.limit.e - unit);
  }
  /// The height -r.
  explicit Height(int finest) : slope_(-1), limit_(0), finest_(finest) {}

  Int operator()(const Binary& r) const {
    return (r.m == 0 ? Int(0) : slope_ * (Int(r.m) << (r.e - finest_))) - limit_;
  }

 private:
  Int slope_, limit_;
  int finest_;
};

/// The bits of four heights' sum, with a sign, for |r| < 2^most.
inline int height_bits(const Limit& l, int finest, int most) noexcept {
  int slope = 0, slope_e = finest;
  for (const Binary& b : l.slope) {
    slope += bits(b.m);
    slope_e += b.e;
  }
  const int unit = l.limit.m == 0 || slope_e < l.limit.e ? slope_e : l.limit.e;
  const int left = slope + slope_e - finest + most - unit, right = bits(l.limit.m) + l.limit.e - unit;
  return (left > right ? left : right) + 4;
}

/// An integer wide enough for any height: slopes are from 2^-298 and below 2^(256+32), r from 2^-149 and below 2^128,
/// so the unit is at least 2^-447 and heights are below 2^(447+416); limits are below 2^144.
using AnyHeight = Wide<14>;

}  // namespace mmverify::impl::bake::detail
