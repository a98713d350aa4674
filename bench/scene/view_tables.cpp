#include "bench/scene/view_tables.hpp"

#include <algorithm>
#include <cmath>

#include "scene/attribute/picture.hpp"
#include "scene/flip/flip.hpp"

namespace mmverify::bench {
namespace {

std::string text_of(render::ShownFrom from) {
  return from == render::ShownFrom::textures ? "textures"
         : from == render::ShownFrom::faces  ? "faces"
                                             : "vertices";
}

/// The mean of channel c over the block of pixels at (x, y).
template <class Channel>
std::uint8_t mean_of_block(const render::Picture& of, std::uint32_t x, std::uint32_t y, std::uint32_t block,
                           Channel channel) {
  double sum = 0, count = 0;
  for (std::uint32_t j = block * y; j < std::min(of.height, block * (y + 1)); ++j)
    for (std::uint32_t i = block * x; i < std::min(of.width, block * (x + 1)); ++i) {
      sum += channel(i + std::size_t{of.width} * j);
      ++count;
    }
  return static_cast<std::uint8_t>(std::floor(sum / count + 0.5));
}

}  // namespace

ViewError view_error(const render::Picture& textures, const render::Picture& maps,
                     const std::vector<std::uint8_t>& textured, unsigned threads) {
  ViewError error;
  error.map = flip::error_map({textures.width, textures.height, textures.rgb},
                              {maps.width, maps.height, maps.rgb}, {.threads = threads});
  error.flip = flip::mean(error.map);
  error.textured_flip = flip::mean(error.map, textured);
  double squares = 0, count = 0;
  for (std::size_t k = 0; k < textured.size(); ++k) {
    if (textured[k] == 0) continue;
    for (std::size_t c = 3 * k; c < 3 * k + 3; ++c) {
      const double off = static_cast<double>(textures.rgb[c]) - maps.rgb[c];
      squares += off * off;
    }
    count += 3;
  }
  error.textured_rmse = count > 0 ? std::sqrt(squares / count) : 0;
  return error;
}

render::Picture beside(const render::Picture& textures, const render::Picture& maps, const ViewError& error,
                       std::uint32_t longest) {
  constexpr std::uint32_t gap = 4;
  const std::uint32_t block = (std::max(textures.width, textures.height) + longest - 1) / longest;
  const std::uint32_t across = (textures.width + block - 1) / block,
                      down = (textures.height + block - 1) / block;
  render::Picture all{3 * across + 2 * gap, down, {}};
  all.rgb.assign(std::size_t{3} * all.width * all.height, 255);
  const auto fill = [&](std::uint32_t column, auto code) {
    for (std::uint32_t y = 0; y < down; ++y)
      for (std::uint32_t x = 0; x < across; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          all.rgb[3 * (column * (across + gap) + x + std::size_t{all.width} * y) + c] = mean_of_block(
              textures, x, y, block, [&](std::size_t pixel) -> double { return code(pixel, c); });
  };
  fill(0, [&](std::size_t pixel, std::size_t c) { return textures.rgb[3 * pixel + c]; });
  fill(1, [&](std::size_t pixel, std::size_t c) { return maps.rgb[3 * pixel + c]; });
  fill(2, [&](std::size_t pixel, std::size_t c) { return scene::colour_of_error(error.map[pixel])[c]; });
  return all;
}

Result view_tables(const ViewFigures& figures) {
  using F = ViewFigures;
  using R = ViewRow;
  const Fields<F> whole{
      {{.key = "file"}, [](const F& f) { return f.file; }},
      {{"triangles", "triangles"}, [](const F& f) { return f.triangles; }},
      {{"textured_triangles", "with a texture, and in view"},
       [](const F& f) { return f.textured_triangles; }},
      {{"textured_pixels", "pixels that show a texture"}, [](const F& f) { return f.textured_pixels; }},
  };
  Fields<R> rows{
      {{.key = "from", .heading = "maps of", .leads = true}, [](const R& r) { return text_of(r.from); }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const R& r) { return std::uint64_t{r.level}; }},
      {{"flip", "FLIP", "", {5}}, [](const R& r) { return r.error.flip; }},
      {{"textured_flip", "FLIP, textured", "", {5}}, [](const R& r) { return r.error.textured_flip; }},
      {{"textured_rmse", "RMSE, textured", "codes", {3}}, [](const R& r) { return r.error.textured_rmse; }},
  };
  if (std::any_of(figures.rows.begin(), figures.rows.end(), [](const R& r) { return !r.file.empty(); }))
    rows.push_back({{"picture", "picture"}, [](const R& r) { return r.file; }});
  return {
      .topic = "views",
      .settings = {{"embree", figures.embree},
                   {"width", std::uint64_t{figures.width}},
                   {"height", std::uint64_t{figures.height}},
                   {"rays", std::uint64_t{figures.rays} * figures.rays},
                   {"shading", std::string(figures.shading == render::Shading::lit ? "lit" : "unlit")},
                   {"camera", figures.camera},
                   {"seed", figures.seed},
                   {"threads", figures.threads}},
      .about = figures.file +
               ": one view, its attributes read of maps in the place of textures, and held against the "
               "textures' own view; FLIP: its mean over all pixels; textured: over those that show a texture",
      .tables = {table_of<F>({.form = Form::members}, whole, {figures}),
                 table_of<R>({.key = "rows"}, rows, figures.rows)}};
}

}  // namespace mmverify::bench
