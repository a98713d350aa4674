// Square maps and their codes, on a scene's own pairs of triangles.
#include "impl/vq.hpp"
#include "proofs/scene/exact_surface.hpp"
#include "proofs/scene/law_groups.hpp"
#include "proofs/scene/law_parts.hpp"
#include "spec/bake.hpp"
#include "spec/index.hpp"
#include "spec/vq_block.hpp"

namespace mmverify::proofs::scene {
namespace {

namespace vq = impl::vq;

/// A block decoded as the specification has it, against its map.
template <class Format, class Map, class Encoded>
Finding conservative(const Map& map, const Encoded& encoded) {
  const auto back = spec::vq::decode(spec::vq::from_bytes<Format>(encoded.block));
  std::uint32_t substitutions = 0;
  for (std::size_t k = 0; k < map.size(); ++k) {
    const auto was = static_cast<unsigned>(map[k]), is = static_cast<unsigned>(back[k]);
    if (was == is) continue;
    if (is != static_cast<unsigned>(vq::State::C))
      return {0, fmt::format("state {} or C of region {}", was, k), fmt::format("{}", is)};
    ++substitutions;
  }
  if (substitutions != encoded.substitutions)
    return {0, fmt::format("{} substitutions", substitutions), fmt::format("{}", encoded.substitutions)};
  return {hash_of(encoded.block), {}, {}};
}

/// A region is C if anything in it is, or O meets T, by the exact state of its two micro-triangles.
Finding exact_regions(const ExactSurfaces& exact, const impl::scene::Pair& pair, Level n,
                      const vq::State* map) {
  const std::uint32_t side = spec::side(n);
  std::vector<unsigned> marks(std::size_t{side} * side, 0);
  for (const bool turned : {false, true}) {
    const impl::scene::TriangleUse& use = turned ? pair.upper : pair.lower;
    for (std::uint32_t index = 0; index < side * side; ++index) {
      // A vertex of the planned triangle is (1,0), (0,1) or (0,0) of the pair's.
      std::array<std::uint32_t, 2> least{side, side};
      for (const spec::index::Vertex& v : spec::index::corners(index, n)) {
        const std::array<std::uint32_t, 3> planned{side - v.i - v.j, v.i, v.j};
        least[0] = std::min(least[0], planned[use.order[1]]);
        least[1] = std::min(least[1], planned[use.order[2]]);
      }
      const std::uint32_t x = turned ? side - 1 - least[0] : least[0],
                          y = turned ? side - 1 - least[1] : least[1];
      const spec::bake::State truly = exact.state(use.triangle, n, index);
      marks[x + std::size_t{side} * y] |= truly == spec::bake::State::T   ? 1u
                                          : truly == spec::bake::State::O ? 2u
                                                                          : 3u;
    }
  }
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const vq::State expected = marks[k] == 1 ? vq::State::T : marks[k] == 2 ? vq::State::O : vq::State::C;
    if (map[k] != expected)
      return {0, fmt::format("state {} of region {}", static_cast<unsigned>(expected), k),
              fmt::format("{}", static_cast<unsigned>(map[k]))};
  }
  return {marks.size(), {}, {}};
}

/// Each takes the exact states of a thousand micro-triangles: a few pairs, spread over all.
constexpr std::uint64_t few = 8;

}  // namespace

std::vector<Law> vq_laws(const Data& data) {
  const auto exact = std::make_shared<const ExactSurfaces>(data.scene, data.plan, data.margin);
  const auto pairs = [&data] { return std::uint64_t{data.pairs.distinct.size()}; };
  std::vector<Law> laws{
      over(
          {.id = "vq2.conservative",
           .topic = "vq",
           .says =
               "encoding a pair's map turns O and T into themselves or C, and counts its substitutions right",
           .source = "Compressed Opacity Maps, 3"},
          {"pairs", [pairs](Level n) { return n == 4 ? pairs() : 0; },
           [&data](Level, std::uint64_t k) {
             return conservative<spec::vq::Vq2>(data.squares.vq2[k], vq::encode_optimal(data.squares.vq2[k]));
           }}),
      over(
          {.id = "vq4.conservative",
           .topic = "vq",
           .says =
               "encoding a pair's map turns O and T into themselves or C, and counts its substitutions right",
           .source = "Compressed Opacity Maps, 3"},
          {"pairs", [pairs](Level n) { return n == 5 ? pairs() : 0; },
           [&data](Level, std::uint64_t k) {
             return conservative<spec::vq::Vq4>(data.squares.vq4[k], vq::encode(data.squares.vq4[k]));
           }})};
  Law squares =
      over({.id = "vq.square_map",
            .topic = "vq",
            .says = "a pair's square map is C where its region is mixed, and T or O where all of it is",
            .source = "Compressed Opacity Maps, 3; spec/bake_state.hpp"},
           {"pairs, spread over all", [pairs](Level n) { return n == 4 ? std::min(few, pairs()) : 0; },
            [&data, exact, pairs](Level n, std::uint64_t k) {
              const std::uint64_t number = k * pairs() / std::min(few, pairs());
              return exact_regions(*exact, data.pairs.distinct[number], n, data.squares.vq2[number].data());
            }});
  squares.method = Method::sample;
  laws.push_back(std::move(squares));
  return laws;
}

}  // namespace mmverify::proofs::scene
