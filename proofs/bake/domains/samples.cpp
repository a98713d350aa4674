#include "proofs/bake/domains/samples.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace mmverify::proofs::bake {
namespace {

constexpr std::uint64_t stream = 0x62616b65;

/// The counts of each 104 samples.  First come eight kinds in turn.  Then pairs: a sample a hair beside lines, and
/// the same texture with other texels below its first row, which finds a baker that reuses the first.  Then samples
/// with one corner over a line, and edges within which alpha crosses the cutoff.
constexpr std::uint64_t stiff_samples = 64, paired_samples = 16, edge_samples = 24;

std::uint64_t in_turn(std::uint64_t k) { return k % (stiff_samples + paired_samples + edge_samples); }
bool is_edge_sample(std::uint64_t k) { return in_turn(k) >= stiff_samples + paired_samples; }
bool repeats_the_one_before(std::uint64_t k) {
  return in_turn(k) >= stiff_samples && !is_edge_sample(k) && in_turn(k) % 2 != 0;
}

/// A multiple of 2^-bits in [-reach, reach], exact in binary32.
float dyadic(Random& random, int reach, int bits) {
  const std::int64_t limit = std::int64_t{reach} << bits;
  return std::ldexp(static_cast<float>(random.between(-limit, limit)), -bits);
}

Wrap any_wrap(Random& random) { return static_cast<Wrap>(random.below(5)); }

void draw_texture(Random& random, Case& one) {
  one.width = static_cast<std::uint32_t>(1 + random.below(7));
  one.height = static_cast<std::uint32_t>(1 + random.below(7));
  const std::uint64_t values = random.below(3);
  const auto cutoff = static_cast<std::uint32_t>(1 + random.below(255));
  one.cutoff = random.below(2) != 0 ? Cutoff{cutoff, 255} : Cutoff{1, 2};
  one.alpha.clear();
  for (std::uint32_t k = 0; k < one.width * one.height; ++k) {
    const std::uint32_t near = std::min(255u, cutoff - 1 + static_cast<std::uint32_t>(random.below(3)));
    one.alpha.push_back(values == 0   ? static_cast<std::uint32_t>(random.below(256))
                        : values == 1 ? static_cast<std::uint32_t>(255 * random.below(2))
                                      : near);
  }
  one.wrap_u = any_wrap(random);
  one.wrap_v = any_wrap(random);
  one.border = static_cast<std::uint32_t>(random.below(256));
}

void place_anywhere(Random& random, Case& one) {
  for (float& x : one.uv) x = dyadic(random, 2, static_cast<int>(2 + random.below(7)));
}

/// Places two corners apart, and the third 10^-6 of their distance beside them.
void place_sliver(Random& random, Case& one) {
  const float u = dyadic(random, 1, 6), v = dyadic(random, 1, 6), along_u = dyadic(random, 2, 5),
              along_v = dyadic(random, 2, 5), t = static_cast<float>(random.below(5)) / 4;
  one.uv = {u,
            v,
            u + along_u,
            v + along_v,
            u + t * along_u - along_v * 0x1p-20f,
            v + t * along_v + along_u * 0x1p-20f};
}

void place_beside_lines(Random& random, Case& one) {
  for (std::size_t k = 0; k < 6; ++k) {
    const std::uint32_t size = k % 2 == 0 ? one.width : one.height;
    // Lines between texels, or through their centres.
    const float line = static_cast<float>(random.between(-2, 4 * size)) / static_cast<float>(2 * size);
    const std::uint64_t step = random.below(3);
    one.uv[k] = step == 0   ? line
                : step == 1 ? std::nextafter(line, std::numeric_limits<float>::infinity())
                            : std::nextafter(line, -std::numeric_limits<float>::infinity());
  }
}

/// Places micro-vertices 2^-9 to 2^-20 of a texel beside a line.  Lines lie between texels, through their centres,
/// or, with stripes a texel wide, where bilinear alpha is the cutoff, anywhere between two centres.  Rounding to
/// coarser steps puts some of these vertices on a line, or beyond it.
void place_a_hair_beside_lines(Random& random, Case& one) {
  std::array<std::optional<double>, 2> line;  // the line of the cutoff in texels, in half of the draws
  const std::size_t kind = random.below(3);
  if (kind < 2) {
    const auto less = static_cast<std::uint32_t>(random.below(64)),
               span = static_cast<std::uint32_t>(8 + random.below(184)),
               over = static_cast<std::uint32_t>(1 + random.below(2 * span - 1));
    one.cutoff = {2 * less + over, 510};
    line[kind] = 0.5 + over / (2.0 * span);
    for (std::uint32_t k = 0; k < one.width * one.height; ++k)
      one.alpha[k] = (kind == 0 ? k % one.width : k / one.width) % 2 == 0 ? less : less + span;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const int power = -static_cast<int>(9 + random.below(12));
    const double size = axis == 0 ? one.width : one.height,
                 hair = std::ldexp(random.below(2) != 0 ? 1.0 : -1.0, power);
    for (std::size_t k = axis; k < 6; k += 2) {
      const double near = line[axis] ? 2 * static_cast<double>(random.between(-1, 3)) + *line[axis]
                                     : static_cast<double>(random.between(-4, 12)) / 2;
      one.uv[k] = static_cast<float>((near + hair) / size);
    }
  }
}

void place_far(Random& random, Case& one) {
  place_anywhere(random, one);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const float away = random.below(2) != 0 ? 1e6f : -1e6f;
    for (std::size_t k = axis; k < 6; k += 2)
      one.uv[k] += away;  // exact, since coordinates were rounded to sixteenths
  }
}

