// The laws of baking, on a scene's own triangles.
#include <algorithm>
#include <cstdio>

#include "proofs/engine/random.hpp"
#include "proofs/scene/bake_sample.hpp"
#include "proofs/scene/claimed.hpp"
#include "proofs/scene/exact_surface.hpp"
#include "proofs/scene/laws.hpp"
#include "spec/micromap/micromap.hpp"

namespace mmverify::proofs::scene {
namespace {

namespace micromap = impl::micromap;
using mmverify::scene::BakedTriangle;
using spec::bake::State;

/// The planned triangles of a level, and the surfaces to judge them by.
struct OfLevel {
  const Data& data;
  std::shared_ptr<const ExactSurfaces> exact;
  std::vector<std::size_t> triangles;

  OfLevel(const Data& d, std::shared_ptr<const ExactSurfaces> e, Level n) : data(d), exact(std::move(e)) {
    for (std::size_t k = 0; k < d.baked.triangles.size(); ++k)
      if (d.baked.triangles[k].level == n) triangles.push_back(k);
  }
};

constexpr Claim conservative{"bake.conservative", "a micro-triangle is T or O only where all of it is",
                             Claim::known, "T and O"};
constexpr Claim tight{"bake.tight", "a micro-triangle is unknown only where it is truly mixed",
                      Claim::unknown, "unknown"};
constexpr Claim forced{"bake.force2",
                       "in 2-state a mixed micro-triangle is as alpha at its centroid, another what it is",
                       Claim::forced, "2-state"};

std::string text(const MicroTriangle& p) { return fmt::format("t{}:i{}", p.triangle, p.index); }

const char* name_of_code(unsigned code) {
  return spec::micromap::name_of(static_cast<spec::micromap::State>(code));
}

/// The true state as text, with the alpha and the place that it has.
std::string expected_text(const Data& data, const ExactSurfaces& exact, State truly, Level n,
                          const MicroTriangle& p) {
  return fmt::format("{} ({}{})",
                     truly == State::T   ? "T"
                     : truly == State::O ? "O"
                                         : "unknown",
                     exact.text(p.triangle, n, p.index),
                     data.name_of ? "; " + data.name_of(p.triangle) : std::string());
}

/// The denial of a code as text.
std::string denied_text(const Data& data, const ExactSurfaces& exact, Level n, const MicroTriangle& p,
                        unsigned code) {
  return fmt::format("not {} ({}{})", name_of_code(code), exact.text(p.triangle, n, p.index),
                     data.name_of ? "; " + data.name_of(p.triangle) : std::string());
}

/// The number of no state, for the digest.
constexpr std::uint64_t undecided = 3;

/// A state that neither bounds nor a place decide, unless a place denies the code: T or O.
void judge_undecided(const OfLevel& of, Level n, const MicroTriangle& p, unsigned code, std::uint64_t number,
                     Tally& tally) {
  tally.digest(number, undecided << 2 | code);
  if (!of.exact->denies(p.triangle, n, p.index, code == 1)) return tally.decline(Kind::interior);
  tally.count(Kind::interior, 1);
  tally.mismatch(Kind::interior, {n, number, 0}, [&] {
    return Counterexample{{n, number, 0},    n, text(p), {}, denied_text(of.data, *of.exact, n, p, code),
                          name_of_code(code)};
  });
}

void judge(const Claim& claim, const OfLevel& of, Level n, const MicroTriangle& p, std::uint64_t number,
           Tally& tally) {
  const unsigned code = state_code(of.data.baked.triangles[p.triangle], p.index);
  const std::optional<State> truly = of.exact->state(p.triangle, n, p.index);
  if (!truly) return judge_undecided(of, n, p, code, number, tally);
  const bool leans =
      claim.what == Claim::forced && truly == State::C && of.exact->rather_opaque(p.triangle, n, p.index);
  tally.count(Kind::interior, 1);
  tally.digest(number, static_cast<std::uint64_t>(*truly) << 2 | code);
  if (claim.holds(code, *truly, leans)) return;
  tally.mismatch(Kind::interior, {n, number, 0}, [&] {
    return Counterexample{{n, number, 0},    n, text(p), {}, expected_text(of.data, *of.exact, *truly, n, p),
                          name_of_code(code)};
  });
}

/// A micro-triangle that the claim is about, drawn by a number.  Every second one is near a change of state, if 64
/// draws find such.
MicroTriangle drawn(const Claim& claim, const OfLevel& of, const Claimed& from, Level n, std::uint64_t seed,
                    std::uint64_t number) {
  Random random(seed, 70 + static_cast<std::uint64_t>(claim.what), number << 5 | n);
  const auto any = [&] { return from.at(random.next() % from.size()); };
  const MicroTriangle first = any();
  if (number % 2 == 0) return first;
  MicroTriangle p = first;
  for (int draw = 0; draw < 64; ++draw, p = any())
    if (of.exact->near_change(p.triangle, n, p.index)) return p;
  return first;
}

/// Judges node `index` of depth m, all of whose 4^(n-m) micro-triangles are in the chunk.
void descend(const Claim& claim, const OfLevel& of, Level n, std::size_t triangle, Level m,
             std::uint32_t index, std::uint64_t base, Tally& tally) {
  const std::uint32_t first = index << (2 * (n - m));
  const std::uint64_t count = std::uint64_t{1} << (2 * (n - m));
  const BakedTriangle& baked = of.data.baked.triangles[triangle];
  if (m == n) {
    if (claim.about(state_code(baked, index))) judge(claim, of, n, {triangle, index}, base + index, tally);
    return;
  }
  const std::optional<State> truly = of.exact->state(triangle, m, index);
  if (!truly || truly == State::C) {
    for (std::uint32_t child = 0; child < 4; ++child)
      descend(claim, of, n, triangle, m + 1, 4 * index + child, base, tally);
    return;
  }
  // All micro-triangles of a node that is T or O have that state.
  const unsigned right = truly == State::O ? 1 : 0;
  for (std::uint32_t k = first; k < first + count; ++k) {
    const unsigned code = state_code(baked, k);
    if (!claim.about(code)) continue;
    if (code != right) {
      judge(claim, of, n, {triangle, k}, base + k, tally);
      continue;
    }
    tally.count(Kind::interior, 1);
    tally.digest(base + k, static_cast<std::uint64_t>(*truly) << 2 | code);
  }
}

Replayed replay(const Claim& claim, const Data& data, const ExactSurfaces& exact, Level n,
                const std::string& at) {
  std::size_t triangle = 0;
  std::uint32_t index = 0;
  if (std::sscanf(at.c_str(), "t%zu:i%u", &triangle, &index) != 2 ||
      fmt::format("t{}:i{}", triangle, index) != at || triangle >= data.baked.triangles.size() ||
      data.baked.triangles[triangle].level != n || index >= micromap::micro_triangles(n))
    throw BadCase(fmt::format("{}: no micro-triangle of level {} of this scene; write t17:i1234", at, n));
  const unsigned code = state_code(data.baked.triangles[triangle], index);
  Replayed replayed;
  replayed.got = name_of_code(code);
  const std::optional<State> truly = exact.state(triangle, n, index);
  const bool passes_over = claim.passes_over(data.baked.triangles[triangle]);
  if (!truly || passes_over) {
    replayed.holds = passes_over || !claim.about(code) || !exact.denies(triangle, n, index, code == 1);
    replayed.expected = replayed.holds
                            ? fmt::format("any state: not judged ({})", exact.text(triangle, n, index))
                            : denied_text(data, exact, n, {triangle, index}, code);
    return replayed;
  }
  const bool leans =
      claim.what == Claim::forced && truly == State::C && exact.rather_opaque(triangle, n, index);
  replayed.holds = !claim.about(code) || claim.holds(code, *truly, leans);
  replayed.expected = expected_text(data, exact, *truly, n, {triangle, index});
  return replayed;
}

Law law(const Claim& claim, const Data& data, const std::shared_ptr<const ExactSurfaces>& exact,
        const BakeSample& sample) {
  Law law;
  law.id = claim.id;
  law.topic = "bake";
  law.says = claim.says;
  law.source = "design of state: closed micro-triangles, glTF 2.0 Alpha Coverage; spec/bake/state.hpp";
  law.divisible = true;
  law.undecided = "whose vertex alpha varies, and bounds do not decide";
  const LookedByLevel levels = looked_at(claim, data, sample);
  law.cases = [levels](Level n, const Run&) { return levels.at(n).at; };
  if (std::any_of(levels.begin(), levels.end(), [](const Looked& l) { return !l.whole(); }))
    law.method = Method::sample;
  law.domain = [levels, claim](Level n) {
    return fmt::format("the {} {} micro-triangles of level {} of this scene{}", levels.at(n).all,
                       claim.states, n,
                       levels.at(n).whole() ? ""
                                            : "; every second one drawn within a texel of a change, where 64 "
                                              "draws find one");
  };
  law.how = [levels](Level n) {
    return std::string(levels.at(n).whole() ? "exhaustive, exact" : "sample, exact");
  };
  const bool passes_over = std::any_of(data.baked.triangles.begin(), data.baked.triangles.end(),
                                       [&](const BakedTriangle& t) { return claim.passes_over(t); });
  law.unfit = [levels, claim, passes_over](const Subject&, Level n) -> std::optional<std::string> {
    if (levels.at(n).all != 0) return std::nullopt;
    return fmt::format("no micro-triangle is {}{}", claim.states,
                       passes_over ? ", but for those whose vertex alpha varies" : "");
  };
  law.judge = [claim, &data, exact, levels](const Subject&, Level n, const Run& run) {
    const OfLevel of(data, exact, n);
    if (levels.at(n).whole()) {
      const Level depth = n > piece ? n - piece : 0;
      const std::uint64_t pieces = std::uint64_t{1} << (2 * depth);
      return sweep(run, of.triangles.size() * pieces, 16, [&](Chunk chunk, Tally& tally) {
        for (std::uint64_t k = chunk.begin; k < chunk.end; ++k)
          if (!claim.passes_over(data.baked.triangles[of.triangles[k / pieces]]))
            descend(claim, of, n, of.triangles[k / pieces], depth, static_cast<std::uint32_t>(k % pieces),
                    (k / pieces) << (2 * n), tally);
      });
    }
    const Claimed from(claim, data.baked, n);
    return sweep(run, levels.at(n).at, 64, [&](Chunk chunk, Tally& tally) {
      for (std::uint64_t k = chunk.begin; k < chunk.end; ++k)
        judge(claim, of, n, drawn(claim, of, from, n, run.seed, k), k, tally);
    });
  };
  law.replay = [claim, &data, exact](const Subject&, Level n, const std::string& at) {
    return replay(claim, data, *exact, n, at);
  };
  return law;
}

}  // namespace

std::vector<Law> bake_laws(const Data& data, const ExactSurfacesPtr& exact, const BakeSample& sample) {
  if (data.two_state) return {law(forced, data, exact, sample)};
  return {law(conservative, data, exact, sample), law(tight, data, exact, sample)};
}

}  // namespace mmverify::proofs::scene
