#include "proofs/bake/domains/spans.hpp"

#include <cmath>

#include "proofs/engine/random.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr std::uint64_t span_stream = 0x7370616e;
constexpr std::int64_t shortest = 8, longest = 20;  ///< of a span, as powers of two
constexpr int span_parts = 8;                       ///< corners lie at multiples of 1/8 of a texel

void draw_small_texture(Random& random, Case& one) {
  // Sides of powers of two keep coordinates exact.
  const auto side = [&] {
    return static_cast<std::uint32_t>(random.below(2) != 0 ? 1u << random.below(6) : 1 + random.below(12));
  };
  one.width = side();
  one.height = side();
  const auto cutoff = static_cast<std::uint32_t>(1 + random.below(255));
  one.cutoff = {cutoff, 255};
  const std::uint64_t palette = random.below(4), rare = 1 + random.below(16);
  one.alpha.clear();
  for (std::uint32_t k = 0; k < one.width * one.height; ++k)
    one.alpha.push_back(static_cast<std::uint32_t>(
        palette == 0   ? random.below(256)
        : palette == 1 ? 255 * random.below(2)
        : palette == 2 ? (random.below(rare) == 0 ? cutoff - 1 : cutoff)  // one side but for a few texels
                       : (random.below(rare) == 0 ? cutoff : cutoff - 1)));
  one.filter = static_cast<Filter>(random.below(2));
  one.border = static_cast<std::uint32_t>(random.below(256));
}

/// A whole number of texels: a power of two, and up to 4 more or fewer.
struct Span {
  std::int64_t power, more;
  std::int64_t texels() const { return (std::int64_t{1} << power) + more; }
};
Span any_span(Random& random) { return {random.between(shortest, longest), random.between(-4, 4)}; }

struct Corner {
  std::int64_t x, y;  ///< in 1/8 of a texel
};

float uv_at(std::int64_t along, std::uint32_t size) {
  return static_cast<float>(static_cast<double>(along) / (static_cast<double>(span_parts) * size));
}

void place_corners(Case& one, const std::array<Corner, 3>& corners) {
  for (std::size_t k = 0; k < 3; ++k) {
    one.uv[2 * k] = uv_at(corners[k].x, one.width);
    one.uv[2 * k + 1] = uv_at(corners[k].y, one.height);
  }
}

}  // namespace

Case span_sample(std::uint64_t seed, Level n, std::uint64_t k) {
  Random random(seed, span_stream + n, k);
  Case one;
  draw_small_texture(random, one);
  one.wrap_u = static_cast<Wrap>(random.below(5));
  one.wrap_v = static_cast<Wrap>(random.below(5));
  Span u = any_span(random), v = any_span(random);
  if (k % 4 == 3) v = u = {random.between(16, longest), random.between(-4, 4)};
  const std::int64_t side = std::int64_t{1} << n, x = u.texels() * span_parts * side,
                     y = v.texels() * span_parts * side;
  // The first corner is anywhere about the texture; a mirrored triangle is as likely.
  const auto about = [&](std::uint32_t size) {
    return random.between(-2 * span_parts, 2 * span_parts) * size / 2;
  };
  const Corner p{about(one.width), about(one.height)};
  const std::int64_t sign_x = random.below(2) != 0 ? 1 : -1, sign_y = random.below(2) != 0 ? 1 : -1;
  // Three of four have legs along the axes; the others are sheared.
  const std::int64_t shear_x = random.below(4) == 0 ? random.between(-x, x) : 0,
                     shear_y = random.below(4) == 0 ? random.between(-y / 4, y / 4) : 0;
  place_corners(one, {p, {p.x + sign_x * x, p.y + shear_y}, {p.x + shear_x, p.y + sign_y * y}});
  return one;
}

const char* span_samples_text() {
  return "textures of up to 32x32 texels, any addressing, both filters: micro-triangles across 2^8 to 2^20 "
         "texels along each axis, and up to 4 more or fewer; a quarter as long along both; up to 96 "
         "micro-triangles of each";
}

Case whole_period_sample(std::uint64_t seed, Level n, std::uint64_t k) {
  Random random(seed, span_stream + 64 + n, k);
  Case one;
  draw_small_texture(random, one);
  one.width = 1u << random.below(6);
  one.height = 1u << random.below(6);
  one.alpha.resize(std::size_t{one.width} * one.height, one.alpha.front());
  one.wrap_u = random.below(2) != 0 ? Wrap::repeat : Wrap::mirrored_repeat;
  one.wrap_v = random.below(2) != 0 ? Wrap::repeat : Wrap::mirrored_repeat;
  const std::int64_t side = std::int64_t{1} << n;
  const auto leg = [&](Wrap wrap, std::uint32_t size) {
    const std::int64_t period = (wrap == Wrap::repeat ? 1 : 2) * std::int64_t{size} * span_parts;
    return side * (2 * period + random.between(0, 4) * period + random.between(0, period));
  };
  const std::int64_t x = leg(one.wrap_u, one.width), y = leg(one.wrap_v, one.height);
  const Corner p{random.between(-4 * span_parts, 4 * span_parts),
                 random.between(-4 * span_parts, 4 * span_parts)};
  const std::int64_t sign_x = random.below(2) != 0 ? 1 : -1, sign_y = random.below(2) != 0 ? 1 : -1;
  place_corners(one, {p, {p.x + sign_x * x, p.y}, {p.x, p.y + sign_y * y}});
  return one;
}

const char* whole_period_samples_text() {
  return "textures of up to 32x32 texels that repeat along both axes, both filters: triangles whose legs lie "
         "along "
         "the axes; each micro-triangle holds a whole period";
}

}  // namespace mmverify::proofs::bake
