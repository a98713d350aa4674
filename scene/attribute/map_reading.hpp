// What a map shows at a point of its triangle.
#pragma once

#include <span>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// How values between micro-vertices are read.
enum class MapReading : std::uint8_t { interpolated, nearest };

/// The micro-triangle that the point is of, on the curve; what a map of MapBaker's faces shows there is its value.
/// Domain: u, v >= 0, u+v <= 1.  Ties as in impl/index.
std::size_t face_index(unsigned level, double u, double v);

/// The mean of the corners of the micro-triangle, by the point's weights there; nearest: the corner of the greatest
/// weight, of equal ones the first.  A point on an edge has the same value in both of its micro-triangles.
///   lower one (iu,iv) (iu+1,iv) (iu,iv+1): 1-fu-fv, fu, fv;  upper one (iu+1,iv+1) (iu,iv+1) (iu+1,iv): fu+fv-1, 1-fu, 1-fv
/// Domain: a map of MapBaker's vertices; u, v as above.  Source: Color and Attribute Micromaps, 4.1.
MapValue vertex_value(std::span<const MapValue> map, unsigned level, double u, double v, MapReading reading,
                      const CodeMeaning& meaning);

/// The same interpolated, before it is made a code.
CodeMeaning::Mean vertex_mean(std::span<const MapValue> map, unsigned level, double u, double v,
                              const CodeMeaning& meaning);

}  // namespace mmverify::scene
