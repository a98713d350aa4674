// Laws of what changes after a bake: coordinates that move, and texels that are painted anew.
#include "proofs/bake/domains/samples.hpp"
#include "proofs/bake/laws.hpp"
#include "proofs/bake/laws/relation_judges.hpp"
#include "proofs/bake/mutants/states.hpp"
#include "proofs/bake/truth/exact_texture.hpp"
#include "proofs/points/narrow.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr Levels changing_levels{0, 5};
/// Each level has samples of its own; their kinds follow those of the first.
std::uint64_t changing_number(Level n, std::uint64_t k) { return 104 * 200 * std::uint64_t{n} + k; }

using Drawn = Case (*)(std::uint64_t seed, std::uint64_t k);
using Holds = Finding (*)(const BakeSubject&, const Case&, Level);

Law changing(Law law, Drawn drawn, std::uint64_t in_fast_tier, Holds holds, const Lacks& lacks) {
  law.method = Method::sample;
  law.subjects = {"bake"};
  law.tiers.fast = changing_levels;
  law.tiers.long_run = {0, 8};
  law.tiers.seconds = 0.5;
  Cases cases;
  cases.count = [in_fast_tier](Level, const Run& run) {
    return run.tier == Tier::fast ? in_fast_tier : std::uint64_t{5'000};
  };
  cases.number = [drawn](const Support& support, Level n, std::uint64_t k, std::uint64_t seed) {
    return fitted(support, drawn(seed, changing_number(n, k)), k);
  };
  cases.chunk = 4;
  return on_maps(std::move(law), cases, holds, lacks);
}

// ---------------------------------------------------------------------------------------------------------------------
// Positions
// ---------------------------------------------------------------------------------------------------------------------

/// A position: each vertex moved along each axis by this many eighths of the range.
using Eighths = std::array<int, 6>;

/// The outermost positions that turn or shrink a triangle most, and drawn ones.
std::vector<Eighths> positions(const Case& one) {
  std::vector<Eighths> all{{8, 8, 8, 8, 8, 8}, {-8, 8, -8, 8, -8, 8}, {8, -8, -8, 8, 8, 8}};
  Random random(std::bit_cast<std::uint32_t>(one.uv[0]), 0x706f, std::bit_cast<std::uint32_t>(one.uv[3]));
  for (int k = 0; k < 2; ++k)
    for (int& eighths : all.emplace_back()) eighths = static_cast<int>(random.between(-8, 8));
  return all;
}

template <class Q>
State state_at(const Case& one, const Eighths& position, Level n, std::uint32_t index) {
  const auto travel = travel_of<Q>(one);
  auto uv = base_triangle<Q>(one);
  for (std::size_t k = 0; k < 3; ++k) {
    uv[k].x += travel.x * spec::bake::fraction<Q>(position[2 * k], 8);
    uv[k].y += travel.y * spec::bake::fraction<Q>(position[2 * k + 1], 8);
  }
  return with_textures(one, [&]<class Stored>(const std::vector<spec::bake::TextureOf<Stored>>& mips) {
    return with_mode<Q>(one, [&](const auto& mode) {
      return spec::bake::micro_state(std::span<const spec::bake::TextureOf<Stored>>(mips), uv, n, index,
                                     mode);
    });
  });
}

Finding holds_in_all_positions(const BakeSubject& s, const Case& one, Level n) {
  const std::vector<State> map = map_of(s, one, n);
  constexpr std::size_t most = 6;
  std::size_t left = most;
  for (const std::uint32_t index : judged_at(one, n)) {
    if (spec::micromap::unknown(map.at(index))) continue;
    if (left-- == 0) break;
    for (const Eighths& position : positions(one)) {
      const State there = in_smallest([&]<class Q>() { return state_at<Q>(one, position, n, index); });
      if (there == map[index]) continue;
      std::string moved;
      for (const int eighths : position) moved += fmt::format(" {}/8", eighths);
      return wrong(fmt::format("micro-triangle {} {}, its vertices moved by{} of the ranges", index,
                               name_of(there), moved),
                   name_of(map[index]));
    }
  }
  return {hash_of(map)};
}

Law positions_law() {
  return changing(
      {.id = "bake.moving_positions",
       .says = "O or T of a moving triangle is so in any position of its vertices",
       .source = "Succinct Opacity Micromaps, 3.1.1, maximum deformation; a micro-triangle's points are "
                 "means of the "
                 "vertices",
       .domain = std::string(moving_samples_text()) + "; five positions of six known states of each",
       .mutants = {asked_for_another("half of the range along u", changing_levels,
                                     [](Case& one) { one.travel[0] /= 2; }),
                   asked_for_another("no range below 1/16", changing_levels,
                                     [](Case& one) {
                                       for (float& range : one.travel)
                                         if (range < 0x1p-4f) range = 0;
                                     }),
                   asked_for_another("no range along v beyond 1/4", changing_levels,
                                     [](Case& one) { one.travel[1] = std::min(one.travel[1], 0.25f); })}},
      moving_sample, 26, holds_in_all_positions,
      [](const BakeSubject& s, Level) -> std::optional<std::string> {
        if (s.functions.support.moving) return std::nullopt;
        return s.name() + " has no entry point for coordinates that move";
      });
}

// ---------------------------------------------------------------------------------------------------------------------
// Updates
// ---------------------------------------------------------------------------------------------------------------------

Finding is_baked_afresh(const BakeSubject& s, const Case& one, Level n) {
  Case afresh = one;
  afresh.change = {};
  const std::vector<State> updated = map_of(s, one, n), expected = map_of(s, afresh, n);
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (updated[k] != expected[k])
      return wrong(fmt::format("micro-triangle {} {}, as baked afresh", k, name_of(expected[k])),
                   name_of(updated[k]));
  return {hash_of(updated)};
}

/// A texel of a changed box.
struct Place {
  std::uint32_t mip, column, row, columns;  ///< within the box, of so many columns
};

/// A mutant that leaves some changed texels as they were.
Mutant overlooking(const char* name, bool (*overlooked)(const Case&, const Place&)) {
  return asked_for_another(name, changing_levels, [overlooked](Case& one) {
    if (one.change.boxes.empty()) return;
    const Case before = before_change(one);
    std::size_t from = 0;
    for (std::uint32_t mip = 0; mip < one.mips; ++mip) {
      const std::uint32_t width = std::max(1u, one.width >> mip), height = std::max(1u, one.height >> mip);
      const auto& [x, y, columns, rows] = one.change.boxes[mip];
      for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
          const std::size_t at = from + x + i + std::size_t{y + j} * width;
          if (overlooked(one, {mip, i, j, columns})) one.alpha[at] = before.alpha[at];
        }
      from += std::size_t{width} * height;
    }
    one.change = {};
    one.drawn.clear();
  });
}

Law update_law() {
  return changing(
      {.id = "bake.update",
       .says =
           "a map that is baked again where texels changed is the one that a whole bake gives, bit for bit",
       .source = "a state depends on no texel but those under its filter; spec/bake/state.hpp",
       .domain = changed_samples_text(),
       .mutants = {overlooking("the second mip's change is overlooked",
                               [](const Case&, const Place& at) { return at.mip == 1; }),
                   overlooking("the last column of boxes of three or more is overlooked, filtered bilinearly",
                               [](const Case& one, const Place& at) {
                                 return one.filter == Filter::bilinear && at.columns > 2 &&
                                        at.column + 1 == at.columns;
                               }),
                   overlooking(
                       "the first row is overlooked where the triangle moves",
                       [](const Case& one, const Place& at) { return at.row == 0 && one.travel[0] != 0; })}},
      changed_sample, 416, is_baked_afresh, [](const BakeSubject& s, Level) -> std::optional<std::string> {
        if (s.functions.support.updates) return std::nullopt;
        return s.name() + " has no entry point for changed texels";
      });
}

}  // namespace

std::vector<Law> changing_laws() { return {positions_law(), update_law()}; }

}  // namespace mmverify::proofs::bake
