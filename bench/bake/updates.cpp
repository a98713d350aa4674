#include "bench/bake/updates.hpp"

#include <array>
#include <random>
#include <stdexcept>

#include "bench/timing.hpp"
#include "impl/bake/triangles.hpp"

namespace mmverify::bench {
namespace {

namespace fast = impl::bake;

constexpr std::uint32_t update_level = 8;
constexpr fast::Cutoff half_alpha{1, 2};
const fast::MovingTriangle whole_square[] = {{{{{0, 0}, {1, 0}, {0, 1}}}}, {{{{1, 1}, {0, 1}, {1, 0}}}}};

fast::AlphaView view_of(const AlphaTexture& t) {
  const auto width = static_cast<std::uint32_t>(t.width);
  return {t.alpha.data(), width, static_cast<std::uint32_t>(t.height), width};
}

fast::Box square(const AlphaTexture& t, std::uint32_t side, std::mt19937_64& random) {
  const auto place = [&](int size) {
    return static_cast<std::uint32_t>(random() % (static_cast<std::uint64_t>(size) - side + 1));
  };
  const std::uint32_t x = place(t.width);
  return {x, place(t.height), side, side};
}

AlphaTexture inverted(AlphaTexture t, const fast::Box& box) {
  for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
    for (std::uint32_t x = box.x; x < box.x + box.width; ++x) {
      std::uint8_t& texel = t.alpha[x + static_cast<std::size_t>(t.width) * y];
      texel = static_cast<std::uint8_t>(255 - texel);
    }
  return t;
}

}  // namespace

std::vector<BakeUpdate> bake_updates(const std::vector<AlphaTexture>& textures, std::uint64_t seed,
                                     std::size_t rounds) {
  std::vector<BakeUpdate> all;
  std::mt19937_64 random(seed);
  for (const std::uint32_t side : {1u, 8u, 64u}) {
    BakeUpdate result{side};
    std::uint64_t maps = 0, again = 0;
    for (const AlphaTexture& before : textures) {
      if (before.width < static_cast<int>(side) || before.height < static_cast<int>(side)) continue;
      const fast::Box box = square(before, side, random);
      const AlphaTexture after = inverted(before, box);
      const fast::TriangleBaker old(view_of(before), half_alpha), now(view_of(after), half_alpha);
      for (const fast::MovingTriangle& uv : whole_square) {
        std::vector<std::uint8_t> stale(std::size_t{1} << (2 * update_level - 2)), updated = stale,
                                                                                   whole = stale;
        old.bake_moving(uv, update_level, stale);
        result.ns_whole += median_ns(rounds, [&] { now.bake_moving(uv, update_level, whole); });
        // Baked again once more, an updated map stays as it is.
        updated = stale;
        again += now.rebake(uv, update_level, updated, std::array{box}).micro_triangles;
        result.ns += median_ns(rounds, [&] { now.rebake(uv, update_level, updated, std::array{box}); });
        if (updated != whole) throw std::runtime_error("bake bench: an update differs on " + before.file);
        ++maps;
      }
    }
    if (maps == 0) continue;
    result.ns /= static_cast<double>(maps);
    result.ns_whole /= static_cast<double>(maps);
    result.baked_again = static_cast<double>(again) / static_cast<double>(maps << (2 * update_level));
    all.push_back(result);
  }
  return all;
}

}  // namespace mmverify::bench
