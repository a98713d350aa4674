// The maps that a search for a cause looks at: as they are stored, and as they should be.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "proofs/scene/cause/inputs.hpp"

namespace mmverify::proofs::scene {

/// The triangles that changes are tried on have at most so many micro-triangles in all.
inline constexpr std::uint64_t most_tried_micro_triangles = std::uint64_t{1} << 18;

/// Stored and expected states of the triangles that are looked at, by their numbers in the plan.
class Examined {
 public:
  /// Looks at about `most` micro-triangles: beyond it at every n-th triangle.
  /// Domain: judged outlives it.  Errors: exceptions of baking.
  Examined(const Judged& judged, std::uint64_t most);

  const Judged& judged() const { return judged_; }
  const Inputs& inputs() const { return inputs_; }
  const std::vector<std::size_t>& all() const { return all_; }
  /// Some of them, three wrong ones for a right one: a change is tried on these first.
  const std::vector<std::size_t>& tried() const { return tried_; }

  const States& stored(std::size_t triangle) const { return stored_.at(triangle); }
  const States& right(std::size_t triangle) const { return right_.at(triangle); }
  /// The expected map of a triangle at another level.
  const States& right_at(std::size_t triangle, Level n) const;
  std::vector<States> stored(const std::vector<std::size_t>& triangles) const;
  std::vector<States> right(const std::vector<std::size_t>& triangles) const;

  const Fit& fit(std::size_t triangle) const { return fits_.at(triangle); }
  const Fit& fit() const { return as_stored_; }
  Fit fit(const std::vector<std::size_t>& triangles) const;
  bool is_right(std::size_t triangle) const { return fit(triangle).is_right(); }

  const mmverify::scene::MapLink& link(std::size_t triangle) const { return judged_.maps.link(triangle); }
  Level level(std::size_t triangle) const { return judged_.maps.baked.triangles[triangle].level; }
  /// The triangles of the file that a planned one stands for.
  std::uint64_t times(std::size_t triangle) const { return judged_.maps.plan.triangles[triangle].unique; }
  /// The triangles of the file whose maps are wrong or needlessly unknown.
  std::uint64_t wrong() const { return wrong_; }

 private:
  void choose_all(std::uint64_t most);
  void choose_tried();

  const Judged& judged_;
  const Inputs inputs_;
  std::vector<std::size_t> all_, tried_;
  // These have an entry for each triangle that is looked at.
  std::map<std::size_t, States> stored_, right_;
  std::map<std::size_t, Fit> fits_;
  Fit as_stored_;
  std::uint64_t wrong_ = 0;
  mutable std::map<std::pair<std::size_t, Level>, States> at_level_;
};

}  // namespace mmverify::proofs::scene
