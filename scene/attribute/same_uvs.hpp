// Triangles at the same place of a texture, which have the same maps and errors.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/attribute/laid_maps.hpp"

namespace mmverify::scene {

/// The number, for each triangle, of the first triangle with its texture and, bit by bit and corner by
/// corner, its UVs.
/// A forest's leaves are thousands of triangles on few places.
std::vector<std::size_t> first_of_same_uvs(std::span<const MapOfTriangle> triangles);

}  // namespace mmverify::scene
