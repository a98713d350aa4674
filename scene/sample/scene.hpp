// A scene made by code, which the suite shows and tests if it gets no other.
#pragma once

#include "scene/read/file.hpp"

namespace mmverify::scene {

/// A GLB: three plants of leaf cards, flowers, grass, a wire fence around a bed with a pond.  It has
///   - cards with one picture turned and mirrored, so that triangles see the same piece of a texture;
///   - a tiled fence, by wrap mode and KHR_texture_transform, with 2^k tiles and with other numbers;
///   - triangles all opaque in the middle of the pond, and all transparent above the grass;
///   - lists, a strip and a fan, with indices of 8 and 16 bits and without;
///   - instances, by nodes and by EXT_mesh_gpu_instancing; MASK, BLEND and opaque materials;
///   - a primitive for each reason by which a plan leaves one out: opaque, lines, placed nowhere, of varying
///     vertex alpha, of material variants, animated, with moving UVs, of constant alpha.
/// The bytes are the same at every call, and on every machine with IEEE's arithmetic.
Bytes sample_scene();

}  // namespace mmverify::scene