void flatten(Random& random, Case& one) {
  const std::uint32_t at = one.cutoff.denominator == 255 ? one.cutoff.numerator : 128;
  const auto value = static_cast<std::uint32_t>(std::clamp<std::int64_t>(at + random.between(-1, 1), 0, 255));
  std::fill(one.alpha.begin(), one.alpha.end(), value);
  one.border = random.below(2) != 0 ? value : one.border;
  place_anywhere(random, one);
}

void degenerate(Random& random, Case& one) {
  place_anywhere(random, one);
  const float t = static_cast<float>(random.below(9)) / 8;
  for (std::size_t axis = 0; axis < 2; ++axis)
    one.uv[4 + axis] = one.uv[axis] + t * (one.uv[2 + axis] - one.uv[axis]);
  if (random.below(3) == 0) one.uv[2] = one.uv[4] = one.uv[0], one.uv[3] = one.uv[5] = one.uv[1];
}

void place_below(Random& random, Case& one) {
  place_anywhere(random, one);
  for (float& x : one.uv) x -= 300;
  std::swap(one.uv[0], one.uv[2]);
  std::swap(one.uv[1], one.uv[3]);
}

void repeat_often(Random& random, Case& one) {
  one.width = one.height = 2;
  one.alpha.resize(4, 255);
  for (float& x : one.uv) x = dyadic(random, 12, 3);
}

std::uint32_t in_texels_of(Texel texel, std::uint32_t byte, Random& random) {
  if (texel == Texel::unorm8) return byte;
  const auto word = static_cast<std::uint32_t>(
      std::clamp<std::int64_t>(257 * std::int64_t{byte} + random.between(-1, 1), 0, 65535));
  if (texel == Texel::unorm16) return word;
  const float steps[] = {0, 1, -0.25f, 1.5f};
  return std::bit_cast<std::uint32_t>(random.below(4) == 0 ? steps[random.below(4)]
                                                           : static_cast<float>(byte) / 255);
}

}  // namespace

Case sample(std::uint64_t seed, std::uint64_t k) {
  if (repeats_the_one_before(k)) {
    Case one = sample(seed, k - 1);
    for (std::size_t at = one.width; at < one.alpha.size(); ++at) one.alpha[at] = 255 - one.alpha[at];
    return one;
  }
  Random random(seed, stream, k);
  Case one;
  draw_texture(random, one);
  constexpr void (*place[])(Random&, Case&) = {place_anywhere, place_sliver, place_beside_lines,
                                               place_far,      flatten,      degenerate,
                                               place_below,    repeat_often};
  if (in_turn(k) < stiff_samples)
    place[in_turn(k) % std::size(place)](random, one);
  else if (is_edge_sample(k))
    (k % 2 != 0 ? cross_the_cutoff_within_an_edge : cross_a_line_by_a_step)(random, one);
  else
    place_a_hair_beside_lines(random, one);
  return one;
}

Case featured_sample(std::uint64_t seed, std::uint64_t k) {
  Case one = sample(seed, k);
  Random random(seed, stream + 2, k);
  const bool by_the_margin = is_edge_sample(k) && random.below(2) != 0;
  if (by_the_margin) reach_a_line_by_the_margin(random, one);
  one.filter = static_cast<Filter>(random.below(2));
  one.texel = static_cast<Texel>(random.below(3));
  one.blend = random.below(3) == 0 && !is_edge_sample(k);
  constexpr float factors[] = {1, 1, 0.5f, 1.25f, 0.3f, 0}, margins[] = {0, 0, 0.00390625f, 0.25f, 1.5f};
  one.factor = factors[random.below(6)];
  one.vertex_factor = factors[random.below(4)];
  if (one.blend && random.below(2) != 0)  // BLEND's cutoffs are 0 and 1: texels at them, and a step beside
    for (std::uint32_t& byte : one.alpha) byte = (byte & 1) != 0 ? 254 + (byte >> 1 & 1) : byte >> 1 & 1;
  if (is_edge_sample(k))
    one.factor = one.vertex_factor = 1;  // else no line between stripes would be the cutoff's
  if (!is_edge_sample(k)) one.margin = margins[random.below(5)];
  one.mips = !is_edge_sample(k) && random.below(4) == 0 ? 2 : 1;
  for (std::uint64_t texels = texels_of(one.width, one.height, one.mips); one.alpha.size() < texels;)
    one.alpha.push_back(random.below(2) != 0 ? one.alpha[random.below(one.alpha.size())] : 255);
  for (std::uint32_t& bits : one.alpha) bits = in_texels_of(one.texel, bits, random);
  one.border = in_texels_of(one.texel, one.border, random);
  return one;
}

