// Attribute micromaps in a file: the meaning of their values and their places, stated once and checked before use.
// docs/ATTRIBUTE_FORMAT.md has the bytes.
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

/// The micro-triangle that a point on an edge belongs to.  Values at vertices do not depend on it.
enum class TieRule : std::uint8_t {
  none,    ///< for vertices
  vulkan,  ///< towards +u and +v, on a square's diagonal towards -u: VK_EXT_opacity_micromap's reference code
  figure_4,  ///< towards -u and +v, on a row's edge towards +(u+v): Color and Attribute Micromaps, figure 4
};

/// The rule for a flagged edge, beside a neighbour of one level less (docs/ATTRIBUTE.md, Decimation).
enum class DecimationRule : std::uint8_t { none, snapping, means };

/// The form of the stored values.
enum class Payload : std::uint8_t { plain, packed };

/// A triangle's map, and its edge flags.
struct MapUse {
  std::uint32_t map = 0;
  std::uint8_t decimated = 0;  ///< bit 0 edge w-u, bit 1 edge u-v, bit 2 edge v-w
  friend bool operator==(const MapUse&, const MapUse&) = default;
};

/// Maps of one shape, and the triangles that have them.
struct AttributeMaps {
  MapAt at = MapAt::faces;
  FaceOrder face_order = FaceOrder::curve;           ///< for faces
  VertexOrder vertex_order = VertexOrder::bird;      ///< for vertices
  std::uint32_t level = 0;                           ///< 0..12
  std::uint8_t components = 15;                      ///< bit c: component c of RGBA is stored; not 0
  Meaning meaning = Meaning::linear;                 ///< others than linear need RGB, normal_and_length RGBA
  TieRule tie = TieRule::vulkan;                     ///< none for vertices
  DecimationRule decimation = DecimationRule::none;  ///< none for faces and for level 0
  /// Each map begins with the maps of its lower levels, the coarsest first: for plain faces on the curve only.
  /// Vertices and packed faces contain their lower levels.
  bool mips = false;
  Payload payload = Payload::plain;
  std::array<std::uint8_t, 4> error = {};  ///< for packed maps, as PackedShape; else 0
  std::uint32_t maps = 0;
  std::vector<MapUse> triangles = {};  ///< empty: triangle t has map t
  /// Channel c, the c-th stored component, of value x of map m is codes[(m values_of_entry + x) channels + c].
  std::vector<std::uint8_t> codes = {};

  friend bool operator==(const AttributeMaps&, const AttributeMaps&) = default;
};

/// The number of stored components.
std::uint32_t channels_of(const AttributeMaps& maps) noexcept;

/// The number of values that a map stores, with mips those of its lower levels, too.
std::uint64_t values_of_entry(const AttributeMaps& maps) noexcept;

/// The shape with which pack() packs the codes.
/// Test: impl_attribute_container_test
PackedShape shape_of(const AttributeMaps& maps) noexcept;

/// The error for bytes that are no such file: "byte 5: stored at 2; 0 (faces) or 1 (vertices) would do".
class BadAttributeFile : public std::runtime_error {
 public:
  BadAttributeFile(std::uint64_t byte, const std::string& found, const std::string& would_do);
  std::uint64_t byte() const noexcept { return byte_; }

 private:
  std::uint64_t byte_;
};

inline constexpr std::size_t attribute_header = 44;

/// The bytes of a file.  Packed maps with errors lose something: read_attributes() gives other codes.
/// Errors: std::invalid_argument for members that do not go together, with the reason that read_attributes() would
/// give.
/// Test: impl_attribute_container_test
std::vector<std::uint8_t> write_attributes(const AttributeMaps& maps);
/// The bytes of a file of packed maps; `packed` is pack(shape_of(maps), maps.codes).
/// Test: impl_attribute_container_test
std::vector<std::uint8_t> write_attributes(const AttributeMaps& maps, std::span<const std::uint8_t> packed);

/// The maps of a file; write_attributes() of these maps gives the same bytes.
/// Domain: any bytes.  Memory: the codes, about 100 times the input at most, allocated only if all announced bytes are
/// there.
/// Errors: BadAttributeFile for bytes that write_attributes() does not write.
/// Test: impl_attribute_container_test
AttributeMaps read_attributes(std::span<const std::uint8_t> bytes);

}  // namespace mmverify::impl::attribute
