#include "bench/attribute/bench.hpp"

#include <algorithm>
#include <stdexcept>

namespace mmverify::bench {
namespace {

/// The options of bakes: the levels of the range from 4 to 6, or the nearest level outside of it.
AttributeBakeOptions bake_options(const AttributeBenchOptions& o) {
  AttributeBakeOptions bakes;
  constexpr std::uint32_t least = 4, most = 6;
  bakes.last = std::min(o.last, most);
  bakes.first = std::min(std::max(o.first, std::min(least, o.last)), bakes.last);
  bakes.seed = o.seed;
  bakes.triangles = o.triangles;
  bakes.rounds = std::min(o.rounds, bakes.rounds);
  bakes.progress = o.progress;
  return bakes;
}

}  // namespace

AttributeFigures attribute_figures(const AttributeBenchOptions& o) {
  if (o.samples == 0 || o.rounds == 0 || o.triangles == 0 || o.first > o.last || o.last > 16)
    throw std::invalid_argument(
        "attribute bench: a sample, a round and a triangle at least, levels up to 16");
  AttributeFigures figures{
      attribute_lookups(o), attribute_remaps(o), {}, attribute_bake_figures(bake_options(o)),
      attribute_mips(o),    attribute_lods(o)};
  for (const Remap remap : all_remaps) {
    std::vector<LevelValue> worst;
    for (const RemapLevel& level : figures.remaps)
      if (level.of(remap).no_number == 0) worst.push_back({level.level, level.of(remap).worst});
    figures.growth[static_cast<std::size_t>(remap)] = fit_growth(worst);
  }
  return figures;
}

}  // namespace mmverify::bench
