#include "proofs/scene/bake_sample.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "proofs/engine/random.hpp"
#include "proofs/scene/exact_surface.hpp"

namespace mmverify::proofs::scene {
namespace {

/// The exact states that a drawn micro-triangle costs: its own, and the search for one near a change.
constexpr std::uint64_t states_of_sample = 4;
/// The micro-triangles of a level that are drawn at least.
constexpr std::uint64_t least_sample = 64;

/// The work of one exact state of a planned triangle: it grows with the texels along the edges.
std::uint64_t work_of_state(const Data& data, std::size_t triangle) {
  const auto& planned = data.plan.triangles[triangle];
  const auto& image = data.scene.images[data.plan.surfaces[planned.surface].image];
  const auto along = [&](std::size_t axis, double size) {
    const auto [low, high] = std::minmax({planned.uvs[0][axis], planned.uvs[1][axis], planned.uvs[2][axis]});
    return std::min((double{high} - low) * size, 4 * size);  // beyond some repeats all texels are met
  };
  const double edges = along(0, image.width) + along(1, image.height),
               side = static_cast<double>(std::uint64_t{1} << data.baked.triangles[triangle].level);
  return 1 + static_cast<std::uint64_t>(edges / side / 8);
}

/// The exact states that a whole map takes: its pieces, the children of mixed nodes, and the unknown micro-triangles
/// themselves.  Mixed nodes are fewer than unknown micro-triangles.
std::uint64_t states_of_whole(const Claim& claim, const mmverify::scene::BakedTriangle& t) {
  const std::uint64_t pieces = std::uint64_t{1} << 2 * (t.level > piece ? t.level - piece : 0);
  const std::uint64_t unknown =
      claim.what == Claim::forced ? impl::micromap::micro_triangles(t.level) / 4 : t.states[2] + t.states[3];
  return pieces + 4 * unknown;
}

/// The micro-triangles of a level that a claim is about, and the work of all of its maps.
struct LevelWork {
  std::uint64_t all = 0, work = 0, states = 0;
  std::uint64_t whole = 0;  ///< the work, with states_of_rationals
  std::uint64_t of_sample() const {
    return states_of_sample * std::max<std::uint64_t>(1, states == 0 ? 1 : work / states);
  }
};

using WorkByLevel = std::array<LevelWork, std::tuple_size_v<LookedByLevel>>;

WorkByLevel work_by_level(const Claim& claim, const Data& data) {
  WorkByLevel levels{};
  for (std::size_t k = 0; k < data.baked.triangles.size(); ++k) {
    const auto& t = data.baked.triangles[k];
    LevelWork& level = levels[t.level];
    const std::uint64_t states = states_of_whole(claim, t);
    level.all += claim.count(t);
    level.states += states;
    const std::uint64_t work = states * work_of_state(data, k);
    level.work += work;
    level.whole += work * (data.plan.triangles[k].varies() ? states_of_rationals : 1);
  }
  return levels;
}

}  // namespace

std::uint64_t usual_work(const Data& data) {
  std::uint64_t texels = 0, micro_triangles = 0;
  for (const auto& image : data.scene.images)
    if (image.decoded()) texels += std::uint64_t{image.width} * image.height;
  for (const auto& t : data.baked.triangles) micro_triangles += impl::micromap::micro_triangles(t.level);
  return 5'000 + texels / 1024 + micro_triangles / 2048;
}

std::uint64_t work_of_seconds(const Data& data, double seconds, unsigned threads) {
  using Clock = std::chrono::steady_clock;
  const ExactSurfaces exact(data.scene, data.plan, data.margin);
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  Random random(1, 71, 0);
  std::uint64_t states = 0, work = 0;
  while (states < 1'000 && (states == 0 || passed() < seconds / 16)) {
    const std::size_t t = random.below(data.baked.triangles.size());
    const Level n = data.baked.triangles[t].level;
    exact.state(t, n, static_cast<std::uint32_t>(random.below(impl::micromap::micro_triangles(n))));
    ++states;
    work += work_of_state(data, t);
  }
  const double a_second = static_cast<double>(work) / std::max(passed(), 1e-9),
               side_by_side = threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  return 1 + static_cast<std::uint64_t>(std::min(1e15, seconds * a_second * side_by_side));
}

LookedByLevel looked_at(const Claim& claim, const Data& data, const BakeSample& sample) {
  const WorkByLevel levels = work_by_level(claim, data);
  std::uint64_t whole = 0;
  std::vector<Level> by_work;
  for (Level n = 0; n < levels.size(); ++n) {
    whole += levels[n].whole;
    if (levels[n].all != 0) by_work.push_back(n);
  }
  std::stable_sort(by_work.begin(), by_work.end(),
                   [&](Level a, Level b) { return levels[a].work < levels[b].work; });
  LookedByLevel looked{};
  std::uint64_t left = sample.work.value_or(0);
  for (std::size_t k = 0; k < by_work.size(); ++k) {
    const LevelWork& level = levels[by_work[k]];
    const std::uint64_t share = left / (by_work.size() - k);
    std::uint64_t at = level.all;
    if (sample.size)
      at = (*sample.size + by_work.size() - 1) / by_work.size();
    else if (sample.work && whole > sample.whole && level.work > share)
      at = std::max(least_sample, share / level.of_sample());
    at = std::min(at, level.all);
    left -= std::min(left, at == level.all ? level.work : at * level.of_sample());
    looked[by_work[k]] = {level.all, at};
  }
  return looked;
}

}  // namespace mmverify::proofs::scene
