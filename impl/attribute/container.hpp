// Attribute micromaps in a file: what their values mean and where they lie, said once and checked before anything is
// used.  docs/ATTRIBUTE_FORMAT.md has the bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "impl/attribute/bake.hpp"
#include "impl/attribute/compress.hpp"
#include "impl/attribute/order.hpp"

namespace mmverify::impl::attribute {

/// Which micro-triangle a point on an edge belongs to.  Of values at vertices it does not matter.
enum class TieRule : std::uint8_t {
  none,    ///< of vertices
  vulkan,  ///< towards +u and +v, on a square's diagonal towards -u: VK_EXT_opacity_micromap's reference code
  figure_4,  ///< towards -u and +v, on a row's edge towards +(u+v): Color and Attribute Micromaps, figure 4
};

/// What a set flag does to an edge beside a neighbour of one level less (docs/ATTRIBUTE.md, Decimation).
enum class DecimationRule : std::uint8_t { none, snapping, means };

/// How the values are stored.
enum class Payload : std::uint8_t { plain, packed };

/// A triangle has that map, under those flags.
struct MapUse {
  std::uint32_t map = 0;
  std::uint8_t decimated = 0;  ///< bit 0 edge w-u, bit 1 edge u-v, bit 2 edge v-w
  friend bool operator==(const MapUse&, const MapUse&) = default;
};

/// Maps of one shape, and the triangles that have them.
struct AttributeMaps {
  MapAt at = MapAt::faces;
  FaceOrder face_order = FaceOrder::curve;           ///< of faces
  VertexOrder vertex_order = VertexOrder::bird;      ///< of vertices
  std::uint32_t level = 0;                           ///< 0..12
  std::uint8_t components = 15;                      ///< bit c: component c of RGBA is stored; not 0
  Meaning meaning = Meaning::linear;                 ///< of all but linear ones RGB, with the length RGBA
  TieRule tie = TieRule::vulkan;                     ///< of vertices none
  DecimationRule decimation = DecimationRule::none;  ///< of faces and of level 0 none
  /// Each map begins with the maps of its lower levels, the coarsest first: of faces on the curve, plain.  Vertices and
  /// packed faces have their lower levels within.
  bool mips = false;
  Payload payload = Payload::plain;
  std::array<std::uint8_t, 4> error = {};  ///< of packed: as PackedShape
  std::uint32_t maps = 0;
  std::vector<MapUse> triangles = {};  ///< none: triangle t has map t
  /// Channel c, the c-th component that is stored, of value x of map m: [(m values_of_entry + x) channels + c].
  std::vector<std::uint8_t> codes = {};

  friend bool operator==(const AttributeMaps&, const AttributeMaps&) = default;
};

/// How many components are stored.
std::uint32_t channels_of(const AttributeMaps& maps) noexcept;

/// Values that a map stores, its lower levels where there are mips among them.
std::uint64_t values_of_entry(const AttributeMaps& maps) noexcept;

/// Bytes that are no such file: "byte 5: stored at 2; 0 (faces) or 1 (vertices) would do".
class BadAttributeFile : public std::runtime_error {
 public:
  BadAttributeFile(std::uint64_t byte, const std::string& found, const std::string& would_do);
  std::uint64_t byte() const noexcept { return byte_; }

 private:
  std::uint64_t byte_;
};

inline constexpr std::size_t attribute_header = 44;

/// The bytes of a file.  Of packed maps with errors the codes become those that read_attributes() gives back.
/// Errors: std::invalid_argument where the members do not go together, with the reason that read_attributes() would give.
std::vector<std::uint8_t> write_attributes(const AttributeMaps& maps);

/// The maps of a file: write_attributes() of them gives back the very bytes.
/// Domain: any bytes.  Memory: the codes, at most some 100 times the input, and only once all that the header announces is
/// there.  Errors: BadAttributeFile for what write_attributes() does not write.
AttributeMaps read_attributes(std::span<const std::uint8_t> bytes);

}  // namespace mmverify::impl::attribute
