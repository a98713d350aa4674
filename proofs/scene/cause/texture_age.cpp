#include "proofs/scene/cause/texture_age.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
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
  void join(const Box& box) {
    if (box.area() != 0) add(box.least), add(box.greatest);
  }
  double area() const {
    return std::max(0.0, greatest[0] - least[0]) * std::max(0.0, greatest[1] - least[1]);
  }
};

/// The place along an axis that a coordinate shows, within one repeat.
double shown(double x, mmverify::scene::Wrap wrap) {
  using mmverify::scene::Wrap;
  if (wrap == Wrap::clamp_to_edge) return x;
  if (wrap == Wrap::repeat) return x - std::floor(x);
  return 1 - std::fabs(1 - (x - 2 * std::floor(x / 2)));
}

bool is_known_state(State s) { return s == State::T || s == State::O; }

/// A vertex of level n's grid, in UV.
std::array<double, 2> uv_of(const mmverify::scene::UvTriangle& uvs, std::uint32_t i, std::uint32_t j,
                            Level n) {
  const double side = static_cast<double>(std::uint32_t{1} << n);
  const double u = i / side, v = j / side, w = 1 - u - v;
  return {w * uvs[0][0] + u * uvs[1][0] + v * uvs[2][0], w * uvs[0][1] + u * uvs[1][1] + v * uvs[2][1]};
}

/// The corners of the known states of all maps of one surface, by their UV.
class Corners {
 public:
  /// Notes a triangle's map.  Returns false if a T and an O have a corner in common.
  bool add(const mmverify::scene::UvTriangle& uvs, std::size_t triangle, Level n, const States& stored) {
    const std::size_t row = (std::size_t{1} << n) + 1;
    std::vector<std::uint8_t> known(row * row);  // a grid's vertices; bit 0: of a T, bit 1: of an O
    for (std::uint32_t k = 0; k < stored.size(); ++k)
      if (is_known_state(stored[k]))
        for (const auto& corner : spec::index::corners(k, n)) {
          std::uint8_t& of = known[corner.i * row + corner.j];
          of = static_cast<std::uint8_t>(of | (stored[k] == State::T ? 1 : 2));
        }
    for (std::uint32_t i = 0; i < row; ++i)
      for (std::uint32_t j = 0; i + j < row; ++j)
        if (known[i * row + j] != 0 && !add(uv_of(uvs, i, j, n), triangle, known[i * row + j])) return false;
    return true;
  }
  /// Whether a triangle has a corner of a known state in common with another one.
  bool is_shared(std::size_t triangle) const { return shared_.contains(triangle); }

 private:
  bool add(const std::array<double, 2>& uv, std::size_t triangle, std::uint8_t known) {
    const auto [at, is_new] =
        all_.try_emplace({std::llround(uv[0] * steps), std::llround(uv[1] * steps)}, Met{0, triangle});
    Met& met = at->second;
    met.known = static_cast<std::uint8_t>(met.known | known);
    if (met.known == 3) return false;
    if (met.first != triangle) shared_.insert({met.first, triangle});
    return true;
  }

  static constexpr double steps = 1 << 20;  ///< corners of neighbours differ by roundings alone
  struct Met {
    std::uint8_t known;
    std::size_t first;
  };
  using Place = std::pair<std::int64_t, std::int64_t>;
  std::unordered_map<Place, Met, boost::hash<Place>> all_;
  std::set<std::size_t> shared_;
};

/// The known states of a triangle, those among them that are right, and the texture's part where states are wrong.
struct Known {
  std::uint64_t all = 0, equal = 0;
  Box wrong;
  /// Whether three of five are right: so the map is this triangle's.
  bool is_its_own() const { return 5 * equal >= 3 * all; }
};

/// The findings in the maps of triangles about the texture that they were baked from.
class Findings {
 public:
  explicit Findings(const Judged& judged) : plan_(judged.maps.plan) {}

  /// Takes the map of a planned triangle.
  void add(std::size_t triangle, Level n, const States& stored, const States& right) {
    const auto& planned = plan_.triangles[triangle];
    const auto& sampler = plan_.surfaces[planned.surface].sampler;
    const std::size_t t = known_.size();
    known_.emplace_back();
    surfaces_.push_back(planned.surface);
    for (const auto& uv : planned.uvs) everywhere_.add({uv[0], uv[1]});
    for (std::uint32_t k = 0; k < stored.size(); ++k) {
      const State is = stored[k], should = right[k];
      if (is_known_state(is)) {
        ++known_[t].all;
        known_[t].equal += is == should ? 1 : 0;
        opposite_ += is_known_state(should) && is != should ? 1 : 0;
      }
      ++states_;
      if (is_known_state(is) ? is == should : !is_known_state(should)) continue;
      ++states_wrong_;
      for (const auto& corner : spec::index::corners(k, n)) {
        const auto uv = uv_of(planned.uvs, corner.i, corner.j, n);
        wrong_.add(uv);
        known_[t].wrong.add({shown(uv[0], sampler.wrap_u), shown(uv[1], sampler.wrap_v)});
      }
    }
  }

