// Families of cases that are enumerated whole: every texture of a few texels over a few values of alpha,
// under every addressing and some triangles, with the truth about each.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

using spec::micromap::State;
using Triangle = std::array<float, 6>;

/// How a texture is addressed, and by which of a family's triangles it is asked about.
struct Spot {
  Wrap u, v;
  std::size_t triangle;
};

/// All textures of side x side texels over an alphabet of bytes, the first of which is the border's too.
/// Domain: at most 4 values.
struct Family {
  std::uint32_t side;
  std::vector<std::uint8_t> alphabet;
  Cutoff cutoff;
  Filter filter = Filter::bilinear;
  bool blend = false;
  std::vector<std::pair<Wrap, Wrap>> wraps;
  std::vector<Triangle> triangles;
  Rules rules = {};
  Texel texel = Texel::unorm8;  ///< that the bytes are stored as
  std::uint32_t block =
      0;  ///< only the first so many columns and rows vary, the rest repeat the last; 0: all
  std::vector<Spot> spots = {};  ///< empty: each pair of addressing modes with each triangle

  /// Those, triangle by triangle.
  std::vector<Spot> all_spots() const;
  std::uint32_t varied() const { return block == 0 ? side : block; }
};

/// Cases by number: spot by spot, texture by texture.
class Enumerated {
 public:
  explicit Enumerated(Family family);
  ~Enumerated();
  Enumerated(Enumerated&&) noexcept;

  std::uint64_t count() const;
  Case at(std::uint64_t k) const;
  /// The specification's state of every micro-triangle.  What a texture's cells do to one is worked out once
  /// for each four values at their corners (spec::bake::range), and looked up for the textures that have
  /// them.
  std::vector<State> truth(Level n, std::uint64_t k, Threshold threshold = Threshold::exact) const;
  const Family& family() const { return family_; }
  /// "all 81 2x2 textures over 0, 128, 255, ..."
  std::string domain() const;

 private:
  struct Geometry;
  struct Kept;
  std::vector<State> found(Level n, std::uint64_t k, Threshold threshold) const;
  std::vector<std::uint8_t> values(
      std::uint64_t texture) const;  ///< of its texels, by places in the alphabet

  Family family_;
  std::vector<Spot> spots_;
  std::uint64_t textures_;
  std::unique_ptr<Geometry> geometry_;
  std::array<std::unique_ptr<Kept>, 3> kept_;  ///< by threshold
};

/// Several, one after the other.
class Families {
 public:
  explicit Families(std::vector<Family> families);

  std::uint64_t count() const;
  Case at(std::uint64_t k) const;
  std::vector<State> truth(Level n, std::uint64_t k, Threshold threshold = Threshold::exact) const;
  const std::vector<Enumerated>& all() const { return all_; }
  std::string domain() const;

 private:
  std::pair<const Enumerated*, std::uint64_t> find(std::uint64_t k) const;
  std::vector<Enumerated> all_;
};

/// Those of the fast tier: bilinear and MASK; nearest and MASK; bilinear and nearest, BLEND.
const Families& bilinear_families();
const Families& nearest_families();
const Families& blend_families();
/// Of the long tier: every triangle on nine points.
const Families& grid_families();

}  // namespace mmverify::proofs::bake
