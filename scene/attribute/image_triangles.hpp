// The triangles of a set that show an image, and its texels that they show.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scene/attribute/atlas.hpp"
#include "scene/attribute/laid_maps.hpp"

namespace mmverify::scene {

/// Of one image of AttributeScene::images.
struct ImageTriangles {
  std::size_t image = 0;
  std::vector<std::size_t> maps;       ///< among all of the set
  std::vector<TexelTriangle> corners;  ///< of each
  std::vector<std::uint32_t> first;    ///< by texel: the first that shows it, as first_triangles()
  std::vector<std::uint8_t> shown;     ///< by texel: 1 where there is one

  std::uint64_t texels_shown() const;
};

/// stop: as of first_triangles().  Domain: triangles within_reach().
ImageTriangles image_triangles(const AttributeScene& scene, std::size_t image,
                               std::span<const MapOfTriangle> all, const std::function<void()>& stop = {});

}  // namespace mmverify::scene
