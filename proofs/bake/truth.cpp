#include "proofs/bake/truth.hpp"

#include <mutex>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "proofs/bake/exact_texture.hpp"
#include "proofs/bake/narrow.hpp"

namespace mmverify::proofs::bake {
namespace {

namespace bake = spec::bake;

template <class Q>
State state_in(const Case& one, Level n, std::uint32_t index) {
  const auto uv = base_triangle<Q>(one);
  return with_textures(one, [&]<class Stored>(const std::vector<bake::TextureOf<Stored>>& mips) {
    return with_mode<Q>(one, [&](const auto& mode) {
      const Q margin = bake::number<Q>(bake::Binary32{std::bit_cast<std::uint32_t>(one.margin)});
      return bake::micro_state(std::span<const bake::TextureOf<Stored>>(mips), uv, n, index, mode, margin);
    });
  });
}

/// Takes each place that may be an extreme of the part of a polygon within one cell, as bake::range does.
template <class Stored, class Take>
void candidates(const bake::TextureOf<Stored>& t, std::int64_t i, std::int64_t j,
                const bake::Polygon<Rational>& part, Take take) {
  const bake::Cell<Rational> cell(t, i, j);
  for (std::size_t corner = 0; corner < part.size(); ++corner) {
    const Place &from = part[corner], &to = part[(corner + 1) % part.size()];
    take(from);
    const Place p = cell.local(from);
    const Rational x = to.x - from.x, y = to.y - from.y, k = cell.d * x * y,
                   l = cell.b * x + cell.c * y + cell.d * (p.x * y + p.y * x);
    if (k == 0) continue;
    const Rational along = -l / (k + k);
    if (along > 0 && along < 1) take(Place{from.x + along * x, from.y + along * y});
  }
}

}  // namespace

State true_state(const Case& one, Level n, std::uint32_t index) {
  return in_smallest([&]<class Q>() { return state_in<Q>(one, n, index); });
}

const std::vector<std::uint32_t>& judged_at(Level n) {
  constexpr std::uint32_t all = 64;
  static const auto by_level = [] {
    std::vector<std::vector<std::uint32_t>> levels(17);
    for (Level level = 0; level < levels.size(); ++level) {
      const std::uint64_t count = std::uint64_t{1} << 2 * level;
      auto& at = levels[level];
      at.resize(std::min<std::uint64_t>(all, count));
      std::iota(at.begin(), at.end(), 0u);
      // Spread evenly, and not always the same child of a parent.
      if (count > all)
        for (std::uint32_t& k : at)
          k = static_cast<std::uint32_t>(count / all * k + k % 4 * (count / all / 4));
    }
    return levels;
  }();
  return by_level.at(n);
}

std::vector<State> true_states(const Case& one, Level n) {
  // The laws of states ask about the same samples, and so do their mutants.
  constexpr std::size_t most = 1 << 14;
  static std::mutex lock;
  static std::unordered_map<std::string, std::vector<State>> known;
  const std::string name = std::to_string(n) + ' ' + text_of(one);
  {
    const std::lock_guard hold(lock);
    if (const auto found = known.find(name); found != known.end()) return found->second;
  }
  std::vector<State> states;
  for (const std::uint32_t index : judged_at(n)) states.push_back(true_state(one, n, index));
  const std::lock_guard hold(lock);
  if (known.size() < most) known.emplace(name, states);
  return states;
}

bake::Polygon<Rational> corners_of(const Case& one, Level n, std::uint32_t index) {
  return bake::micro_triangle(base_triangle<Rational>(one), n, index, one.width, one.height);
}

Extremes extremes(const Case& one, Level n, std::uint32_t index) {
  const bake::Polygon<Rational> polygon =
      bake::dilated(corners_of(one, n, index),
                    bake::number<Rational>(bake::Binary32{std::bit_cast<std::uint32_t>(one.margin)}));
  return with_textures(one, [&](const auto& mips) {
    const auto& t = mips.front();
    std::optional<Extremes> found;
    const auto take = [&](const Place& p) {
      const Extreme here{p, bake::alpha(t, p)};
      if (!found) found = Extremes{here, here};
      if (here.alpha < found->least.alpha) found->least = here;
      if (here.alpha > found->greatest.alpha) found->greatest = here;
    };
    if (t.filter == Filter::nearest)
      bake::for_each_square(polygon, Rational(0), [&](std::int64_t, std::int64_t, const auto& part) {
        take(bake::centroid(part));  // below its high sides, as some corner is: the texel's own
      });
    else
      bake::for_each_square(
          polygon, bake::fraction<Rational>(1, 2),
          [&](std::int64_t i, std::int64_t j, const auto& part) { candidates(t, i, j, part, take); });
    return found.value();
  });
}

}  // namespace mmverify::proofs::bake
