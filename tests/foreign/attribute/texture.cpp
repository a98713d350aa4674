// Source: docs/ATTRIBUTE_BAKE.md, "What a value is"; Vulkan's addressing modes; IEC 61966-2-1.
#include "tests/foreign/attribute/texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mmverify::tests::foreign::attribute {

using proofs::attribute::Wrap;

std::optional<std::uint32_t> wrapped(std::int64_t i, std::uint32_t size, Wrap wrap, Fault wrong) {
  const std::int64_t n = size;
  const auto modulo = [](std::int64_t a, std::int64_t b) { return (a % b + b) % b; };
  switch (wrap) {
    case Wrap::repeat:
      if (wrong == repeat_of_negatives_mirrors && i < 0) return static_cast<std::uint32_t>(-i % n);
      if (wrong == repeat_by_mask) return static_cast<std::uint32_t>(i & (n - 1)) % size;
      return static_cast<std::uint32_t>(modulo(i, n));
    case Wrap::mirrored_repeat: {
      std::int64_t m = modulo(i, 2 * n);
      if (wrong == mirror_about_the_last_centre && n > 1) {
        m = modulo(i, 2 * n - 2);
        return static_cast<std::uint32_t>(m < n ? m : 2 * n - 2 - m);
      }
      if (wrong == mirror_from_the_third_repeat && (i >= 2 * n || i < -n)) m = modulo(i, n);
      return static_cast<std::uint32_t>(m < n ? m : 2 * n - 1 - m);
    }
    case Wrap::clamp_to_border:
      if (wrong == border_one_late_on_the_far_side && i == n) return size - 1;
      if (i < 0 || i >= n) return std::nullopt;
      return static_cast<std::uint32_t>(i);
    case Wrap::mirror_once:
      if (i < 0) i = wrong == mirror_once_by_sign ? -i : -1 - i;
      return static_cast<std::uint32_t>(std::min(i, n - 1));
    case Wrap::clamp_to_edge: return static_cast<std::uint32_t>(std::clamp<std::int64_t>(i, 0, n - 1));
  }
  return std::nullopt;
}

const Rgba& texel(const Picture& p, std::int64_t i, std::int64_t j, Fault wrong) {
  const auto x = wrapped(i, p.width, p.wrap_u, wrong);
  const auto y = wrapped(j, p.height, wrong == wrap_v_is_wrap_u ? p.wrap_u : p.wrap_v, wrong);
  if (wrong == border_needs_both_axes && (x || y))
    return p.texels[x.value_or(0) + std::size_t{p.width} * y.value_or(0)];
  if (!x || !y) return p.border;
  if (wrong == rows_of_the_next_power && p.width == 5) return p.texels[(*x + 8 * *y) % p.texels.size()];
  return p.texels[*x + std::size_t{p.width} * *y];
}

std::uint32_t light_at(std::uint32_t m, Fault wrong) {
  const long double y = static_cast<long double>(m) / 510;
  const bool without_line =
      wrong == (m % 2 == 0 ? srgb_decodes_without_its_line : srgb_encodes_without_its_line);
  const long double knee = without_line ? -1 : wrong == srgb_knee_of_light ? 0.0031308L : 0.04045L;
  long double light = y <= knee ? y / 12.92L : std::pow((y + 0.055L) / 1.055L, 2.4L);
  if (wrong == srgb_gamma_of_22) light = std::pow(y, 2.2L);
  if (wrong == srgb_middles_of_light && m % 2 == 1)
    return (light_at(m - 1, none) + light_at(m + 1, none) + 1) / 2;
  if (wrong == srgb_table_truncated) return static_cast<std::uint32_t>(std::ldexp(light, 24));
  if (wrong == srgb_table_of_binary32)
    return static_cast<std::uint32_t>(std::lround(
        std::ldexp(std::pow((static_cast<float>(y) + 0.055f) / 1.055f, 2.4f), 24) * (y > knee ? 1.0f : 0.0f) +
        (y > knee ? 0.0f : static_cast<float>(std::ldexp(light, 24)))));
  if (wrong == srgb_one_entry && m == 300)
    return static_cast<std::uint32_t>(std::lround(std::ldexp(light, 24))) + 1;
  return static_cast<std::uint32_t>(std::lround(std::ldexp(light, 24)));
}

namespace {

/// The greatest code whose threshold is reached.  Domain: thresholds that rise.
template <class Reached>
std::uint8_t last_code(Reached reached) {
  int low = 0, high = 256;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (reached(middle) ? low : high) = middle;
  }
  return static_cast<std::uint8_t>(low);
}

