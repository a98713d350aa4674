#include <cmath>
#include <limits>

#include "proofs/bake/cases/lone_texel.hpp"
#include "proofs/bake/domains/samples.hpp"

namespace mmverify::proofs::bake {
namespace {

int any_sign(Random& random) { return random.below(2) != 0 ? 1 : -1; }

/// Draws a striped texture; returns the axis across the stripes.  On it every second texture repeats.
std::size_t draw_stripes(Random& random, Case& one) {
  const std::size_t axis = random.below(2);
  std::uint32_t& size = axis == 0 ? one.width : one.height;
  // The size is even, so that stripes continue across a repeat.  For the sides 82, 94, 110 and 122 binary32's
  // reciprocal is too small by a bit.
  size = static_cast<std::uint32_t>(2 + 2 * random.below(random.below(2) != 0 ? 3 : 64));
  if (random.below(2) != 0) (axis == 0 ? one.wrap_u : one.wrap_v) = Wrap::repeat;
  one.cutoff = {1, 2};
  one.alpha.clear();
  for (std::uint32_t k = 0; k < one.width * one.height; ++k)
    one.alpha.push_back((axis == 0 ? k % one.width : k / one.width) % 2 == 0 ? 0 : 255);
  return axis;
}

/// A line between stripes, in texels, up to two repeats away; half of the draws take the texture's edge.
std::int64_t any_line(Random& random, std::uint32_t size) {
  const auto away = 2 * static_cast<std::int64_t>(size);
  return random.below(2) == 0 ? size * random.between(-1, 2) * static_cast<std::int64_t>(random.below(2))
                              : random.between(-away, away);
}

/// Places the first corner at `first` on the axis, and the others up to `extent` texels from `behind`, away from the
/// line.  On the other axis all corners lie anywhere.
void place(Random& random, Case& one, std::size_t axis, float first, double behind, double extent) {
  const std::uint32_t size = axis == 0 ? one.width : one.height;
  for (std::size_t k = 0; k < 6; ++k)
    one.uv[k] = static_cast<float>(
        k % 2 != axis ? static_cast<double>(random.between(-16, 16)) / 16
                      : (behind + extent * static_cast<double>(random.between(1, 16)) / 16) / size);
  one.uv[axis] = first;
}

}  // namespace

void cross_a_line_by_a_step(Random& random, Case& one) {
  const std::size_t axis = draw_stripes(random, one);
  const std::uint32_t size = axis == 0 ? one.width : one.height;
  const std::int64_t at = any_line(random, size);
  const int over = any_sign(random);
  const float line = static_cast<float>(at) / static_cast<float>(size),
              beyond = static_cast<float>(over) * std::numeric_limits<float>::infinity(),
              first = at != 0
                          ? std::nextafter(line, beyond)
                          : std::ldexp(static_cast<float>(over), -static_cast<int>(random.between(20, 149)));
  place(random, one, axis, first, static_cast<double>(at), -over * 0.75);
}

void reach_a_line_by_the_margin(Random& random, Case& one) {
  const std::size_t axis = draw_stripes(random, one);
  const std::uint32_t size = axis == 0 ? one.width : one.height;
  const int size_of_margin = -static_cast<int>(random.between(3, 7));
  one.margin = std::ldexp(1 + static_cast<float>(random.below(1u << 23)) * 0x1p-23f, size_of_margin);
  const int over = any_sign(random), size_of_hair = -static_cast<int>(random.between(9, 18));
  const double hair = std::ldexp(any_sign(random), size_of_hair),
               first = static_cast<double>(any_line(random, size)) - over * (one.margin + hair);
  place(random, one, axis, static_cast<float>(first / size), first, -over * 0.5 * (1 - 2 * one.margin));
}

void cross_the_cutoff_within_an_edge(Random& random, Case& one) {
  one.width = one.height = 2;
  const auto low = static_cast<std::uint32_t>(random.below(200)),
             half = static_cast<std::uint32_t>(1 + random.below(27));
  const bool crest = random.below(2) != 0;
  const std::uint32_t ends = crest ? low : low + 2 * half, others = crest ? low + 2 * half : low;
  one.alpha = {ends, others, others, ends};
  // Alpha is that of `middle` half way between the centres of the first and the last texel.
  const std::uint32_t steps = 1u << random.between(3, 20), middle = low + half;
  one.cutoff = {crest ? middle * steps - 1 : middle * steps + 1, 255 * steps};
  const double length = std::ldexp(1.0, -static_cast<int>(random.below(6))),
               first = 1 - length * static_cast<double>(2 * random.below(64) + 1) / 128,
               third = first + length * static_cast<double>(random.below(9)) / 8;
  const auto at = [](double texels) { return static_cast<float>(texels / 2); };
  one.uv = {at(first), at(first), at(first + length), at(first + length), at(third), at(third)};
}

namespace {

constexpr std::uint64_t side_stream = 0x73696465;

bool is_prime(std::uint32_t n) {
  for (std::uint32_t k = 2; k * k <= n; ++k)
    if (n % k == 0) return false;
  return n > 1;
}

const std::vector<std::uint32_t>& every_side() {
  static const std::vector<std::uint32_t> all = [] {
    std::vector<std::uint32_t> of;
    for (std::uint32_t n = 1; n <= 128; ++n) of.push_back(n);
    for (std::uint32_t n = 129; n <= 521; ++n)
      if (is_prime(n)) of.push_back(n);
    for (std::uint32_t n = 256; n <= 16384; n *= 2) {
      of.push_back(n - 1);
      if (n < 16384) of.push_back(n + 1);
    }
    return of;
  }();
  return all;
}

}  // namespace

std::uint64_t side_count() { return every_side().size(); }

Case side_sample(std::uint64_t seed, std::uint32_t level, std::uint64_t k) {
  Random random(seed, side_stream + level, k);
  const std::uint32_t side = every_side()[k / distances % every_side().size()];
  // A coordinate of 24 bits tells eighths of a texel up to 2^20 texels away.
  const std::int64_t farthest = std::max<std::int64_t>(1, (1 << 20) / side - 1);
  const auto up_to = [&](std::int64_t most) { return random.between(1, std::min(most, farthest)); };
  std::int64_t repeats = 1;
  if (k % distances == 1) repeats = -up_to(8);
  if (k % distances == 2) repeats = up_to(1024);
  if (k % distances == 3) repeats = up_to(farthest) * (random.below(2) == 0 ? 1 : -1);
  Case one;
  const bool across = random.below(2) == 0, first = random.below(2) == 0, dark = random.below(2) == 0;
  (across ? one.width : one.height) = side;
  const std::uint32_t lone = first ? 0 : side - 1;
  const LoneTexel texel{dark ? 0u : 255u, dark ? 255u : 0u, across ? lone : 0, across ? 0 : lone};
  one.alpha = texels(texel, one.width, one.height);
  if (one.alpha.size() > 1024) one.drawn = text_of(texel);
  (across ? one.wrap_u : one.wrap_v) = random.below(4) == 0 ? Wrap::mirrored_repeat : Wrap::repeat;
  (across ? one.wrap_v : one.wrap_u) = Wrap::clamp_to_edge;
  one.filter = random.below(2) == 0 ? Filter::nearest : Filter::bilinear;
  one.cutoff = {1, 2};
  // Texel 0 of a repeat, or the one before.
  const double begin = static_cast<double>(repeats * side) - (random.below(2) == 0 ? 0 : 1);
  const auto along = [&] {
    return static_cast<float>((begin + 0.25 + static_cast<double>(random.below(5)) / 8) / side);
  };
  const auto beside = [&] { return static_cast<float>(random.between(0, 16)) / 16; };
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    one.uv[2 * vertex] = across ? along() : beside();
    one.uv[2 * vertex + 1] = across ? beside() : along();
  }
  return one;
}

const char* side_samples_text() {
  return "textures of one alpha but for the first or the last texel of a side: 1 to 128, primes to 521, 2^k "
         "- 1 and 2^k + 1 to 16383; triangles where it begins again, at 4 distances of up to 2^20 texels";
}

}  // namespace mmverify::proofs::bake
