#include "bench/papers/square_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "bench/papers/drawings.hpp"
#include "bench/vq/tables.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::bench::papers {
namespace {

/// The texture whose 32x32 map has most nearly as many O and T as the paper's maple leaf.
std::size_t like_the_maple_leaf(Measured& m) {
  constexpr double known_of_maple = 834.0 / 1024;
  const auto distance = [](const OpacityMaps& maps) {
    return std::abs(savings(maps.regions_32) - known_of_maple);
  };
  const auto& all = m.textures();
  return static_cast<std::size_t>(
      std::min_element(all.begin(), all.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
      all.begin());
}

constexpr std::uint32_t square_side = 256;  ///< pixels

template <class Map>
render::Picture square(const Map& map, const Map& decoded, bool vectors_alone = false) {
  const auto side = static_cast<std::uint32_t>(map.size() == 256 ? 16 : 32);
  return square_picture(map, decoded, side, square_side / side, vectors_alone);
}

/// Figure 3: three textures, those with the least, most nearly the median and the greatest savings, and their maps.
render::Picture square_maps_of(Measured& m) {
  std::vector<const OpacityMaps*> order;
  for (const OpacityMaps& maps : m.textures()) order.push_back(&maps);
  std::stable_sort(order.begin(), order.end(), [](const OpacityMaps* a, const OpacityMaps* b) {
    return savings(a->regions_16) < savings(b->regions_16);
  });
  std::vector<render::Picture> tiles;
  std::vector<std::string> titles;
  for (const OpacityMaps* maps : {order.front(), order[order.size() / 2], order.back()}) {
    tiles.push_back(alpha_picture(m.alpha().at(maps->of), square_side));
    tiles.push_back(square(maps->regions_16, maps->regions_16));
    titles.insert(titles.end(),
                  {"alpha", fmt::format("16x16: saves {:.0f} %", 100 * savings(maps->regions_16))});
  }
  return render::side_by_side(tiles, titles, 0);
}

/// Figure 8: two 2x2 vectors of a map that agree in a T or O and differ elsewhere, and the vector compatible with both.
std::optional<render::Picture> compatible_vector(const OpacityMaps& maps) {
  using impl::vq::State;
  using Vector = std::array<State, 4>;
  std::vector<Vector> vectors;
  for (std::size_t at = 0; at < 256; at += at % 16 == 14 ? 18 : 2)
    vectors.push_back(
        {maps.regions_16[at], maps.regions_16[at + 1], maps.regions_16[at + 16], maps.regions_16[at + 17]});
  for (const Vector& a : vectors)
    for (const Vector& b : vectors) {
      Vector both{};
      int agree = 0, differ = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        both[k] = a[k] == b[k] ? a[k] : State::C;
        agree += a[k] == b[k] && a[k] != State::C ? 1 : 0;
        differ += a[k] != b[k] ? 1 : 0;
      }
      if (agree == 0 || differ != 2) continue;
      const auto drawn = [](const Vector& source, const Vector& shown) {
        return square_picture(source, shown, 2, square_side / 4);
      };
      return render::side_by_side({drawn(a, a), drawn(b, b), drawn(both, both)},
                                  {"a vector", "another", "compatible with both"}, 0);
    }
  return std::nullopt;
}

/// Figures 5 and 9: a texture's map, its blocks, and the regions that they lose in red.
std::vector<Drawn> blocks_of(Measured& m, std::size_t number) {
  const OpacityMaps& maps = m.textures()[number];
  const impl::vq::Encoded2 paper_2 = impl::vq::encode_paper(maps.regions_16),
                           best_2 = impl::vq::encode_optimal(maps.regions_16);
  const impl::vq::Encoded4 paper_4 = impl::vq::encode_paper(maps.regions_32),
                           ours_4 = encode(maps.regions_32);
  const auto title = [](const char* codec, std::uint32_t lost) {
    return fmt::format("{}: {} lost", codec, lost);
  };
  const std::string key = ": T blue, C orange, O green; red: T or O that became C";
  return {
      {"figure 5", "quadrants", maps.of + key,
       render::side_by_side(
           {square(maps.regions_16, maps.regions_16), square(maps.regions_16, maps.regions_16, true),
            square(maps.regions_16, impl::vq::decode(paper_2.block)),
            square(maps.regions_16, impl::vq::decode(best_2.block))},
           {"source, 16x16", "vectors that are not uniform", title("VQ2, algorithm 1", paper_2.substitutions),
            title("VQ2, optimal", best_2.substitutions)},
           0)},
      {"figure 9", "blocks", maps.of + key,
       render::side_by_side(
           {alpha_picture(m.alpha().at(maps.of), square_side), square(maps.regions_32, maps.regions_32),
            square(maps.regions_32, impl::vq::decode(paper_4.block)),
            square(maps.regions_32, impl::vq::decode(ours_4.block))},
           {"alpha", "source, 32x32", title("VQ4, algorithm 2", paper_4.substitutions),
            title("VQ4, default", ours_4.substitutions)},
           0)}};
}

/// Rows of bench vq with the encoders that are drawn.
std::vector<VqRow> drawn_rows(Measured& m) {
  std::vector<VqRow> rows;
  for (std::size_t k = 0; k < m.textures().size(); ++k) {
    const OpacityMaps& maps = m.textures()[k];
    VqRow& row = rows.emplace_back();
    row.savings_64x2 = savings(maps.sub_triangles_64x2);
    row.savings_8 = savings(maps.regions_8);
    row.savings_16 = savings(maps.regions_16);
    row.savings_32 = savings(maps.regions_32);
    const auto lost = [&](VqEncoder encoder) { return m.loss(encoder).lost[k]; };
    row.vq2[static_cast<std::size_t>(Vq2Encoder::paper)].substitutions = lost(VqEncoder::vq2_paper);
    row.vq2[static_cast<std::size_t>(Vq2Encoder::optimal)].substitutions = lost(VqEncoder::vq2_optimal);
    row.vq4[static_cast<std::size_t>(Vq4Encoder::paper)].substitutions = lost(VqEncoder::vq4_paper);
    row.vq4[static_cast<std::size_t>(Vq4Encoder::balanced)].substitutions = lost(VqEncoder::vq4_balanced);
  }
  return rows;
}

}  // namespace

std::vector<Drawn> square_map_pictures(Measured& m) {
  const std::vector<picture::Panel> panels = vq_savings_panels(drawn_rows(m));
  const auto plot = [&](std::size_t k) {
    return picture::Picture{.width = 700, .height = 480, .rows = {{panels[k]}}};
  };
  const std::size_t leaf = like_the_maple_leaf(m);
  std::vector<Drawn> all{
      {"figure 3", "squares", "Three textures as square maps: T blue, C orange, O green", square_maps_of(m)},
      {"figure 6", "savings_vq2", "Savings of VQ2, texture by texture", plot(0)},
      {"figure 7", "savings_resolution", "Savings of the sources by resolution", plot(2)},
      {"figure 10", "savings_vq4", "Savings of VQ4, texture by texture", plot(1)}};
  for (Drawn& one : blocks_of(m, leaf)) all.push_back(std::move(one));
  if (auto compatible = compatible_vector(m.textures()[leaf]))
    all.push_back({"figure 8", "compatible", "Two vectors of a map, and the one that stands for both",
                   *std::move(compatible)});
  return all;
}

}  // namespace mmverify::bench::papers
