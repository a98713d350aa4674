// Triangles of one place in one texture: what is found of one holds of all.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/attribute/laid_maps.hpp"

namespace mmverify::scene {

/// By triangle, the first of those with its texture and, bit by bit and corner by corner, its UVs; itself where it is that.
/// A forest's leaves are thousands of triangles on few places.
std::vector<std::size_t> first_of_same_uvs(std::span<const MapOfTriangle> triangles);

}  // namespace mmverify::scene
