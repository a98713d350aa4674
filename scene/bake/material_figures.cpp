#include "scene/bake/material_figures.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <set>

#include "impl/micromap/level.hpp"
#include "scene/bake/any_hit.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using micromap::Bytes;
using micromap::Format;

/// One baked map at its level and all coarser ones.
struct Pyramid {
  struct AtLevel {
    std::uint64_t unknown = 0, bytes = 0;  ///< micro-triangles; 0 bytes if it is uniform
  };
  std::vector<AtLevel> levels;
};

Pyramid::AtLevel counted(const Bytes& four_state, std::uint64_t count) {
  const micromap::StateCounts states = micromap::count_states(four_state, Format::four_state, count);
  const std::uint64_t unknown = states[2] + states[3];
  if (std::any_of(states.begin(), states.end(), [&](std::uint64_t of) { return of == count; }))
    return {unknown, 0};
  const Format format = unknown == 0 ? Format::two_state : Format::four_state;
  return {unknown, micromap::packed_bytes(count, format)};
}

Pyramid pyramid(const BakedTriangle& baked) {
  Pyramid all;
  all.levels.resize(baked.level + 1);
  if (baked.uniform) {
    const bool unknown = *baked.uniform == micromap::State::UT || *baked.uniform == micromap::State::UO;
    for (unsigned n = 0; n <= baked.level; ++n)
      all.levels[n].unknown = unknown ? micromap::micro_triangles(n) : 0;
    return all;
  }
  std::uint64_t count = micromap::micro_triangles(baked.level);
  Bytes map(micromap::packed_bytes(count, Format::four_state));
  const Bytes packed(baked.map.begin(), baked.map.end());
  if (baked.format == Format::two_state)
    micromap::widen(packed, count, map);
  else
    map = packed;
  all.levels[baked.level] = counted(map, count);
  for (unsigned n = baked.level; n-- != 0;) {
    count /= 4;
    Bytes coarser(micromap::packed_bytes(count, Format::four_state));
    micromap::down(map, Format::four_state, count, coarser);
    map = std::move(coarser);
    all.levels[n] = counted(map, count);
  }
  return all;
}

/// The figures of one material, of its primitives in turn.
class Sum {
 public:
  Sum(std::size_t material, std::size_t levels) {
    figures_.material = material;
    figures_.levels.resize(levels);
  }

  void add(std::size_t triangle, const Pyramid& map, double area) {
    ++figures_.triangles;
    figures_.area += area;
    const bool is_new = met_.insert(triangle).second;
    figures_.distinct += is_new ? 1 : 0;
    for (std::size_t n = 0; n < figures_.levels.size(); ++n) {
      const std::size_t own = std::min(n, map.levels.size() - 1);
      const Pyramid::AtLevel& at = map.levels[own];
      const double count = static_cast<double>(micromap::micro_triangles(static_cast<micromap::Level>(own)));
      figures_.levels[n].unknown += area * static_cast<double>(at.unknown) / count;
      if (!is_new) continue;
      figures_.levels[n].maps += at.bytes != 0 ? 1 : 0;
      figures_.levels[n].bytes += at.bytes;
    }
  }

  MaterialFigures figures() && {
    for (MaterialLevel& level : figures_.levels)
      level.unknown = figures_.area > 0 ? level.unknown / figures_.area : 0;
    return std::move(figures_);
  }

 private:
  MaterialFigures figures_;
  std::set<std::size_t> met_;
};

}  // namespace

std::vector<MaterialFigures> material_figures(const Scene& scene, const Plan& plan, const Baked& baked) {
  std::vector<Pyramid> pyramids(baked.triangles.size());
  oneapi::tbb::parallel_for(std::size_t{0}, pyramids.size(),
                            [&](std::size_t k) { pyramids[k] = pyramid(baked.triangles[k]); });
  std::size_t levels = 0;
  for (const Pyramid& one : pyramids) levels = std::max(levels, one.levels.size());
  std::map<std::size_t, Sum> sums;
  for (const PlannedPrimitive& planned : plan.primitives) {
    const Primitive& primitive = scene.primitives[planned.primitive];
    Sum& sum = sums.try_emplace(*primitive.material, *primitive.material, levels).first->second;
    for (std::size_t t = 0; t < planned.triangles.size(); ++t) {
      const std::size_t triangle = planned.triangles[t].triangle;
      sum.add(triangle, pyramids[triangle], placed_area(scene, primitive, t));
    }
  }
  std::vector<MaterialFigures> all;
  for (auto& [material, sum] : sums) all.push_back(std::move(sum).figures());
  return all;
}

std::optional<unsigned> level_for(const MaterialFigures& figures, double share) {
  for (std::size_t n = 0; n < figures.levels.size(); ++n)
    if (figures.levels[n].unknown <= share) return static_cast<unsigned>(n);
  return {};
}

MaterialFigures total(const std::vector<MaterialFigures>& all) {
  MaterialFigures sum;
  for (const MaterialFigures& one : all) {
    sum.triangles += one.triangles;
    sum.distinct += one.distinct;
    sum.area += one.area;
    sum.levels.resize(std::max(sum.levels.size(), one.levels.size()));
    for (std::size_t n = 0; n < one.levels.size(); ++n) {
      sum.levels[n].maps += one.levels[n].maps;
      sum.levels[n].bytes += one.levels[n].bytes;
      sum.levels[n].unknown += one.levels[n].unknown * one.area;
    }
  }
  for (MaterialLevel& level : sum.levels) level.unknown = sum.area > 0 ? level.unknown / sum.area : 0;
  return sum;
}

}  // namespace mmverify::scene
