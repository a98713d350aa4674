// Bakers of attribute micromaps from a texture, ours and obvious ones, compared by time and by wrong codes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mmverify::bench {

struct AttributeBakeOptions {
  std::uint32_t first = 4, last = 6;  ///< levels
  std::uint32_t texels = 2048;        ///< along a side of the generated texture
  std::uint32_t triangle = 92;  ///< texels along a leg of a triangle: about 4,000 texels, as in the Avocado
  std::size_t triangles = 512;  ///< at most
  std::size_t rounds = 5;       ///< rounds of the timing, whose median counts; at least 1
  std::uint64_t seed = 1;
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// One way of baking: the time of a value, and the number of values with a code that is not the exact one.
struct AttributeWay {
  double ns = 0;
  std::uint64_t wrong = 0;
};

/// The ways of baking, in this order everywhere.  Faces: ours; each texel's square clipped by the triangle in
/// binary64; the mean of the texels whose centres lie inside, or else the centroid's texel ("averaging the
/// pixels covered").  Vertices: ours; bilinear in binary32 at p0 + (p1 - p0) u + (p2 - p0) v.
enum class AttributeBakeWay : std::uint8_t { faces, clipped, centres, vertices, binary32 };
inline constexpr std::size_t attribute_bake_ways = 5;
const char* to_string(AttributeBakeWay way);

/// The figures of all triangles at one level, for one meaning of the codes.
struct AttributeBakeLevel {
  std::uint32_t level = 0;
  bool srgb = false;
  std::uint64_t face_values = 0, vertex_values = 0;
  double exact = 0;  ///< the share of our values that took whole numbers
  std::array<AttributeWay, attribute_bake_ways> by{};

  const AttributeWay& of(AttributeBakeWay w) const { return by[static_cast<std::size_t>(w)]; }
};

/// The figures of a generated texture and a mesh of uneven triangles over it.  The clipped, centres and
/// binary32 ways bake a part of the triangles; `face_values` and `vertex_values` count the values of that
/// part.
/// Throws std::invalid_argument unless rounds > 0, triangles > 0, 0 <= first <= last <= 8, 4 <= triangle < texels / 2 and
/// texels is up to 8192.
std::vector<AttributeBakeLevel> attribute_bake_figures(const AttributeBakeOptions& options = {});

}  // namespace mmverify::bench
