// Texels of the three formats, and the border, read as whole numbers over one scale.
#include "tests/foreign/bake/texels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tests/foreign/bake/faults.hpp"

namespace mmverify::tests::foreign::bake {
namespace {

float texel_float(float x) {
  if (has(float_clamped)) return std::min(1.0F, std::max(0.0F, x));
  if (has(float_negative_is_0) && x < 0) return 0;
  if (has(float_to_16_bits) && x >= 0 && x <= 1) return std::round(x * 65535.0F) / 65535.0F;
  if (has(float_flushes) && std::fpclassify(x) == FP_SUBNORMAL) return 0;
  if (has(float_low_bit)) {
    std::uint32_t word;
    std::memcpy(&word, &x, 4);
    word &= ~1u;
    std::memcpy(&x, &word, 4);
  }
  return x;
}

}  // namespace

Stored read_texels(const mmverify_bake_case_t& c, const unsigned char* from, std::size_t count,
                   bool later_mip) {
  Stored s;
  s.values.reserve(count + 1);
  std::uint32_t border = c.border;
  if (has(border_of_mips_is_0) && later_mip) border = 0;
  if (c.texel == MMVERIFY_UNORM8) {
    s.full = has(unorm8_by_256) ? 256 : 255;
    for (std::size_t k = 0; k < count; ++k) s.values.emplace_back(from[k]);
    s.values.emplace_back(border & 0xffu);
  } else if (c.texel == MMVERIFY_UNORM16) {
    s.full = has(unorm16_high_byte) ? 255 : has(unorm16_by_65536) ? 65536 : 65535;
    const auto value = [](unsigned word) { return has(unorm16_high_byte) ? word >> 8 : word; };
    for (std::size_t k = 0; k < count; ++k) {
      std::uint16_t word;
      std::memcpy(&word, from + 2 * k, 2);
      s.values.emplace_back(value(word));
    }
    s.values.emplace_back(has(border_16_as_8) ? (border & 0xffu) * 257u : value(border & 0xffffu));
  } else {
    std::vector<Dyadic> all;
    all.reserve(count + 1);
    for (std::size_t k = 0; k <= count; ++k) {
      float x;
      if (k == count) {
        std::memcpy(&x, &border, 4);
        if (has(border_of_floats_is_0)) x = 0;
        const bool used = c.wrap_u == MMVERIFY_CLAMP_TO_BORDER || c.wrap_v == MMVERIFY_CLAMP_TO_BORDER;
        if (!used) x = 0;
      } else {
        std::memcpy(&x, from + 4 * k, 4);
      }
      all.push_back(dyadic(texel_float(x)));
    }
    s.exponent = 0;
    for (const Dyadic& d : all)
      if (d.mantissa != 0) s.exponent = std::min(s.exponent, d.exponent);
    for (const Dyadic& d : all) s.values.push_back(shifted(d, -s.exponent));
  }
  return s;
}

}  // namespace mmverify::tests::foreign::bake