  /// Whether most states are right, and more than one T or O is the other of the two.
  bool is_mostly_right() const {
    std::uint64_t all = 0, equal = 0;
    for (const Known& one : known_) all += one.all, equal += one.equal;
    return 5 * equal >= 3 * all && 10 * states_wrong_ <= 3 * states_ && opposite_ >= 2;
  }

  /// Takes the corners of the t-th map.  Returns false if no texture allows it beside those before.
  bool add_corners(std::size_t t, std::size_t triangle, Level n, const States& stored) {
    const auto& planned = plan_.triangles[triangle];
    return corners_[planned.surface].add(planned.uvs, t, n, stored);
  }

  /// Whether the t-th map has a wrong known state.
  bool is_wrong(std::size_t t) const { return known_[t].equal != known_[t].all; }

  /// The part that has changed, if the maps may be those of another version.
  /// Domain: is_mostly_right(), and all corners are taken.
  std::optional<Box> changed() const {
    const std::optional<Box> in_texture = wrong_in_texture();
    if (!in_texture) return {};
    // A part of the texture lies at the UVs of several triangles, and one across its edge at both ends of the texture.
    const auto has_wrong = [](const Known& one) { return one.equal != one.all; };
    const bool several = std::count_if(known_.begin(), known_.end(), has_wrong) > 1;
    const Box& changed = several && in_texture->area() < wrong_.area() ? *in_texture : wrong_;
    if (changed.area() > std::min(everywhere_.area(), 1.0) / 2) return {};
    return changed;
  }

 private:
  /// The texture's part where states are wrong; none if a map may be another triangle's.
  std::optional<Box> wrong_in_texture() const {
    Box all;
    std::size_t wrong = 0, last = 0;
    for (std::size_t t = 0; t < known_.size(); ++t) {
      if (known_[t].equal == known_[t].all || !is_trusted(t)) continue;
      ++wrong, last = t;
      all.join(known_[t].wrong);
    }
    // One wrong triangle alone may have another's map, which agrees by chance.
    if (wrong == 0 ||
        (wrong < 2 && !(has_neighbours(last) && 4 * known_[last].equal >= 3 * known_[last].all)))
      return {};
    const Box trusted = all;
    for (std::size_t t = 0; t < known_.size(); ++t)
      if (!is_trusted(t)) all.join(known_[t].wrong);
    if (all.area() > 1.5 * trusted.area()) return {};
    return all;
  }

  /// Neighbours agree with the map of a shared texture; a map without any may be another triangle's.
  bool is_trusted(std::size_t t) const { return known_[t].is_its_own() || has_neighbours(t); }
  bool has_neighbours(std::size_t t) const { return corners_.at(surfaces_[t]).is_shared(t); }

  const mmverify::scene::Plan& plan_;
  std::vector<Known> known_;
  std::vector<std::uint32_t> surfaces_;
  std::map<std::uint32_t, Corners> corners_;  ///< by surface
  std::uint64_t opposite_ = 0, states_ = 0, states_wrong_ = 0;
  Box wrong_, everywhere_;
};

}  // namespace

std::optional<std::string> older_texture(const Judged& judged, const std::vector<std::size_t>& triangles,
                                         const std::vector<States>& stored,
                                         const std::vector<States>& right) {
  Findings findings(judged);
  const auto level = [&](std::size_t t) { return judged.maps.baked.triangles[triangles[t]].level; };
  for (std::size_t t = 0; t < stored.size(); ++t) findings.add(triangles[t], level(t), stored[t], right[t]);
  if (!findings.is_mostly_right()) return {};
  // A clash is at a wrong map.
  for (const bool wrong : {true, false})
    for (std::size_t t = 0; t < stored.size(); ++t) {
      stop_if_due(judged);
      if (findings.is_wrong(t) == wrong && !findings.add_corners(t, triangles[t], level(t), stored[t]))
        return {};
    }
  const std::optional<Box> changed = findings.changed();
  if (!changed) return {};
  return fmt::format(
      "the texture has changed since the bake, within u {:.3f} to {:.3f} and v {:.3f} to {:.3f}",
      changed->least[0], changed->greatest[0], changed->least[1], changed->greatest[1]);
}

}  // namespace mmverify::proofs::scene