template <class Q>
std::uint8_t linear_code(const Q& x, Fault wrong) {
  const Q scaled = x * ratio<Q>(255, 1);
  if (wrong == code_half_down) return static_cast<std::uint8_t>(-floor_of(Q(ratio<Q>(1, 2) - scaled)));
  if (wrong == code_half_to_even) {
    const std::int64_t up = floor_of(Q(scaled + ratio<Q>(1, 2)));
    return static_cast<std::uint8_t>(scaled + ratio<Q>(1, 2) == ratio<Q>(up, 1) ? up & ~std::int64_t{1} : up);
  }
  if (wrong == code_of_256ths)
    return static_cast<std::uint8_t>(std::min<std::int64_t>(255, floor_of(Q(x * ratio<Q>(256, 1)))));
  return static_cast<std::uint8_t>(floor_of(Q(scaled + ratio<Q>(1, 2))));
}

template <class Q>
std::uint8_t srgb_code(const Q& light, Fault wrong) {
  const Q scaled = light * ratio<Q>(1 << 24, 1);
  if (wrong == srgb_code_above_its_threshold)
    return last_code([&](int c) {
      return c == 0 || scaled > ratio<Q>(light_at(static_cast<std::uint32_t>(2 * c - 1), none), 1);
    });
  if (wrong == srgb_code_by_nearest_light) {
    int best = 0;
    for (int c = 1; c < 256; ++c)
      if (2 * scaled >= ratio<Q>(std::int64_t{light_at(static_cast<std::uint32_t>(2 * c), none)} +
                                     light_at(static_cast<std::uint32_t>(2 * c - 2), none),
                                 1))
        best = c;
    return static_cast<std::uint8_t>(best);
  }
  return last_code([&](int c) {
    return c == 0 || scaled >= ratio<Q>(light_at(static_cast<std::uint32_t>(2 * c - 1), wrong), 1);
  });
}

}  // namespace

template <class Q>
Rgba codes_of(const Picture& p, const Shares<Q>& shares, Fault wrong) {
  std::array<Q, 4> mean;
  for (std::size_t c = 0; c < 4; ++c) mean[c] = mean_of(p, c, shares, wrong);
  if (wrong == alpha_weighs_colours && p.meaning == Meaning::linear && mean[3] != 0 && mean[3] != 1)
    mean[0] = mean[0] * mean[3];
  Rgba codes{};
  const bool srgb = p.meaning == Meaning::srgb;
  if (srgb || p.meaning == Meaning::linear) {
    for (std::size_t c = 0; c < 4; ++c)
      codes[c] = srgb && (c < 3 || wrong == alpha_on_the_curve) ? srgb_code(mean[c], wrong)
                                                                : linear_code(mean[c], wrong);
    return codes;
  }
  const Q square = mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2];
  for (std::size_t c = 0; c < 3; ++c) {
    const Q& a = mean[c];
    // The code c begins where a / |m| is (2c - 256) / 255.
    codes[c] = last_code([&](int code) {
      if (code == 0) return true;
      const Q t = ratio<Q>(2 * code - 256, 255);
      if (wrong == normals_keep_their_length) return a >= t;
      if (wrong == normals_in_double)
        return static_cast<double>(static_cast<float>(
                   boost::rational_cast<double>(wide(a)) /
                   std::sqrt(boost::rational_cast<double>(wide(square))))) >= (2 * code - 256) / 255.0;
      if (a >= 0) return t <= 0 || a * a >= t * t * square;
      return t < 0 && a * a <= t * t * square;
    });
  }
  if (square == 0)
    codes = wrong == normal_of_nothing_is_128 ? Rgba{128, 128, 128, 0} : Rgba{128, 128, 255, 0};
  if (p.meaning == Meaning::normal)
    codes[3] = linear_code(mean[3], wrong);
  else
    codes[3] = last_code([&](int code) {
      const Q t = ratio<Q>(2 * code - 1, 510);
      if (wrong == length_is_squared) return code == 0 || square >= t;
      if (wrong == length_truncated) return code == 0 || square >= ratio<Q>(code, 255) * ratio<Q>(code, 255);
      return code == 0 || square >= t * t;
    });
  return codes;
}

template Rgba codes_of(const Picture&, const Shares<Rational>&, Fault);
template Rgba codes_of(const Picture&, const Shares<Rational128>&, Fault);

}  // namespace mmverify::tests::foreign::attribute
