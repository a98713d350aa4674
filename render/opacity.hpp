// What traversal asks of micromaps about a candidate hit, whatever form they are kept in.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "impl/micromap/array.hpp"
#include "impl/vq/vq.hpp"
#include "render/barycentrics.hpp"

namespace mmverify::render {

class Opacity {
 public:
  Opacity() = default;
  Opacity(const Opacity&) = delete;
  Opacity& operator=(const Opacity&) = delete;
  virtual ~Opacity() = default;
  /// The state at a hit; none of a triangle without a micromap.
  /// Domain: a triangle of a geometry of the world that the maps are of, and a point of the triangle.
  virtual std::optional<impl::micromap::State> at(std::uint32_t geometry, std::uint32_t triangle,
                                                  const Barycentrics& b) const = 0;
  /// Bytes of maps, records and indices.
  virtual std::uint64_t bytes() const = 0;
};

/// Micromaps of a world: one array, and a code a triangle, by geometry; no codes: a geometry without micromaps.
struct Micromaps {
  impl::micromap::Array array;
  std::vector<std::vector<std::uint32_t>> codes;  ///< records or special indices, of 32 bits
  unsigned index_bytes = 4;                       ///< that a code takes in a build
};

/// A triangle's place in a square map: corner k of the lower, or the upper, half is its vertex order[k].
struct SquarePlace {
  static constexpr std::uint32_t none = 0xffffffff;
  std::uint32_t map = none;
  impl::vq::Half half = impl::vq::Half::lower;
  std::array<std::uint8_t, 3> order{0, 1, 2};
};

/// Square maps, and each triangle's place, by geometry; no places: a geometry without maps.
struct Squares {
  std::vector<impl::vq::Map2> vq2;
  std::vector<impl::vq::Map4> vq4;
  std::vector<std::vector<SquarePlace>> places;
};

/// How opacity is asked for.
enum class Method : std::uint8_t {
  texture,  ///< no micromap: the texture decides each candidate
  special,  ///< special indices only: maps that are not uniform count as none
  flat,     ///< packed states
  tree,     ///< the paper's two sequences, walked bit by bit
  ranked,   ///< impl::tree::Tree, for random access
  vq2,      ///< 16 x 16 regions a pair, whatever the level
  vq4,      ///< 32 x 32
};
inline constexpr Method methods[] = {Method::texture, Method::special, Method::flat, Method::tree,
                                     Method::ranked,  Method::vq2,     Method::vq4};
std::string_view name_of(Method method);
/// none: there is no such method.
std::optional<Method> method_of(std::string_view name);
/// Whether its maps have the level that is asked for; VQ2's and VQ4's sides are fixed, and a texture has none.
bool has_levels(Method method);

/// The micromaps in a method's form.  Domain: not texture, vq2 or vq4; micromaps that outlive it.
std::unique_ptr<Opacity> opacity_of(Method method, const Micromaps& micromaps);
/// The square maps, encoded: VQ2 by its optimal encoder, VQ4 by the balanced one.  Domain: vq2 or vq4.
std::unique_ptr<Opacity> opacity_of(Method method, const Squares& squares);

}  // namespace mmverify::render
