// The bytes that a coder needs to reach a given error.
#pragma once

#include <cstdint>
#include <span>

namespace mmverify::scene {

struct BytesAndError {
  double bytes = 0, error = 0;
};

/// The position of an error among the errors of a coder's sizes.
enum class AmongSizes : std::uint8_t {
  within,
  coarsest_is_closer,  ///< even the fewest bytes have less error
  finest_is_farther,   ///< even the most bytes have more error
};

struct BytesAtError {
  AmongSizes where = AmongSizes::within;
  double bytes = 0;  ///< if within
};

/// Bytes b at error e between neighbours (b0, e0), (b1, e1) with e0 <= e < e1, on a straight line of
/// logarithms:
///   b = b0 (b1/b0)^t,   t = log(e/e0) / log(e1/e0);   b0 if e0 = 0
/// If several neighbours fit, the pair with the fewest bytes counts.  At the error of the last size: its
/// bytes.
/// Domain: `sizes` from most to fewest bytes, at least one, bytes > 0, errors >= 0, error >= 0; else
/// std::invalid_argument.
BytesAtError bytes_at_error(std::span<const BytesAndError> sizes, double error);

}  // namespace mmverify::scene