const char* featured_samples_text() {
  return "the same cases bilinear and nearest, MASK and BLEND, of 8 and 16 bits and binary32, with factors, "
         "margins that reach a line by a hair or not, and a second mip; up to 96 micro-triangles of each";
}

Case moving_sample(std::uint64_t seed, std::uint64_t k) {
  Case one = featured_sample(seed, k);
  Random random(seed, stream + 3, k);
  constexpr float ranges[] = {0, 0x1p-9f, 0x1p-5f, 0.1f, 0.25f, 0.3f, 1, 3};
  for (float& range : one.travel) range = ranges[random.below(8)];
  return one;
}

const char* moving_samples_text() {
  return "textures of up to 7x7 texels with one mip or two, any addressing, bilinear and nearest, MASK and "
         "BLEND, of 8 "
         "and 16 bits and binary32, with factors and margins: triangles that move by 0 to 3 repeats along "
         "each axis; "
         "up to 96 micro-triangles of each";
}

Case changed_sample(std::uint64_t seed, std::uint64_t k) {
  Case one = k % 2 != 0   ? large_sample(seed, k)
             : k % 3 == 0 ? moving_sample(seed, k)
                          : featured_sample(seed, k);
  Random random(seed, stream + 4, k);
  if (k % 2 != 0) {
    one.filter = static_cast<Filter>(random.below(2));
    for (float& range : one.travel) range = k % 3 == 0 ? 0.125f * static_cast<float>(random.below(3)) : 0.0f;
  }
  one.change.seed = random.below(1u << 31);
  for (std::uint32_t mip = 0; mip < one.mips; ++mip) {
    const std::uint32_t width = std::max(1u, one.width >> mip), height = std::max(1u, one.height >> mip);
    auto& [x, y, columns, rows] = one.change.boxes.emplace_back();
    x = static_cast<std::uint32_t>(random.below(width));
    y = static_cast<std::uint32_t>(random.below(height));
    columns =
        one.mips > 1 && random.below(2) != 0 ? 0 : 1 + static_cast<std::uint32_t>(random.below(width - x));
    rows = 1 + static_cast<std::uint32_t>(random.below(height - y));
  }
  return one;
}

const char* changed_samples_text() {
  return "every second case of textures of up to 24x24 texels, the others of up to 7x7 texels with one mip "
         "or two, of which a box of each, or of one of two, had "
         "other texels "
         "before; any addressing, bilinear and nearest, MASK and BLEND, of 8 and 16 bits and binary32, with "
         "factors and "
         "margins; every third triangle moves";
}

Case large_sample(std::uint64_t seed, std::uint64_t k) {
  Random random(seed, stream + 1, k);
  Case one;
  one.width = static_cast<std::uint32_t>(1 + random.below(24));
  one.height = static_cast<std::uint32_t>(1 + random.below(24));
  const bool noisy = random.below(4) == 0;
  const auto side = static_cast<std::int64_t>(one.width + one.height);
  const std::int64_t x = random.between(0, one.width), y = random.between(0, one.height),
                     r = random.between(1, side / 2), fade = random.between(1, side);
  one.alpha.clear();
  for (std::int64_t j = 0; j < one.height; ++j)
    for (std::int64_t i = 0; i < one.width; ++i) {
      const std::int64_t inside = r * r - (i - x) * (i - x) - (j - y) * (j - y);
      one.alpha.push_back(
          noisy ? static_cast<std::uint32_t>(random.below(256))
                : static_cast<std::uint32_t>(std::clamp<std::int64_t>(128 + inside * 8 / fade, 0, 255)));
    }
  one.wrap_u = any_wrap(random);
  one.wrap_v = any_wrap(random);
  one.border = static_cast<std::uint32_t>(random.below(256));
  one.cutoff = {static_cast<std::uint32_t>(random.between(1, 254)), 255};
  const int bits = static_cast<int>(2 + random.below(9));
  for (float& p : one.uv) p = dyadic(random, 1, bits);
  return one;
}

const char* large_samples_text() {
  return "textures of up to 24x24 texels of discs and noise, any addressing, bilinear, any triangle within a "
         "repeat of the texture";
}

const char* samples_text() {
  return "textures of up to 7x7 texels, any addressing, bilinear: any triangle, slivers of 10^6 to 1, "
         "corners an ulp off texel lines, micro-vertices 2^-9 to 2^-20 of a texel off them and off lines of "
         "the cutoff, 10^6 repeats away, one alpha throughout at the cutoff or beside it, lines and points, "
         "far below 0, many repeats, the case before with other texels below its first row, one corner a "
         "step of binary32 over a line; up to 96 micro-triangles of each";
}

}  // namespace mmverify::proofs::bake
