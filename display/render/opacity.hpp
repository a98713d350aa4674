// The opacity of a candidate hit, from micromaps in any form.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "display/render/barycentrics.hpp"
#include "impl/micromap/array.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::render {

class Opacity {
 public:
  Opacity() = default;
  Opacity(const Opacity&) = delete;
  Opacity& operator=(const Opacity&) = delete;
  virtual ~Opacity() = default;
  /// The state at a hit; none if the triangle has no micromap.
  /// Domain: a triangle of a geometry of the maps' world, and a point of the triangle.
  virtual std::optional<impl::micromap::State> at(std::uint32_t geometry, std::uint32_t triangle,
                                                  const Barycentrics& b) const = 0;
  /// Bytes of maps, records and indices.
  virtual std::uint64_t bytes() const = 0;
};

/// The micromaps of a world: one array, and a code a triangle, by geometry.  A geometry without codes has no
/// micromaps.
struct Micromaps {
  impl::micromap::Array array;
  std::vector<std::vector<std::uint32_t>> codes;  ///< records or special indices, of 32 bits
  unsigned index_bytes = 4;                       ///< bytes of a code in a build
};

/// A triangle's place in a square map: corner k of the lower or upper half is the triangle's vertex order[k].
struct SquarePlace {
  static constexpr std::uint32_t none = 0xffffffff;
  std::uint32_t map = none;
  impl::vq::Half half = impl::vq::Half::lower;
  std::array<std::uint8_t, 3> order{0, 1, 2};
};

/// Square maps, and the place of each triangle, by geometry.  A geometry without places has no maps.
struct Squares {
  std::vector<impl::vq::Map2> vq2;
  std::vector<impl::vq::Map4> vq4;
  std::vector<std::vector<SquarePlace>> places;
};

/// The form in which a hit's opacity is looked up.
enum class Method : std::uint8_t {
  texture,  ///< no micromap: the texture decides each candidate
  special,  ///< special indices only: a map that is not uniform counts as none
  flat,     ///< packed states
  tree,     ///< the paper's two sequences, read bit by bit
  ranked,   ///< impl::tree::Tree, for random access
  vq2,      ///< 16 x 16 regions a pair of triangles, whatever the level
  vq4,      ///< 32 x 32 regions
  bitmask,  ///< the texture's alpha test in bits a texel: see bitmask.hpp
};
inline constexpr Method methods[] = {Method::texture, Method::special, Method::flat, Method::tree,
                                     Method::ranked,  Method::vq2,     Method::vq4,  Method::bitmask};
std::string_view name_of(Method method);
/// The method with this name; none if there is no such method.
std::optional<Method> method_of(std::string_view name);
/// Whether the method's maps have a level.  The sides of VQ2 and VQ4 are fixed, and textures and bitmasks have no maps.
bool has_levels(Method method);

/// The micromaps in a method's form.  Domain: a method with levels; the micromaps outlive the result.
std::unique_ptr<Opacity> opacity_of(Method method, const Micromaps& micromaps);
/// The square maps, encoded: VQ2 by its optimal encoder, VQ4 by the balanced one.  Domain: vq2 or vq4; the
/// maps outlive the result.
std::unique_ptr<Opacity> opacity_of(Method method, const Squares& squares);

}  // namespace mmverify::render
