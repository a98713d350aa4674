#include "impl/attribute/bake/codes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmverify::impl::attribute::detail {
namespace {

constexpr double full_light = 0x1p24;

/// 2^24 light(m / 510), to nearest.  It is never so near a half that binary64 errs: a law checks every m with exact
/// powers.
std::int32_t light(int m) {
  const double y = m / 510.0, x = y <= 0.04045 ? y / 12.92 : std::pow((y + 0.055) / 1.055, 2.4);
  return static_cast<std::int32_t>(std::floor(x * full_light + 0.5));
}

}  // namespace

const Curve& Curve::linear() {
  static const Curve curve = [] {
    Curve c;
    for (int k = 0; k < 256; ++k) {
      c.number[static_cast<std::size_t>(k)] = k;
      c.value[static_cast<std::size_t>(k)] = k;
      c.twice_least[static_cast<std::size_t>(k)] = k == 0 ? 0 : 2 * k - 1;
    }
    c.twice_least[256] = 512;
    return c;
  }();
  return curve;
}

const Curve& Curve::srgb() {
  static const Curve curve = [] {
    Curve c;
    for (int k = 0; k < 256; ++k) {
      c.number[static_cast<std::size_t>(k)] = light(2 * k);
      c.value[static_cast<std::size_t>(k)] = light(2 * k);
      c.twice_least[static_cast<std::size_t>(k)] = k == 0 ? 0 : 2 * light(2 * k - 1);
    }
    c.twice_least[256] = std::numeric_limits<std::int32_t>::max();
    c.full = full_light;
    c.most_off = 0x1p11;
    const auto number_of = [](std::uint64_t first_bits) {
      return std::bit_cast<double>(first_bits << Curve::bits_below);
    };
    const std::uint64_t last = std::bit_cast<std::uint64_t>(c.full) >> Curve::bits_below;
    std::uint64_t code = 0;
    for (std::uint64_t bits = Curve::first_bits; bits <= last; ++bits) {
      while (0.5 * c.twice_least[code + 1] < number_of(bits) - c.most_off) ++code;
      c.middles.push_back(std::bit_cast<std::uint64_t>(0.5 * c.twice_least[code + 1]) | code);
    }
    return c;
  }();
  return curve;
}

template <class Channel>
RgbaOf<Channel> encoded_normal(const std::array<double, 4>& means, const std::array<double, 4>& bound,
                               Meaning meaning, bool& sure) noexcept {
  // The rounding of binary64 for numbers up to `full`, with room.
  constexpr double full = greatest<Channel>, rounding = (full + 1) * 0x1p-48;
  RgbaOf<Channel> codes{};
  // docs/ATTRIBUTE_BOUNDS.md, "Normals".
  const double b = std::max({bound[0], bound[1], bound[2]});
  const double x = 2 * means[0] - full, y = 2 * means[1] - full, z = 2 * means[2] - full,
               length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 64 * b + 0x1p-20)) {
    sure = false;
    return codes;
  }
  const double direction_bound = rounding + full / 2 * 8 * (2 * b) / length;
  if (!(direction_bound < 0.25)) {
    sure = false;
    return codes;
  }
  const double scale = full / 2 / length;
  codes[0] = linear_code<Channel>(x * scale + full / 2, direction_bound, sure);
  codes[1] = linear_code<Channel>(y * scale + full / 2, direction_bound, sure);
  codes[2] = linear_code<Channel>(z * scale + full / 2, direction_bound, sure);
  codes[3] = meaning == Meaning::normal ? linear_code<Channel>(means[3], bound[3], sure)
             : length >= full           ? greatest<Channel>
                                        : linear_code<Channel>(length, rounding + 4 * b, sure);
  return codes;
}
template RgbaOf<std::uint8_t> encoded_normal(const std::array<double, 4>&, const std::array<double, 4>&,
                                             Meaning, bool&) noexcept;
template RgbaOf<std::uint16_t> encoded_normal(const std::array<double, 4>&, const std::array<double, 4>&,
                                              Meaning, bool&) noexcept;

}  // namespace mmverify::impl::attribute::detail
