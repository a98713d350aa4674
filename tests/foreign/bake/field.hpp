// The texels of a mip, as whole numbers whose sign is that of alpha - threshold.
#pragma once

#include <cstddef>
#include <vector>

#include "tests/foreign/bake/numbers.hpp"

namespace mmverify::tests::foreign::bake {

enum Sign : unsigned { negative = 1, zero = 2, positive = 4 };
inline Sign sign_bit(int s) { return s < 0 ? negative : s > 0 ? positive : zero; }

/// The texels of one mip and, last, the border, as whole numbers whose sign is that of alpha - threshold and
/// which differ from that by one positive factor.
struct Field {
  std::vector<Wide> small;
  std::vector<Big> large;
  std::vector<double> approximate;  // the same over the greatest: within -1..1
  std::vector<unsigned char> signs;
  bool fits = true;
  int size_bits = 0;

  template <class T>
  T value(std::size_t k) const {
    return fits ? to<T>(small[k]) : to<T>(large[k]);
  }
};

struct Mip {
  Index width = 0, height = 0;
  std::size_t count = 0;  // of texels; the border comes after them
  std::vector<Field> fields;
};

}  // namespace mmverify::tests::foreign::bake
