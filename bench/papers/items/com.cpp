// The items of Compressed Opacity Maps for Ray Tracing.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "bench/papers/item.hpp"

namespace mmverify::bench::papers {
namespace {

using Ours = std::function<std::vector<double>(Measured&)>;

constexpr double regions_of_vq2 = 256, regions_of_vq4 = 1024;

/// The mean of a figure over all textures.
double mean(Measured& m, const std::function<double(const OpacityMaps&)>& figure) {
  double sum = 0;
  for (const OpacityMaps& maps : m.textures()) sum += figure(maps);
  return sum / static_cast<double>(m.textures().size());
}

double sources_64x2(const OpacityMaps& maps) { return 100 * savings(maps.sub_triangles_64x2); }
double sources_8(const OpacityMaps& maps) { return 100 * savings(maps.regions_8); }
double sources_16(const OpacityMaps& maps) { return 100 * savings(maps.regions_16); }
double sources_32(const OpacityMaps& maps) { return 100 * savings(maps.regions_32); }

Ours mean_of(double (*figure)(const OpacityMaps&)) {
  return [=](Measured& m) { return std::vector<double>{mean(m, figure)}; };
}

bool of_vq2(VqEncoder encoder) {
  return encoder == VqEncoder::vq2_paper || encoder == VqEncoder::vq2_optimal;
}

/// The mean savings of an encoder, in %.
double encoded(Measured& m, VqEncoder encoder) {
  const std::vector<std::uint32_t>& lost = m.loss(encoder).lost;
  const double all = std::accumulate(lost.begin(), lost.end(), 0.0) / static_cast<double>(lost.size());
  return of_vq2(encoder) ? mean(m, sources_16) - 100 * all / regions_of_vq2
                         : mean(m, sources_32) - 100 * all / regions_of_vq4;
}
Ours savings_of(VqEncoder encoder) {
  return [=](Measured& m) { return std::vector<double>{encoded(m, encoder)}; };
}
/// Points above a map without a codec in the same bits.
Ours gain(VqEncoder encoder) {
  return [=](Measured& m) {
    return std::vector<double>{encoded(m, encoder) - mean(m, of_vq2(encoder) ? sources_64x2 : sources_16)};
  };
}

/// The same over that map's savings, in %.
Ours relative_gain(VqEncoder encoder) {
  return [=](Measured& m) {
    const double without = mean(m, of_vq2(encoder) ? sources_64x2 : sources_16);
    return std::vector<double>{100 * (encoded(m, encoder) / without - 1)};
  };
}

/// The share of O and T that an encoder turns into C, in %.
Ours lost_share(VqEncoder encoder) {
  return [=](Measured& m) {
    const std::vector<std::uint32_t>& lost = m.loss(encoder).lost;
    const double known =
        of_vq2(encoder) ? mean(m, sources_16) * regions_of_vq2 : mean(m, sources_32) * regions_of_vq4;
    return std::vector<double>{100 * std::accumulate(lost.begin(), lost.end(), 0.0) * 100 /
                               (known * static_cast<double>(lost.size()))};
  };
}

/// The combinations of transforms: how many were chosen, once, and the share of the commonest in %.
struct Choices {
  double combinations = 0, once = 0, commonest = 0;
};
Choices choices(Measured& m, bool of_parts) {
  std::map<std::uint32_t, double> times;
  const std::vector<std::uint32_t>& all = m.loss(VqEncoder::vq2_paper, of_parts).transforms;
  for (const std::uint32_t one : all) ++times[one];
  Choices found{.combinations = static_cast<double>(times.size())};
  for (const auto& [one, count] : times) {
    if (count == 1) ++found.once;
    found.commonest = std::max(found.commonest, 100 * count / static_cast<double>(all.size()));
  }
  return found;
}
/// The figure over whole textures, and over their connected parts.
Ours chosen(double Choices::*figure) {
  return [=](Measured& m) {
    return std::vector<double>{choices(m, false).*figure, choices(m, true).*figure};
  };
}

/// The shares of 2x2 vectors of 16x16 maps that are uniformly T, C and O, in %.
class UniformVectors {
 public:
  void add(const impl::vq::Map2& map) {
    for (std::size_t y = 0; y < 16; y += 2)
      for (std::size_t x = 0; x < 16; x += 2) {
        const std::size_t at = x + 16 * y;
        ++vectors_;
        if (map[at + 1] == map[at] && map[at + 16] == map[at] && map[at + 17] == map[at])
          ++uniform_[static_cast<std::size_t>(map[at])];
      }
  }
  std::vector<double> shares() const {
    std::vector<double> all;
    for (const double count : uniform_) all.push_back(100 * count / std::max(1.0, vectors_));
    return all;
  }

