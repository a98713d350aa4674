// The Quad: two triangles with two textures, made by code.
#pragma once

#include "scene/read/file.hpp"

namespace mmverify::scene {

/// A GLB with one square of two triangles that shows all of a texture of base colours and of one of normals, 1024 x 1024
/// texels each: rings that get finer outwards, and waves.  The bytes are the same on every machine with IEEE's arithmetic.
/// Source: Color and Attribute Micromaps, table 2: "Quad", which is not shipped.
Bytes quad_scene();

}  // namespace mmverify::scene
