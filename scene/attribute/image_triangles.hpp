// The triangles of a set that show an image, and its texels that they show.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "scene/attribute/atlas.hpp"
#include "scene/attribute/set_triangles.hpp"

namespace mmverify::scene {

/// The triangles of one image of AttributeScene::images.
struct ImageTriangles {
  std::size_t image = 0;
  std::vector<std::size_t> maps;       ///< numbers in SetTriangles::all()
  std::vector<TexelTriangle> corners;  ///< of each map
  std::vector<std::uint32_t> first;    ///< by texel: the first triangle that shows it, as first_triangles()
  std::vector<std::uint8_t> shown;     ///< by texel: 1 if a triangle shows it

  // Triangle k's own texels are those that it is the first to show: own[begin[k]] up to own[begin[k + 1]].
  // place is, by texel, the last place where its triangle shows it.
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> own;
  std::vector<std::array<std::int32_t, 2>> place;

  std::uint64_t texels_shown() const;
};

/// Calls visit(texel, u, v) for each own texel of triangle k, once, however often the triangle repeats it.
template <class Visit>
void for_each_own_texel(const ImageTriangles& triangles, std::size_t k, Visit visit) {
  const TexelPlane plane(triangles.corners[k]);
  for (std::size_t t = triangles.begin[k]; t < triangles.begin[k + 1]; ++t) {
    const std::uint32_t texel = triangles.own[t];
    const auto [u, v] = plane.at(triangles.place[texel][0], triangles.place[texel][1]);
    visit(texel, u, v);
  }
}

/// An image of a set: the triangles that show it, and the texels with which their maps are compared.
struct ComparedImage {
  ImageTriangles triangles;
  std::vector<std::uint8_t> original;  ///< compared_texels()
};

/// stop: as in first_triangles().
ComparedImage compared_image(const SetTriangles& triangles, std::size_t image, Averaging averaging,
                             const std::function<void()>& stop = {});

}  // namespace mmverify::scene
