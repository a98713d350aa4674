// The value of a map at a point of its triangle.
#pragma once

#include <span>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// The rule for values between micro-vertices.
enum class MapReading : std::uint8_t { interpolated, nearest };

/// The index on the curve of the micro-triangle that contains the point, which is the index into a map of
/// MapBaker's faces.
/// Domain: u, v >= 0, u+v <= 1.  Ties as in impl/index.
std::size_t face_index(unsigned level, double u, double v);

/// The mean of the corners of the micro-triangle, by the point's weights there.  nearest: the corner of the
/// greatest weight, the first of equal ones.  A point on an edge has the same value in both of its
/// micro-triangles.
///   lower one (iu,iv) (iu+1,iv) (iu,iv+1): 1-fu-fv, fu, fv
///   upper one (iu+1,iv+1) (iu,iv+1) (iu+1,iv): fu+fv-1, 1-fu, 1-fv
/// Domain: a map of MapBaker's vertices; u, v as above.  Source: Color and Attribute Micromaps, 4.1.
MapValue vertex_value(std::span<const MapValue> map, unsigned level, double u, double v, MapReading reading,
                      const CodeMeaning& meaning);

/// The interpolated mean before it is rounded to a code.
CodeMeaning::Mean vertex_mean(std::span<const MapValue> map, unsigned level, double u, double v,
                              const CodeMeaning& meaning);

}  // namespace mmverify::scene
