#include "proofs/scene/cause/texture_age.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "spec/index/index.hpp"

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::State;

/// A box in UV.
struct Box {
  std::array<double, 2> least{1e30, 1e30}, greatest{-1e30, -1e30};

  void add(const std::array<double, 2>& uv) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      least[axis] = std::min(least[axis], uv[axis]);
      greatest[axis] = std::max(greatest[axis], uv[axis]);
    }
  }
  double area() const {
    return std::max(0.0, greatest[0] - least[0]) * std::max(0.0, greatest[1] - least[1]);
  }
};

bool is_known_state(State s) { return s == State::T || s == State::O; }

/// The UVs of a micro-triangle's corners.
std::array<std::array<double, 2>, 3> corners_of(const mmverify::scene::UvTriangle& uvs, std::uint32_t k,
                                                Level n) {
  std::array<std::array<double, 2>, 3> all{};
  const double side = static_cast<double>(std::uint32_t{1} << n);
  const auto corners = spec::index::corners(k, n);
  for (std::size_t c = 0; c < 3; ++c) {
    const double u = corners[c].i / side, v = corners[c].j / side, w = 1 - u - v;
    for (std::size_t axis = 0; axis < 2; ++axis)
      all[c][axis] = w * uvs[0][axis] + u * uvs[1][axis] + v * uvs[2][axis];
  }
  return all;
}

/// The corners of the known states of all maps of one surface, by their UV.
class Corners {
 public:
  /// Notes a micro-triangle of a triangle.  Returns false if a T and an O have a corner in common.
  bool add(const mmverify::scene::UvTriangle& uvs, std::size_t triangle, std::uint32_t k, Level n,
           State state) {
    for (const std::array<double, 2>& uv : corners_of(uvs, k, n)) {
      Met& met = all_[{std::llround(uv[0] * steps), std::llround(uv[1] * steps)}];
      (state == State::T ? met.t : met.o) = true;
      if (met.t && met.o) return false;
      if (met.first == none) met.first = triangle;
      if (met.first != triangle) shared_.insert({met.first, triangle});
    }
    return true;
  }
  /// Whether a triangle has a corner of a known state in common with another one.
  bool is_shared(std::size_t triangle) const {
    return std::any_of(shared_.begin(), shared_.end(), [triangle](const auto& pair) {
      return pair.first == triangle || pair.second == triangle;
    });
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};
  static constexpr double steps = 1 << 20;  ///< corners of neighbours differ by roundings alone
  struct Met {
    bool t = false, o = false;
    std::size_t first = none;
  };
  std::map<std::pair<std::int64_t, std::int64_t>, Met> all_;
  std::set<std::pair<std::size_t, std::size_t>> shared_;
};

}  // namespace

std::optional<std::string> older_texture(const Judged& judged, const std::vector<std::size_t>& triangles,
                                         const std::vector<States>& stored,
                                         const std::vector<States>& right) {
  /// The known states of a triangle, and those among them that are right.
  struct Known {
    std::uint64_t all = 0, equal = 0;
  };
  std::uint64_t opposite = 0, states = 0, states_wrong = 0;
  Box wrong, everywhere;
  std::vector<Known> known(stored.size());
  std::map<std::uint32_t, Corners> corners;  // by surface
  for (std::size_t t = 0; t < stored.size(); ++t) {
    const Level n = judged.maps.baked.triangles[triangles[t]].level;
    const auto& planned = judged.maps.plan.triangles[triangles[t]];
    for (const auto& uv : planned.uvs) everywhere.add({uv[0], uv[1]});
    for (std::uint32_t k = 0; k < stored[t].size(); ++k) {
      const State is = stored[t][k], should = right[t][k];
      if (is_known_state(is)) {
        if (!corners[planned.surface].add(planned.uvs, t, k, n, is)) return {};
        ++known[t].all;
        known[t].equal += is == should ? 1 : 0;
        opposite += is_known_state(should) && is != should ? 1 : 0;
      }
      ++states;
      if (is_known_state(is) ? is == should : !is_known_state(should)) continue;
      ++states_wrong;
      for (const auto& uv : corners_of(planned.uvs, k, n)) wrong.add(uv);
    }
  }
  Known all, of_wrong;
  std::uint64_t triangles_wrong = 0;
  for (std::size_t t = 0; t < stored.size(); ++t) {
    all.all += known[t].all, all.equal += known[t].equal;
    if (known[t].equal == known[t].all) continue;
    ++triangles_wrong;
    of_wrong.all += known[t].all, of_wrong.equal += known[t].equal;
    // Neighbours agree with the map of a shared texture; a map without any may be another triangle's.
    const bool has_neighbours = corners[judged.maps.plan.triangles[triangles[t]].surface].is_shared(t);
    if (!has_neighbours && 5 * known[t].equal < 3 * known[t].all) return {};
  }
  if (5 * all.equal < 3 * all.all || 10 * states_wrong > 3 * states) return {};
  // One wrong triangle may have another's map, which agrees by chance.
  const bool is_one_other_map = triangles_wrong < 2 && 4 * of_wrong.equal < 3 * of_wrong.all;
  if (opposite < 2 || is_one_other_map || wrong.area() > everywhere.area() / 2) return {};
  return fmt::format(
      "the texture has changed since the bake, within u {:.3f} to {:.3f} and v {:.3f} to {:.3f}",
      wrong.least[0], wrong.greatest[0], wrong.least[1], wrong.greatest[1]);
}

}  // namespace mmverify::proofs::scene
