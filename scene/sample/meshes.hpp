// The shapes of the sample scene, in metres, y up.
#pragma once

#include "scene/sample/file.hpp"

namespace mmverify::scene {

SampleMesh leaf_cards();                ///< 24 cards around a stalk, of both leaves
SampleMesh stalk();                     ///< 1.1 high, four-sided, without UVs
SampleMesh fence_panel();               ///< 2 x 1, of four quads; u from 0 to 4, v from 0 to 1
SampleMesh box(const Position& sizes);  ///< on the ground, without UVs
/// A square of cells x cells quads, UVs from corner to corner.
SampleMesh lying_square(float half, float high, int cells = 1);
SampleMesh flower_fan();  ///< its vertices are a fan: the middle, then around
SampleMesh tuft_strip();  ///< a strip of six triangles, bent

}  // namespace mmverify::scene
