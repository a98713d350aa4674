#include "tests/documents/bleeding_picture.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>
#include <vector>

#include "proofs/drawing/canvas.hpp"
#include "scene/attribute/charts.hpp"
#include "scene/attribute/mip_errors.hpp"

namespace mmverify::tests {
namespace {

using namespace proofs::drawing;
using namespace scene;

constexpr std::uint32_t side = 16;  ///< of the atlas, in texels
constexpr unsigned last_mip = 3;
constexpr double texel = 12, tile = side * texel;

/// Yellow and blue squares, a red triangle below them, black around; a chart is a little darker from the left above to
/// the right below.
ColourImage atlas_image() {
  using Colour = std::array<std::uint32_t, 3>;
  ColourImage image{"atlas", side, side, {}};
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      Colour colour{20, 20, 20};
      if (y >= 8 && x < 2 * (side - y)) colour = {230, 70, 60};
      if (y < 7 && x < 7) colour = {250, 205, 70};
      if (y < 7 && x >= 8) colour = {70, 110, 235};
      const std::uint32_t darker = colour[0] == 20 ? 0 : 3 * (x % 8 + y % 8);
      for (const std::uint32_t c : colour) image.rgba.push_back(static_cast<std::uint8_t>(c - darker));
      image.rgba.push_back(255);
    }
  return image;
}

/// The charts' corners, in shares of the atlas.
constexpr float seven = 7.0f / side;
const std::vector<std::vector<Uv>> charts{{{0, 0}, {seven, 0}, {seven, seven}, {0, seven}},
                                          {{0.5f, 0}, {1, 0}, {1, seven}, {0.5f, seven}},
                                          {{0, 0.5f}, {1, 0.5f}, {0, 1}}};

AttributeScene atlas_scene() {
  AttributeScene scene;
  scene.file = "an atlas of three charts";
  scene.images.push_back(atlas_image());
  Sampler clamped;
  clamped.wrap_u = clamped.wrap_v = Wrap::clamp_to_edge;
  scene.textures.push_back({set_of(Attribute::base_color), 0, clamped});
  for (const std::vector<Uv>& corners : charts) {
    scene.primitives.push_back({0, 0, {{0, 1, 2}}, {{0, corners}}});
    if (corners.size() == 4) scene.primitives.back().triangles.push_back({0, 2, 3});
    scene.triangles += scene.primitives.back().triangles.size();
  }
  return scene;
}

/// Texels of one colour in a row are one rectangle.
void draw_texels(Canvas& canvas, const Pixel& at, const std::vector<std::uint8_t>& rgb,
                 const std::vector<std::uint8_t>& bands) {
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side;) {
      const auto fill = [&](std::uint32_t across) {
        const std::size_t t = y * side + across;
        return !bands.empty() && bands[t] == no_band
                   ? std::string("#e4e4e4")
                   : fmt::format("#{:02x}{:02x}{:02x}", rgb[3 * t], rgb[3 * t + 1], rgb[3 * t + 2]);
      };
      std::uint32_t end = x + 1;
      while (end < side && fill(end) == fill(x)) ++end;
      canvas.rectangle({at.x + x * texel, at.y + y * texel}, (end - x) * texel, texel, fill(x));
      x = end;
    }
}

void draw_charts(Canvas& canvas, const Pixel& at) {
  for (const std::vector<Uv>& corners : charts) {
    std::vector<Pixel> points;
    for (const Uv& uv : corners)
      points.push_back({at.x + tile * static_cast<double>(uv[0]), at.y + tile * static_cast<double>(uv[1])});
    canvas.polygon(points, "none", ink, 1);
  }
}

struct Mip {
  std::vector<std::uint8_t> texture, faces, vertices, bands;
};

std::string words(const std::string& what, const MipError& error) {
  return fmt::format("{}: border {:.1f}, inside {}", what, error.border.value(),
                     error.interior ? fmt::format("{:.1f}", *error.interior) : "none");
}

}  // namespace

std::string attribute_bleeding() {
  const AttributeScene scene = atlas_scene();
  AttributeOptions options{.first = 0, .last = last_mip};
  std::map<unsigned, Mip> mips;
  MipErrors errors(options, [&mips](const MipPicture& picture) {
    mips[picture.mip] = {picture.texture.rgb, picture.faces.rgb, picture.vertices.rgb,
                         std::vector<std::uint8_t>(picture.bands.begin(), picture.bands.end())};
  });
  options.atlas = [&errors](const AttributeAtlas& atlas) { errors.take(atlas); };
  measure(scene, options);
  const std::vector<MipStep> steps = errors.steps();
  if (steps.size() != last_mip + 1 || mips.size() != steps.size())
    throw std::logic_error("the atlas has another number of mips");

  Canvas canvas(940, 712, "Mips of an atlas of three charts: the texture's, faces and vertices");
  const double left = 20, column = 232, top = 46, row = 222;
  canvas.text({left, 30}, "the atlas", 14, ink, "start", true);
  draw_texels(canvas, {left, top}, mips[0].texture, {});
  draw_charts(canvas, {left, top});
  for (unsigned mip = 1; mip <= last_mip; ++mip) {
    const MipStep& step = steps[mip];
    const Mip& shown = mips[mip];
    const double y = top + row * (mip - 1);
    const auto draw = [&](double x, const std::vector<std::uint8_t>& rgb, const std::string& under) {
      draw_texels(canvas, {x, y}, rgb, shown.bands);
      draw_charts(canvas, {x, y});
      canvas.text({x, y + tile + 17}, under, 12.5);
    };
    draw(left + column, shown.texture, words(fmt::format("mip {}", mip), step.texture));
    draw(left + 2 * column, shown.faces, words(fmt::format("level {}", step.faces.level), step.faces.error));
    draw(left + 3 * column, shown.vertices,
         words(fmt::format("level {}", step.vertices.level), step.vertices.error));
  }
  canvas.text({left + column, 30}, "texture's mips, bilinear", 14, ink, "start", true);
  canvas.text({left + 2 * column, 30}, "faces", 14, ink, "start", true);
  canvas.text({left + 3 * column, 30}, "vertices", 14, ink, "start", true);
  const char* const legend[] = {"Three charts on 16 x 16 texels,", "black between them. Grey: texels",
                                "that no triangle shows.",         "Below: RMSE in codes within",
                                "2^mip texels of another chart",   "or of grey, and inside."};
  double y = top + row + 20;
  for (const char* const line : legend) {
    canvas.text({left, y}, line, 12.5);
    y += 19;
  }
  return canvas.str();
}

}  // namespace mmverify::tests
