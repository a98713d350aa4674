// Pictures of maps on their textures: each micro-triangle tinted by its state.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/bake/bake.hpp"
#include "scene/rgb_picture.hpp"

namespace mmverify::scene {

/// One map on its texture.
struct DrawnMap {
  const UvTriangle& uvs;
  const BakedTriangle& map;
};

/// The alpha texture of a surface from black to white, and on it the maps: blue where transparent, green where opaque,
/// orange where unknown.  Borders of micro-triangles of at least 6 pixels are dark.  A map is moved by whole repeats, so
/// that its centroid lies in the texture; of two maps at a pixel the first is drawn.
/// `marked`: the index of a micro-triangle of the first map that is drawn red.
/// The picture shows the box around the maps, at most two repeats along each axis; its longer side has `longest` pixels.
/// Domain: at least one map; finite UVs; longest in 16..8192.
RgbPicture opacity_picture(const Image& image, const Surface& surface, const std::vector<DrawnMap>& maps,
                           std::uint32_t longest, std::optional<std::uint32_t> marked = {});

/// The picture of a material's maps, as above; none if the plan has no triangle of it.
/// Domain: a plan of this scene, and its maps.
std::optional<RgbPicture> material_picture(const Scene& scene, const Plan& plan, const Baked& baked,
                                           std::size_t material, std::uint32_t longest);

}  // namespace mmverify::scene
