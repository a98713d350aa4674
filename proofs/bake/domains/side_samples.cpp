#include "proofs/bake/domains/side_samples.hpp"

#include <algorithm>
#include <vector>

#include "proofs/bake/cases/lone_texel.hpp"
#include "proofs/engine/random.hpp"

namespace mmverify::proofs::bake {
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
