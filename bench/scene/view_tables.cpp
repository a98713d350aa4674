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

std::string text_of(render::Shading shading) {
  return shading == render::Shading::lit ? "lit" : shading == render::Shading::unlit ? "unlit" : "normals";
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
  Fields<F> members{
      {{.key = text("file", left_out)}, [](const F& f) { return f.file; }},
      {{count("triangles", same, "of the file"), "triangles"}, [](const F& f) { return f.triangles; }},
      {{positive("textured_triangles", same, "with a texture, that rays met"), "with a texture, and in view"},
       [](const F& f) { return f.textured_triangles; }},
      {{positive("textured_pixels", same, "of which a ray met such a triangle"),
        "pixels that show a texture"},
       [](const F& f) { return f.textured_pixels; }},
  };
  if (figures.reference != 0) {
    members.push_back(
        {{share("textures_flip", about_less,
                "mean FLIP of the textures' view with as many rays as the rows; there with reference")
              .if_any(),
          "FLIP of the textures with these rays",
          "",
          {5}},
         [](const F& f) { return f.textures.flip; }});
    members.push_back(
        {{share("textures_textured_flip", about_less, "the same over the pixels that show a texture")
              .if_any(),
          "the same, textured",
          "",
          {5}},
         [](const F& f) { return f.textures.textured_flip; }});
  }
  Fields<R> rows{
      {{.key = one_of("from", key, {"faces", "vertices"}, "what the maps have values of"),
        .heading = "maps of",
        .leads = true},
       [](const R& r) { return text_of(r.from); }},
      {{.key = level(10, key, "of all maps"), .heading = "level", .leads = true},
       [](const R& r) { return std::uint64_t{r.level}; }},
  };
  if (figures.reference != 0)
    rows.push_back(
        {{.key = one_of("detail", key, {"finest", "cones"},
                        "the level at which they are read: their own, or two of their mips by the cone of "
                        "each ray; "
                        "not there without --cones")
                     .if_any(),
          .heading = "read at",
          .leads = true},
         [](const R& r) { return std::string(r.detail == render::Detail::cones ? "cones" : "finest"); }});
  const Fields<R> errors{
      {{share("flip", about_less, "mean FLIP over all pixels, 67 a degree"), "FLIP", "", {5}},
       [](const R& r) { return r.error.flip; }},
      {{share("textured_flip", about_less, "mean FLIP over the pixels that show a texture"),
        "FLIP, textured",
        "",
        {5}},
       [](const R& r) { return r.error.textured_flip; }},
      {{real("textured_rmse", about_less, {0, 255},
             "codes of 8 bits, over the channels of the pixels that show a texture"),
        "RMSE, textured",
        "codes",
        {3}},
       [](const R& r) { return r.error.textured_rmse; }},
  };
  rows.insert(rows.end(), errors.begin(), errors.end());
  if (std::any_of(figures.rows.begin(), figures.rows.end(), [](const R& r) { return !r.file.empty(); }))
    rows.push_back({{text("picture", left_out,
                          "textures, maps and FLIP beside each other; a path from the folder that the "
                          "program was called in, or an absolute one; not there without --pictures")
                         .if_any(),
                     "picture"},
                    [](const R& r) { return r.file; }});
  Result result{
      .topic = "views",
      .description =
          "mmverify views FILE: one view shaded by attribute micromaps, held against the "
          "textures' view",
      .settings =
          {{text("embree", left_out, "the ray tracer and its version"), figures.embree},
           {whole("width", setting, {1, 4096}, "pixels"), std::uint64_t{figures.width}},
           {whole("height", setting, {1, 4096}, "pixels"), std::uint64_t{figures.height}},
           {whole("rays", setting, {1, 64}, "primary rays of each pixel"),
            std::uint64_t{figures.rays} * figures.rays},
           {one_of("shading", setting, {"lit", "unlit", "normals"},
                   "lit: a sun with shadows and two lamps, GGX; unlit: base colour times occlusion; normals: "
                   "(n + 1)/2 of the scene's own space"),
            text_of(figures.shading)},
           {count("camera", setting, "0: all of the scene; else a number of the random path"),
            figures.camera},
           {count("seed", setting, "of the random path"), figures.seed},
           {count("threads", left_out, "worker threads; 0: as many as the machine has"), figures.threads}},
      .about = figures.file +
               ": one view, its attributes read of maps in the place of textures, and held against the "
               "textures' own view; FLIP: its mean over all pixels; textured: over those that show a texture",
      .tables = {table_of<F>({.form = Form::members}, members, {figures}),
                 table_of<R>({.key = "rows"}, rows, figures.rows)}};
  if (figures.reference != 0)
    result.settings.push_back({whole("reference", setting, {4, 64},
                                     "rays of each pixel of the textures' view that rows are compared with; "
                                     "not there without --cones")
                                   .if_any(),
                               std::uint64_t{figures.reference} * figures.reference});
  return result;
}

}  // namespace mmverify::bench
