// A small generated world for rays: cards of leaves, tiles, glass and wood around a point, above an opaque ground.
#pragma once

#include "display/render/attribute/colour_maps.hpp"
#include "display/render/tracer.hpp"

namespace mmverify::proofs::traverse {

inline constexpr unsigned finest_sample_level = 5;

/// Cards with a soft disc (bilinear, MASK; in pairs, so that they have square maps), with tiles of 16 bits (nearest,
/// mirrored, a factor), and with a gradient (bilinear, BLEND).  Some cards are all opaque and some all transparent.
/// The triangles of a pair begin with each of their vertices.  Meshes are placed unchanged, and turned and mirrored.
class SampleWorld {
 public:
  SampleWorld();

  /// The opacity that a method reads at a level; null for the texture.  Domain: level up to finest_sample_level.
  const render::Opacity* opacity(render::Method method, unsigned level) const;
  const render::Micromaps& micromaps(unsigned level) const { return *maps_.at(level); }
  /// The cards' maps of faces of level 2, of four codes that a mixing function makes.
  const render::ColourMaps& colours() const { return colours_; }
  const render::World& world() const { return world_; }
  /// Built at the first call.  Errors: as of render::Tracer.
  const render::Tracer& tracer() const;
  const render::Box& box() const { return box_; }

  /// The one world, made once.
  static const SampleWorld& get();

 private:
  void add_textures();
  void add_cards();
  void add_maps();
  void add_colours();

  std::vector<std::uint8_t> disc_, gradient_;
  std::vector<std::uint16_t> tiles_;
  render::World world_;
  render::ColourMaps colours_{render::ColoursOf::faces, 2, 4};
  render::Box box_;
  render::Squares squares_;
  std::vector<std::unique_ptr<const render::Micromaps>> maps_;                  ///< by level
  std::vector<std::vector<std::unique_ptr<const render::Opacity>>> opacities_;  ///< by level, then method
};

}  // namespace mmverify::proofs::traverse
