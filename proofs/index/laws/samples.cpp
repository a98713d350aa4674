// The laws on samples of every level: what the sweeps of the fast tier do not reach.
#include "proofs/index/laws/groups.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"

namespace mmverify::proofs::index {
namespace {

std::uint64_t samples(Level, const Run& run) { return run.tier == Tier::fast ? 8'192 : 1'000'000; }

std::string sampled_indices(const Subject&, Level) {
  return "a sample of the 4^n indices, and the seven cells of their micro-triangles";
}
std::string sampled_indices_alone(const Subject&, Level) { return "a sample of the 4^n indices"; }

Law on_samples_law() {
  return {
      .id = "index.on_samples",
      .says =
          "index, corners in any order, row-order index and row-order corners are the specification's, at "
          "every level",
      .source = "VK_EXT_opacity_micromap; Color and Attribute Micromaps, 4.1, figure 4",
      .method = Method::sample,
      .subjects = {"reference", "step", "w-minor", "impl"},
      .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 1},
      .cases = samples,
      .domain = sampled_indices,
      .how = by_sample,
      .unfit = [](const Subject& subject, Level n) -> std::optional<std::string> {
        for (const Entry e : {entry::index, entry::corners, entry::row_index, entry::row_corners})
          if (!needing({e})(subject, n)) return std::nullopt;
        return needing({entry::index})(subject, n);
      },
      .divisible = true,
      .judge =
          [](const Subject& s, Level n, const Run& run) {
            return on_samples(subject_as<IndexSubject>(s), n, run, samples(n, run));
          },
      .replay = replayed_by(replay_on_samples),
      .mutants = {mutant("lines u = i/N belong to their -u side from level 12 on", "reference", {11, 12},
                         on_points([](Level n, const GridPoint& p, std::uint32_t answer) {
                           if (n < 12 || !on_u_line(p, n) || p.u == Fixed64(0)) return answer;
                           return spec::index::reference(GridPoint{Fixed64::from_raw(p.u.raw() - 1), p.v}, n);
                         }))}};
}

Law corners_on_samples_law() {
  return {.id = "index.corners_on_samples",
          .says =
              "the corners of an index are those of the specification, in the order that a subject declares "
              "where it declares one, at every level",
          .source = succinct_4_3,
          .method = Method::sample,
          .subjects = {"impl"},
          .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 0.3},
          .cases = samples,
          .domain = sampled_indices_alone,
          .how = by_sample,
          .unfit = needing({entry::corners}),
          .divisible = true,
          .judge =
              [](const Subject& s, Level n, const Run& run) {
                return corners_on_samples(subject_as<IndexSubject>(s), n, run, samples(n, run));
              },
          .replay = replayed_by(replay_corners_on_samples),
          .mutants = {mutant("the last digit of level 14 is not looked at", "impl", {14, 14},
                             on_indices([](Level n, std::uint32_t k, Corners c) {
                               return n == 14 ? spec::index::corners(k & ~3u, n) : c;
                             }))}};
}

}  // namespace

std::vector<Law> sample_laws() { return {on_samples_law(), corners_on_samples_law()}; }

}  // namespace mmverify::proofs::index
