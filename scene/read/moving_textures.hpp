// A reader of animations that move textures.
#pragma once

#include <vector>

#include "scene/read/buffers.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// Fills in Material::moving: the ranges of the base colour's KHR_texture_transform, from its own values and those of all
/// samplers of KHR_animation_pointer.
///   STEP, LINEAR   the keys' values
///   CUBICSPLINE    the hull of each segment's four Bezier points: v, v + dt b / 3, v' - dt a' / 3, v'
/// Material::unmoved names a sampler that cannot be read, or another animated property of the material.
/// Domain: materials of read_materials(), with their `animated`.
/// Source: KHR_animation_pointer; glTF 2.0, 3.11 and appendix C.
void read_moving_textures(const Document& document, const Buffers& buffers, std::vector<Material>& materials);

/// The movement of UVs, before their transform, under a range of transforms.
MovingUvs moving_uvs(const TransformRange& range, const std::vector<Uv>& uvs);

}  // namespace mmverify::scene
