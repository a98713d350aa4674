// The shapes of the sample scene, in metres, y up.
#pragma once

#include "impl/scene/sample_file.hpp"

namespace mmverify::impl::scene {

SampleMesh leaf_cards();                          ///< 24 cards around a stalk, of both leaves
SampleMesh stalk();                               ///< 1.1 high, four-sided, without UVs
SampleMesh fence_panel();                         ///< 2 x 1, of four quads; u and v from 0 to 1 in each
SampleMesh box(const Position& sizes);            ///< on the ground, without UVs
SampleMesh lying_square(float half, float high);  ///< UVs from corner to corner
SampleMesh flower_fan();                          ///< its vertices are a fan's: the middle, then around
SampleMesh tuft_strip();                          ///< a strip of four triangles, bent

}  // namespace mmverify::impl::scene
