// Maps of a file, tried on triangles that have others.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "proofs/scene/cause/changes.hpp"

namespace mmverify::proofs::scene {

/// The maps of a file, unpacked once each, and the right maps of its triangles.
class Fitting {
 public:
  /// Domain: `judged` outlives this.
  explicit Fitting(const Judged& judged) : judged_(judged), inputs_(inputs_of(judged)) {}

  const Judged& judged() const { return judged_; }
  const Inputs& inputs() const { return inputs_; }

  /// The right map of a planned triangle.
  const States& right(std::size_t triangle, Level n);
  /// Sets a right map that is known already.
  void set_right(std::size_t triangle, Level n, States states) { right_[{triangle, n}] = std::move(states); }

  const mmverify::scene::BakedTriangle& map(std::size_t array, std::uint64_t record);

  /// An order of corners by which a map fits a triangle: each state is known where the right one is, and the same.
  struct Turn {
    mmverify::scene::VertexOrder order;
    std::uint64_t side = 0;  ///< unknown states on the other side than the right ones
  };
  /// The order by which a map, after a change of its states, fits a planned triangle: of several the one with the fewest
  /// states on the other side, and of those the first: not turned, turned, wound the other way.
  /// `change`: a number of map_changes(); none: the states as they are.  `turns`: whether others than the order 0, 1, 2
  /// are tried.
  std::optional<Turn> turn(std::size_t triangle, const mmverify::scene::BakedTriangle& map,
                           std::optional<std::size_t> change = {}, bool turns = true);

 private:
  const Judged& judged_;
  const Inputs inputs_;
  std::map<std::pair<std::size_t, Level>, States> right_;
  std::map<std::pair<std::size_t, std::uint64_t>, mmverify::scene::BakedTriangle> maps_;
};

/// Whether the laws of baking hold on a map: nothing known is wrong, nothing is needlessly unknown.
inline bool holds(const Fit& fit) { return fit.wrong == 0 && fit.needless == 0; }

/// "turned by 1 corner", "wound the other way"; empty for the order 0, 1, 2.
const char* name_of(const mmverify::scene::VertexOrder& order);

/// A map packed in a format, or in 4-state where that has no code for one of its states.
mmverify::scene::BakedTriangle packed(const States& states, Level n, impl::micromap::Format format);

}  // namespace mmverify::proofs::scene
