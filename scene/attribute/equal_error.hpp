// What a coder takes at the error of something else.
#pragma once

#include <cstdint>
#include <span>

namespace mmverify::scene {

struct BytesAndError {
  double bytes = 0, error = 0;
};

/// Where an error lies among those of a coder's sizes.
enum class AmongSizes : std::uint8_t {
  within,
  coarsest_is_closer,  ///< even the fewest bytes have less error
  finest_is_farther,   ///< even the most bytes have more error
};

struct BytesAtError {
  AmongSizes where = AmongSizes::within;
  double bytes = 0;  ///< where within
};

/// Bytes b at error e between neighbours (b0, e0), (b1, e1) with e0 <= e < e1, on a straight line of logarithms:
///   b = b0 (b1/b0)^t,   t = log(e/e0) / log(e1/e0);   b0 where e0 = 0
/// Of several such neighbours those of the fewest bytes count.  At the last one's error: its bytes.
/// Domain: `sizes` from most to fewest bytes, at least one, bytes > 0, errors >= 0, error >= 0; else
/// std::invalid_argument.
BytesAtError bytes_at_error(std::span<const BytesAndError> sizes, double error);

}  // namespace mmverify::scene
