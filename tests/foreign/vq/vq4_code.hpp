// VQ4: where the entries of the codebook stand.
#pragma once

namespace mmverify::tests::foreign::vq {

struct Code {
  int first, count;
};

/// The place and the bits of the entry of an index 3 to 15: table 2.
inline Code vq4_code(unsigned index) {
  const int i = static_cast<int>(index);
  if (i < 6) return {265 + 17 * (i - 3), 17};
  if (i < 8) return {316 + 18 * (i - 6), 18};
  return {352 + 20 * (i - 8), 20};
}

}  // namespace mmverify::tests::foreign::vq