 private:
  double vectors_ = 0;
  std::array<double, 3> uniform_{};
};

std::vector<double> uniform_of(const std::vector<OpacityMaps>& all) {
  UniformVectors vectors;
  for (const OpacityMaps& maps : all) vectors.add(maps.regions_16);
  return vectors.shares();
}
std::vector<double> uniform_of_pairs(Measured& m) {
  UniformVectors vectors;
  for (const std::size_t k : masked(m))
    for (const impl::vq::Map2& map : m.squares(k).maps.vq2) vectors.add(map);
  return vectors.shares();
}

/// Squares of side x side regions that hold no O beside T in any 2x2 window, counted row by row.
double continuous_vectors(unsigned side) {
  unsigned rows = 1;
  for (unsigned k = 0; k < side; ++k) rows *= 3;
  const auto at = [](unsigned row, unsigned column) {
    for (unsigned k = 0; k < column; ++k) row /= 3;
    return row % 3;
  };
  const auto fit = [&](unsigned above, unsigned below) {
    for (unsigned k = 0; k + 1 < side; ++k) {
      unsigned seen = 0;
      for (const unsigned row : {above, below})
        for (const unsigned column : {k, k + 1}) seen |= 1u << at(row, column);
      if ((seen & 5) == 5) return false;  // bits of T and O
    }
    return true;
  };
  std::vector<double> ways(rows, 1);
  for (unsigned k = 1; k < side; ++k) {
    std::vector<double> next(rows, 0);
    for (unsigned below = 0; below < rows; ++below)
      for (unsigned above = 0; above < rows; ++above)
        if (fit(above, below)) next[below] += ways[above];
    ways = std::move(next);
  }
  return std::accumulate(ways.begin(), ways.end(), 0.0);
}

Ours constant(double value) {
  return [value](Measured&) { return std::vector<double>{value}; };
}

/// The share of the pairs' square that a codec's blocks decide, in %.
Ours pairs_known(bool vq4) {
  return [=](Measured& m) {
    return by_scene(m, [&](std::size_t k) {
      const scene::VqFootprint& f = vq4 ? m.squares(k).vq4 : m.squares(k).vq2;
      return 100 - 100 * static_cast<double>(f.unknown + f.substitutions) / static_cast<double>(f.regions);
    });
  };
}

std::string per_cent(double value) { return fmt::format("{:.1f}", value); }

/// Figures 6, 7 and 10: the savings of each texture, in the order of the 16x16 sources.
Grid savings_by_texture(Measured& m) {
  Grid grid{{"texture", "64 x 2", "8x8", "16x16", "32x32", "VQ2, Algorithm 1", "VQ2, optimal",
             "VQ4, Algorithm 2", "VQ4, default"},
            {}};
  std::vector<std::size_t> order(m.textures().size());
  std::iota(order.begin(), order.end(), 0);
  const auto of = [&](std::size_t k) -> const OpacityMaps& { return m.textures()[k]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sources_16(of(a)) < sources_16(of(b)); });
  for (const std::size_t k : order) {
    const auto after = [&](VqEncoder e) {
      const double lost = m.loss(e).lost[k];
      return of_vq2(e) ? sources_16(of(k)) - 100 * lost / regions_of_vq2
                       : sources_32(of(k)) - 100 * lost / regions_of_vq4;
    };
    grid.rows.push_back({of(k).of, per_cent(sources_64x2(of(k))), per_cent(sources_8(of(k))),
                         per_cent(sources_16(of(k))), per_cent(sources_32(of(k))),
                         per_cent(after(VqEncoder::vq2_paper)), per_cent(after(VqEncoder::vq2_optimal)),
                         per_cent(after(VqEncoder::vq4_paper)), per_cent(after(VqEncoder::vq4_balanced))});
  }
  return grid;
}

constexpr char textures_command[] = "bench vq --textures FOLDER";
constexpr char other_scenes[] =
    "San Miguel and Landscape are not shipped; ours: the share of the pairs' area that a block decides";

std::vector<Item> introduction_of_maps() {
  return {
      {"figure 1",
       "San Miguel: alpha tests of primary rays, 17.5 M to 4.6 M",
       Status::differs,
       "render FILE --method vq2,vq4 --heat OUT.png",
       other_scenes,
       {{"fewer, by a format without a name; ours VQ2", {74}, "%", pairs_known(false)},
        {"ours VQ4", {74}, "%", pairs_known(true)}}},
      {"1 a",
       "alpha tests of San Miguel's secondary rays",
       Status::not_here,
       "render FILE --method texture",
       "the scene is not shipped; secondary rays here are shadow rays",
       {{"tests", {71}, "M", {}}}},
      {"figure 2",
       "a mask of 64 sub-triangles on a leaf",
       Status::differs,
       textures_command,
       "another leaf: the mean over ours, two such masks a texture",
       {{"expected reduction", {53}, "%", mean_of(sources_64x2)}}},
      {"1 b",
       "Gruen et al.: fewer any-hit calls by resolution",
       Status::ok,
       textures_command,
       "the means of our sources from 64 x 2 to 32x32",
       {{"reduction",
         {19, 86},
         "%",
         [](Measured& m) {
           return std::vector<double>{mean(m, sources_64x2), mean(m, sources_32)};
         }}}},
      {"1 c", "opacity micromaps double a scene's traversal on some GPUs", Status::not_here, "",
       "a graphics card's frame time"},
      {"2 a",
       "three states in less than 2 bits: five in 8",
       Status::ok,
       textures_command,
       "3^5 = 243 states fit; a map of 16x16 takes 416 bits so (VQ.md)",
       {{"bits of five states",
         {8},
         "",
         [](Measured&) {
           double bits = 0;
           for (unsigned states = 3 * 3 * 3 * 3 * 3; (1u << static_cast<unsigned>(bits)) < states;) ++bits;
           return std::vector<double>{bits};
         }}}},
      {"2 b", "with a continuous filter T and O never meet", Status::ok, "prove vq.vectors",
       "closed regions of bilinear alpha that share a point are never O and T (VQ.md, The maps)"},
  };
}

std::vector<Item> maps_of_pairs() {
  return {
      {"figure 3", "square maps of 16x16 on pairs", Status::ok, "paper com -o FOLDER", "VQ.md, The maps"},
      {"3 a",
       "bits a region, bytes a map",
       Status::ok,
       "prove vq2.block_bits vq4.block_bits",
       "the blocks' fields fill them (VQ.md)",
       {{"VQ2", {1}, "bits", constant(256 / regions_of_vq2)},
        {"VQ4", {0.5}, "bits", constant(512 / regions_of_vq4)},
        {"bytes a map",
         {32, 128},
         "B",
         [](Measured&) {
           return std::vector<double>{32, 64};
         }}}},
      {"3 b", "rivals: a 3-level quad-tree, a wavelet modulo 3", Status::ok, "bench vq",
       "one reading of each, in the same bits (VQ.md, The rivals)"},
      {"4 a",
       "2x2 vectors without O beside T, of 3^4",
       Status::ok,
       "prove vq.vectors",
       "counted",
       {{"vectors", {31}, "", [](Measured&) { return std::vector<double>{continuous_vectors(2)}; }},
        {"bits for all 3^4", {7}, "", constant(std::ceil(4 * std::log2(3.0)))}}},
      {"figure 4", "a vector's code of 5 bits", Status::differs, "prove vq.codes",
       "the paper leaves the bits' order open; VQ.md fixes one"},
      {"4 b",
       "uniform 2x2 vectors in scene data, each",
       Status::differs,
       "paper com --item 4",
       "it depends on what a map covers: a leaf or a spray of leaves (ERRATA.md)",
       {{"T; C; O, whole textures", {11, 29}, "%", [](Measured& m) { return uniform_of(m.textures()); }},
        {"T; C; O, each connected part alone",
         {11, 29},
         "%",
         [](Measured& m) { return uniform_of(m.parts()); }},
        {"T; C; O, pairs of the scenes", {11, 29}, "%", uniform_of_pairs}}},
  };
}

std::vector<Item> vq2_form() {
  return {
      {"figure 5", "quadrants and their symmetry", Status::ok, "paper com -o FOLDER; prove vq.transforms",
       "VQ.md; the page draws a texture's vectors"},
      {"table 1", "eight transforms from three", Status::differs, "prove vq.transforms",
       "two readings of their order (ERRATA.md)"},
      {"4.1 a",
       "12 multiplexers of 2 inputs",
       Status::not_here,
       "",
       "no hardware here; three transforms of four bits each are 12",
       {{"multiplexers", {12}, "", constant(3 * 4)}}},
      {"4.1 b",
       "the codebook: 11 vectors of 5 bits",
       Status::ok,
       "prove vq2.block_bits",
       "256 bits without 64 indices of 3 and 3 transforms of 3",
       {{"bits", {55}, "", constant(256 - 64 * 3 - 3 * 3)}}},
      {"4.1 c",
       "bits that the order of entries could carry",
       Status::ok,
       "",
       "floor(log2(3!)) + 4, unused here as well",
       {{"bits", {6}, "", constant(2 + 4)}}},
      {"algorithm 1", "VQ2's encoder over 2^9 transforms", Status::differs, "prove vq2; bench vq",
       "the print takes rare vectors first: both readings measured, and the optimum (ERRATA.md)"},
  };
}

std::vector<Item> vq2_results() {
  return {
      {"4.3 a",
       "170 alpha textures, de-noised and cropped",
       Status::differs,
       textures_command,
       "60 generated leaves, or a folder of yours; VQ.md has 36 free ones",
       {{"textures",
         {170},
         "",
         [](Measured& m) { return std::vector<double>{static_cast<double>(m.textures().size())}; }}}},
      {"figure 6",
       "savings of VQ2 across the textures",
       Status::differs,
       textures_command,
       "a picture without numbers; a row a texture in the pages",
       {{"source 16x16, mean", {}, "%", mean_of(sources_16)},
        {"Algorithm 1, mean", {}, "%", savings_of(VqEncoder::vq2_paper)},
        {"optimal, mean", {}, "%", savings_of(VqEncoder::vq2_optimal)},
        {"two maps of 64, mean", {}, "%", mean_of(sources_64x2)}},
       savings_by_texture},
      {"4.3 b",
       "VQ2 above two maps of 64 in the same bits: in excess of",
       Status::ok,
       textures_command,
       "as a share of the savings without a codec; on 36 free textures 37 % (ERRATA.md)",
       {{"gain over their savings", {10}, "%", relative_gain(VqEncoder::vq2_paper)},
        {"gain, points", {10}, "", gain(VqEncoder::vq2_paper)}}},
      {"4.3 c",
       "combinations of transforms over 170 textures",
       Status::differs,
       "bench vq --textures FOLDER --json OUT.json",
       "of 60 whole textures, and of their connected parts, which are more; both of 512 possible (ERRATA.md)",
       {{"chosen", {80}, "", chosen(&Choices::combinations)},
        {"chosen once", {50}, "", chosen(&Choices::once)},
        {"the commonest", {15}, "%", chosen(&Choices::commonest)}}},
      {"figure 7",
       "savings by resolution",
       Status::differs,
       textures_command,
       "a picture without numbers",
       {{"8x8, mean", {}, "%", mean_of(sources_8)},
        {"16x16, mean", {}, "%", mean_of(sources_16)},
        {"32x32, mean", {}, "%", mean_of(sources_32)}}},
  };
}

std::vector<Item> vq4_form() {
  return {
      {"5.1 a",
       "4x4 vectors without O beside T, of 3^16",
       Status::ok,
       "prove vq.vectors",
       "counted",
       {{"vectors", {231'713}, "", [](Measured&) { return std::vector<double>{continuous_vectors(4)}; }}}},
      {"table 2",
       "VQ4's indices and codes",
       Status::ok,
       "prove vq.codes vq4.block_bits",
       "VQ.md",
       {{"bits of the codebook", {247}, "", constant(512 - 64 * 4 - 3 * 3)},
        {"3 vectors of 17 bits", {51}, "", constant(3 * 17)},
        {"each vector of 18 bits", {18}, "", constant(18)},
        {"8 generic vectors of 20 bits", {160}, "", constant(8 * 20)},
        {"the same by its rows", {51 + 18 + 18 + 160}, "", constant(3 * 17 + 18 + 18 + 8 * 20)}}},
      {"figure 8", "the compatible vector of two", Status::ok, "prove vq4.conservative",
       "impl/vq/four/paper.cpp"},
      {"algorithm 2", "VQ4's codebook by partitions, for all 512 transforms", Status::differs, "bench vq",
       "its loop is open to readings (ERRATA.md)"},
      {"5.2", "more 20-bit vectors than entries: never met", Status::ok, textures_command,
       "nor here, on 36 free textures (VQ.md, The encoders)"},
  };
}

std::vector<Item> vq4_results() {
  return {
      {"figure 9",
       "a maple leaf's VQ4: O and T that became C, 85 of 834",
       Status::differs,
       textures_command,
       "another leaf: the share over all of ours",
       {{"lost by Algorithm 2", {100 * 85 / 834.0}, "%", lost_share(VqEncoder::vq4_paper)},
        {"lost by our default", {100 * 85 / 834.0}, "%", lost_share(VqEncoder::vq4_balanced)}}},
      {"figure 10",
       "savings of VQ4 across the textures",
       Status::differs,
       textures_command,
       "a picture without numbers; figure 6's page has the rows",
       {{"source 32x32, mean", {}, "%", mean_of(sources_32)},
        {"Algorithm 2, mean", {}, "%", savings_of(VqEncoder::vq4_paper)},
        {"default, mean", {}, "%", savings_of(VqEncoder::vq4_balanced)},
        {"16x16 in the same bits, mean", {}, "%", mean_of(sources_16)}}},
      {"5.3",
       "VQ4 above 16x16 in the same bits: around",
       Status::ok,
       textures_command,
       "as a share of the savings without a codec; on 36 free textures 18 % (ERRATA.md)",
       {{"gain over their savings", {10}, "%", relative_gain(VqEncoder::vq4_paper)},
        {"gain, points", {10}, "", gain(VqEncoder::vq4_paper)}}},
  };
}

std::vector<Item> future_maps() {
  return {
      {"6 a", "compressors with fewer substitutions", Status::ok, "bench vq",
       "VQ2 optimal, VQ4 within a proved bound (VQ.md, The encoders)"},
      {"6 b", "three states read as two, by a hash", Status::ok, "bench vq",
       "one reading measured (VQ.md, Three states read as two)"},
      {"6 c", "T or O favoured", Status::ok, "bench vq",
       "it hurts but where C is read as the other state (VQ.md)"},
      {"6 d", "deferred shaders of shadow rays; tighter boxes of pairs", Status::not_here, "",
       "Embree's traversal and boxes are its own"},
      {"6.1", "paint by brush", Status::ok, "bench vq", "one reading (VQ.md, The rivals)"},
      {"7",
       "memory of the uncompressed map",
       Status::ok,
       "prove vq2.block_bits vq4.block_bits",
       "256 of 512 bits, 512 of 2048",
       {{"VQ2, VQ4",
         {50, 25},
         "%",
         [](Measured&) {
           return std::vector<double>{100 * 256 / (2 * regions_of_vq2), 100 * 512 / (2 * regions_of_vq4)};
         }}}},
      {"figure 11", "the layout and the decoder", Status::differs,
       "prove vq2.region_is_map vq4.region_is_map", "the paper leaves the bits' order open; VQ.md fixes one"},
      {"figure 12",
       "Landscape: alpha tests a ray, 1.5 to 0.6",
       Status::differs,
       "render FILE --method vq2,vq4 --heat OUT.png",
       other_scenes,
       {{"fewer, by a format without a name; ours VQ2", {60}, "%", pairs_known(false)},
        {"ours VQ4", {60}, "%", pairs_known(true)}}},
  };
}

}  // namespace

std::vector<Item> compressed_maps() {
  return joined({introduction_of_maps(), maps_of_pairs(), vq2_form(), vq2_results(), vq4_form(),
                 vq4_results(), future_maps()});
}

}  // namespace mmverify::bench::papers
