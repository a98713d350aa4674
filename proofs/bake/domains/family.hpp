// Families of cases that are enumerated completely: every texture of a few texels over a few values of alpha, under
// every addressing and some triangles, with the true states of each case.
#pragma once

#include "proofs/bake/support.hpp"

namespace mmverify::proofs::bake {

using spec::micromap::State;
using Triangle = std::array<float, 6>;

/// The addressing of a texture, and the number of the family's triangle.
struct Spot {
  Wrap u, v;
  std::size_t triangle;
};

/// All textures of side x side texels over an alphabet of bytes, the first of which is also the border's. Domain: at
/// most 4 values.
struct Family {
  std::uint32_t side;
  std::vector<std::uint8_t> alphabet;
  Cutoff cutoff;
  Filter filter = Filter::bilinear;
  bool blend = false;
  std::vector<std::pair<Wrap, Wrap>> wraps;
  std::vector<Triangle> triangles;
  Rules rules = {};
  Texel texel = Texel::unorm8;  ///< the form that the bytes are stored in
  std::uint32_t block =
      0;  ///< so many first columns and rows vary, and the rest repeat the last of these; 0: all vary
  std::vector<Spot> spots = {};  ///< empty: each pair of addressing modes with each triangle

  /// The spots of the family, triangle by triangle.
  std::vector<Spot> all_spots() const;
  std::uint32_t varied() const { return block == 0 ? side : block; }
};

/// Cases by number: spot by spot, and at each spot texture by texture.
class Enumerated {
 public:
  explicit Enumerated(Family family);
  ~Enumerated();
  Enumerated(Enumerated&&) noexcept;

  std::uint64_t count() const;
  Case at(std::uint64_t k) const;
  /// The specification's state of every micro-triangle.  The effect of a cell on a micro-triangle is computed once
  /// for each four values at its corners (spec::bake::range), and looked up for all textures with these values.
  std::vector<State> truth(Level n, std::uint64_t k, Threshold threshold = Threshold::exact) const;
  const Family& family() const { return family_; }
  /// The domain as text, "all 81 2x2 textures over 0, 128, 255, ..."
  std::string domain() const;

 private:
  struct Geometry;
  struct CaseCache;
  std::vector<State> found(Level n, std::uint64_t k, Threshold threshold) const;
  std::vector<std::uint8_t> values(
      std::uint64_t texture) const;  ///< of its texels, as places in the alphabet

  Family family_;
  std::vector<Spot> spots_;
  std::uint64_t textures_;
  std::unique_ptr<Geometry> geometry_;
  std::array<std::unique_ptr<CaseCache>, 3> kept_;  ///< by threshold
};

/// Several families, one after the other.
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

/// The families of the fast tier: bilinear and MASK; nearest and MASK; bilinear and nearest, BLEND.
const Families& bilinear_families();
const Families& nearest_families();
const Families& blend_families();
/// The families of the long tier: every triangle on nine points.
const Families& grid_families();

/// The families with as many cases, all of them supported.  An unsupported addressing mode is replaced by each
/// triangle turned over, mirrored and with its vertices in other orders.  Made once. Domain: families that last as
/// long as the program; their filter and their alpha mode are supported.
const Families& fitted(const Families& families, const Support& support);

}  // namespace mmverify::proofs::bake
