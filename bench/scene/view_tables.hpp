// Views of a scene shaded by attribute micromaps, compared with the view that its textures give.
#pragma once

#include <string>
#include <vector>

#include "bench/result.hpp"
#include "display/render/scene/views.hpp"

namespace mmverify::bench {

/// The difference of a view and the textures' view.
struct ViewError {
  double flip = 0;           ///< mean FLIP over all pixels, as the paper's figure 11
  double textured_flip = 0;  ///< the mean over the pixels that show a texture; 0 if none does
  double textured_rmse = 0;  ///< over these pixels, in codes of 8 bits, over the three channels
  std::vector<float> map;    ///< FLIP by pixel
};

/// The difference of two pictures.  Domain: pictures of one size, a byte of `textured` a pixel.
ViewError view_error(const render::Picture& textures, const render::Picture& maps,
                     const std::vector<std::uint8_t>& textured, unsigned threads);

/// Textures, maps and FLIP's map beside each other, with a white gap between them.  Each is made smaller by
/// the least whole number that leaves no side above `longest`, as means of codes.  Domain: as of
/// view_error(); longest > 0.
render::Picture beside(const render::Picture& textures, const render::Picture& maps, const ViewError& error,
                       std::uint32_t longest);

struct ViewRow {
  render::ShownFrom from = render::ShownFrom::faces;
  unsigned level = 0;
  render::Detail detail = render::Detail::finest;
  ViewError error = {};
  std::string file = {};  ///< its picture; empty if none was written
};

struct ViewFigures {
  std::string file, embree;
  std::uint64_t triangles = 0;           ///< of the scene
  std::uint64_t textured_triangles = 0;  ///< with a texture, that rays met
  std::uint64_t textured_pixels = 0;
  std::uint32_t width = 0, height = 0, rays = 1;  ///< rays along each side of a pixel
  /// The same of the textures' view with more rays that the rows are compared with; 0: the rows' own number.
  std::uint32_t reference = 0;
  ViewError textures = {};  ///< with a reference: the textures' view with as many rays as the rows
  render::Shading shading = render::Shading::lit;
  std::uint64_t camera = 0, seed = 0, threads = 0;
  std::vector<ViewRow> rows;
};

/// The tables of views.  Source: Color and Attribute Micromaps, figures 1 and 11, table 3.  Domain: a row at
/// least.
Result view_tables(const ViewFigures& figures);

}  // namespace mmverify::bench
