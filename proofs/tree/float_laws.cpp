#include "proofs/engine/shape.hpp"
#include "proofs/points/exact_float.hpp"
#include "proofs/points/stiff_floats.hpp"
#include "proofs/tree/law_parts.hpp"
#include "proofs/tree/laws.hpp"
#include "proofs/tree/mutants.hpp"

namespace mmverify::proofs::tree {
namespace {

using points::FloatPair;
using spec::micromap::micro_triangles;

constexpr char law_id[] = "tree.point_exact_on_floats";

/// The highest level at which all of a map is noise.  Above it only subtrees of `noisy_subtree` levels around the
/// pairs are: a lookup that reads a tree from its beginning takes time in proportion to its size.
constexpr Level noisy_levels = 6, noisy_subtree = 2;

struct Sizes {
  std::uint64_t maps, pairs;  ///< maps of the level, pairs looked up in each
};

/// The sizes fall with the level, since maps of high levels take long to make and to encode.
Sizes sizes(Level n, const Run& run) {
  const Sizes fast = n <= 8 ? Sizes{32, 256} : n <= 10 ? Sizes{8, 256} : Sizes{2, 256};
  return run.tier == Tier::fast ? fast : Sizes{8 * fast.maps, fast.pairs};
}

std::uint32_t index_of(Level n, const FloatPair& p) {
  return points::on_exact(p.u, p.v, [n](const auto& q) { return spec::index::reference(q, n); });
}

FloatPair pair(Level n, std::uint64_t seed, std::uint64_t map, std::uint64_t k) {
  return points::stiff_floats(n, seed, map * 256 + k);
}

/// Map number `map` of a level, 2-state and 4-state in turn.  Its noise lies around its pairs, so that neighbours
/// differ there; the rest has one state.
Map noisy_map(Level n, std::uint64_t seed, std::uint64_t map, std::uint64_t pairs) {
  const Format f = map % 2 == 0 ? Format::two_state : Format::four_state;
  const unsigned b = bits(f), states = 1u << b;
  Random random(seed, n, map);
  Map made{n, f, Bytes(spec::micromap::packed_bytes(micro_triangles(n), f))};
  const auto rest = static_cast<std::uint8_t>(random.below(states) * (f == Format::two_state ? 0xFF : 0x55));
  const std::uint64_t noise_seed = random.next();
  const auto set = [&](std::uint64_t k, std::uint64_t state) {
    std::uint8_t& byte = made.packed[k * b / 8];
    const std::uint64_t shift = k * b % 8, mask = (states - 1) << shift;
    byte = static_cast<std::uint8_t>((byte & ~mask) | state << shift);
  };
  // Noise depends only on k, since the subtrees of several pairs may be the same.
  const auto make_noise = [&](std::uint64_t from, std::uint64_t count) {
    for (std::uint64_t k = from; k < from + count; ++k) set(k, Random(noise_seed, n, k).below(states));
  };
  if (n <= noisy_levels) {
    make_noise(0, micro_triangles(n));
    return made;
  }
  std::fill(made.packed.begin(), made.packed.end(), rest);
  for (std::uint64_t k = 0; k < pairs; ++k) {
    const std::uint64_t size = micro_triangles(noisy_subtree);
    make_noise(index_of(n, pair(n, seed, map, k)) / size * size, size);
  }
  return made;
}

Finding looked_up(const Map& map, const FloatPair& p, std::uint8_t got) {
  const std::uint32_t index = index_of(map.level, p);
  const std::uint8_t expected = state_at(map, index);
  if (got == expected) return {got};
  return wrong(fmt::format("state at index {}", index), fmt::format("{}", expected), fmt::format("{}", got));
}

Tally judge(const Subject& subject, Level n, const Run& run) {
  const auto [maps, pairs] = sizes(n, run);
  return sweep(
      run, maps, 1,
      [&, pairs = pairs](Chunk chunk, Tally& tally) {
        std::vector<float> u(pairs), v(pairs);
        for (std::uint64_t m = chunk.begin; m < chunk.end; ++m) {
          const Map map = noisy_map(n, run.seed, m, pairs);
          for (std::uint64_t k = 0; k < pairs; ++k) {
            const FloatPair p = pair(n, run.seed, m, k);
            u[k] = p.u, v[k] = p.v;
          }
          Bytes states(pairs, 0xFF);
          const Functions& asked = subject_as<TreeSubject>(subject).functions;
          asked.point(asked.encode(map), u, v, states);
          tally.count(Kind::interior, pairs);
          for (std::uint64_t k = 0; k < pairs; ++k) {
            tally.digest(m * pairs + k, states[k]);
            const Finding found = looked_up(map, {u[k], v[k]}, states[k]);
            if (!found.holds)
              tally.mismatch(Kind::interior, {n, m, k}, [&] {
                return Counterexample{{n, m, k},
                                      n,
                                      fmt::format("hard:{}:{}:{}", run.seed, m, k),
                                      fmt::format("({:a},{:a})", u[k], v[k]),
                                      found.expected,
                                      found.got};
              });
          }
        }
      },
      [pairs = pairs](std::uint64_t, Tally& tally) {
        for (std::uint64_t k = 0; k < pairs; ++k) tally.decline(Kind::interior);
      });
}

Replayed replay(const Subject& subject, Level n, const std::string& at) {
  const Groups parts =
      at.size() > 64 ? std::nullopt : groups_of(at, "hard:([0-9]{1,19}):([0-9]{1,9}):([0-9]{1,9})");
  if (!parts || n > 12)
    throw BadCase(fmt::format("'{:.60}': write hard:SEED:MAP:PAIR, at a level up to 12", at));
  const std::uint64_t seed = std::stoull((*parts)[1]), m = std::stoull((*parts)[2]),
                      k = std::stoull((*parts)[3]);
  const auto [maps, pairs] = sizes(n, Run{});
  if (k >= pairs) throw BadCase(fmt::format("'{}': each map has {} pairs", at, pairs));
  const Map map = noisy_map(n, seed, m, pairs);
  const FloatPair p = pair(n, seed, m, k);
  std::uint8_t got = 0xFF;
  const Functions& asked = subject_as<TreeSubject>(subject).functions;
  asked.point(asked.encode(map), {&p.u, 1}, {&p.v, 1}, {&got, 1});
  return replayed(looked_up(map, p, got));
}

/// A mutant that is wrong only at this pair of this level.
Change wrong_at(Level level, float u, float v) {
  return finds_points_wrongly([=](const Map& map, float pu, float pv, std::uint8_t& state) {
    if (map.level == level && pu == u && pv == v) state ^= 1;
  });
}

}  // namespace

Law point_exact_on_floats_law() {
  Law law{
      .id = law_id,
      .says =
          "a lookup by barycentrics gives the state at the exact reference's index of those very binary32 "
          "numbers",
      .source = "Succinct Opacity Micromaps, 4.2, Algorithm 3; VK_EXT_opacity_micromap, \"Reference Code\"",
      .method = Method::sample,
      .subjects = {"tree-spec", "tree-ranked", "tree-stepwise"},
      .tiers = {.fast = {0, 12}, .long_run = {0, 12}, .seconds = 2}};
  law.cases = [](Level n, const Run& run) { return sizes(n, run).maps * sizes(n, run).pairs; };
  law.domain = [](Level n) {
    return fmt::format(
        "a sample of binary32 pairs near what breaks index functions, in maps that are noise {}",
        n <= noisy_levels ? "throughout" : "around them");
  };
  law.how = "sample, against exact arithmetic";
  law.unfit = needing({entry::point});
  law.divisible = true;
  law.judge = judge;
  law.replay = replay;
  law.mutants = {mutant("one pair of level 7, an ulp under the v-corner", "tree-spec", {7, 7},
                        wrong_at(7, 0.0f, 0x1.fffffep-1f))};
  return law;
}

Law with_points_on_floats(Law law) {
  law.companion = law_id;
  law.domain = [maps = law.domain](const Subject& s, Level n) {
    return maps(s, n) + (subject_as<TreeSubject>(s).functions.point ? "; points at multiples of 1/4N" : "");
  };
  return law;
}

}  // namespace mmverify::proofs::tree
