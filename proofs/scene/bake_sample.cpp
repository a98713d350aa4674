#include "proofs/scene/bake_sample.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "proofs/engine/random.hpp"
#include "proofs/scene/exact_surface.hpp"

namespace mmverify::proofs::scene {
namespace {

/// The exact states that a drawn micro-triangle costs: its own, and the search for one near a change.
constexpr std::uint64_t work_of_sample = 4;

/// The exact states that a whole map takes: its pieces, the children of mixed nodes, and the unknown micro-triangles
/// themselves.  Mixed nodes are fewer than unknown micro-triangles.
std::uint64_t work_of(const Claim& claim, const mmverify::scene::BakedTriangle& t) {
  const std::uint64_t pieces = std::uint64_t{1} << 2 * (t.level > piece ? t.level - piece : 0);
  const std::uint64_t unknown =
      claim.what == Claim::forced ? impl::micromap::micro_triangles(t.level) / 4 : t.states[2] + t.states[3];
  return pieces + 4 * unknown;
}

}  // namespace

std::uint64_t usual_work(const Data& data) {
  std::uint64_t texels = 0, micro_triangles = 0;
  for (const auto& image : data.scene.images)
    if (image.decoded()) texels += std::uint64_t{image.width} * image.height;
  for (const auto& t : data.baked.triangles) micro_triangles += impl::micromap::micro_triangles(t.level);
  return 20'000 + texels / 64 + micro_triangles / 256;
}

std::uint64_t work_of_seconds(const Data& data, double seconds, unsigned threads) {
  using Clock = std::chrono::steady_clock;
  const ExactSurfaces exact(data.scene, data.plan, data.margin);
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  Random random(1, 71, 0);
  std::uint64_t states = 0;
  while (states < 1'000 && (states == 0 || passed() < seconds / 16)) {
    const std::size_t t = random.below(data.baked.triangles.size());
    const Level n = data.baked.triangles[t].level;
    exact.state(t, n, static_cast<std::uint32_t>(random.below(impl::micromap::micro_triangles(n))));
    ++states;
  }
  const double a_second = static_cast<double>(states) / std::max(passed(), 1e-9),
               side_by_side = threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  return 1 + static_cast<std::uint64_t>(std::min(1e15, seconds * a_second * side_by_side));
}

LookedByLevel looked_at(const Claim& claim, const mmverify::scene::Baked& baked, const BakeSample& sample) {
  LookedByLevel levels{};
  std::array<std::uint64_t, 13> work{};
  for (const auto& t : baked.triangles) {
    levels[t.level].all += claim.count(t);
    work[t.level] += work_of(claim, t);
  }
  std::vector<Level> by_work;
  for (Level n = 0; n < levels.size(); ++n)
    if (levels[n].all != 0) by_work.push_back(n);
  std::stable_sort(by_work.begin(), by_work.end(), [&](Level a, Level b) { return work[a] < work[b]; });
  std::uint64_t left = sample.work.value_or(0);
  for (std::size_t k = 0; k < by_work.size(); ++k) {
    Looked& looked = levels[by_work[k]];
    const std::uint64_t of_levels = by_work.size() - k;
    if (sample.size)
      looked.at = std::min(looked.all, (*sample.size + by_work.size() - 1) / by_work.size());
    else if (!sample.work || work[by_work[k]] <= left / of_levels)
      looked.at = looked.all;
    else
      looked.at = std::min(looked.all, std::max<std::uint64_t>(64, left / of_levels / work_of_sample));
    left -= std::min(left, looked.whole() ? work[by_work[k]] : looked.at * work_of_sample);
  }
  return levels;
}

}  // namespace mmverify::proofs::scene
