// The specification's view of a plan: the exact state of any of its micro-triangles.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "proofs/engine/result.hpp"
#include "scene/plan/plan.hpp"
#include "spec/bake/range.hpp"

namespace mmverify::proofs::scene {

/// The findings of bounds and places on a micro-triangle: its state, and whether a place is not opaque, or not transparent.
struct Seen {
  std::optional<spec::bake::State> state;
  bool not_opaque, not_transparent;
};

class ExactSurfaces {
 public:
  /// Copies the textures of the plan's surfaces.  Margin: in texels, finite and not below 0.
  ExactSurfaces(const mmverify::scene::Scene& scene, const mmverify::scene::Plan& plan, float margin);
  ~ExactSurfaces();

  /// The state of micro-triangle `index` of level n of a planned triangle: spec::bake in whole numbers, or in
  /// rationals where these find none.  If vertex alpha varies, in rationals, T and O by bounds of parts of it, C by two
  /// points; none if neither decides.
  /// Domain: triangle below Plan::triangles.size(), index < 4^n, n in 0..16.
  std::optional<spec::bake::State> state(std::size_t triangle, Level n, std::uint32_t index) const;

  /// Whether a place of a micro-triangle denies that it is O, or T.  Domain: as above, and state() is none.
  bool denies(std::size_t triangle, Level n, std::uint32_t index, bool opaque) const;

  /// Whether alpha at its centroid is rather opaque: UO, not UT.  Domain: of a triangle whose vertex alpha does not vary.
  bool rather_opaque(std::size_t triangle, Level n, std::uint32_t index) const;

  /// Its range of alpha as quotients and decimals, and its place: "alpha 1/5..4/5, 0.200..0.800, at UV (0.2500, 0.5000),
  /// texel (16, 32)".
  std::string text(std::size_t triangle, Level n, std::uint32_t index) const;

  /// Whether texels on both sides of the cutoff lie less than a texel from it; a choice for samples, no proof.
  bool near_change(std::size_t triangle, Level n, std::uint32_t index) const;

  /// The number of calls of state() so far that took rationals because whole numbers find no state.
  std::uint64_t in_rationals() const { return in_rationals_; }

 private:
  class OfSurface;
  Seen seen(std::size_t triangle, Level n, std::uint32_t index) const;
  const OfSurface& of(std::size_t triangle) const;

  const mmverify::scene::Plan& plan_;
  mutable std::atomic<std::uint64_t> in_rationals_ = 0;
  std::vector<std::unique_ptr<const OfSurface>> surfaces_;
};

}  // namespace mmverify::proofs::scene
