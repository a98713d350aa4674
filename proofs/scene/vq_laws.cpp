// Square maps and their codes, on a scene's own pairs of triangles.
#include "impl/vq/vq.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/scene/exact_surface.hpp"
#include "proofs/scene/law_parts.hpp"
#include "proofs/scene/laws.hpp"
#include "proofs/scene/other_order.hpp"
#include "spec/vq/block.hpp"

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
      return wrong(fmt::format("state {} or C of region {}", was, k), fmt::format("{}", is));
    ++substitutions;
  }
  if (substitutions != encoded.substitutions)
    return wrong(fmt::format("{} substitutions", substitutions), fmt::format("{}", encoded.substitutions));
  return {hash_of(encoded.block)};
}

/// A region is C if anything in it is, or O meets T, by the exact states of its two micro-triangles.
Finding exact_region(const ExactSurfaces& exact, const mmverify::scene::Pair& pair, Level n, std::uint32_t x,
                     std::uint32_t y, vq::State got) {
  const std::uint32_t side = spec::side(n);
  unsigned marks = 0;
  for (const bool upper : {false, true}) {
    const mmverify::scene::TriangleUse& use = upper ? pair.upper : pair.lower;
    const std::uint32_t i = upper ? side - 1 - x : x, j = upper ? side - 1 - y : y;
    for (const std::uint32_t turned : {0u, 1u}) {
      if (i + j + turned >= side) continue;
      const std::uint32_t index =
          spec::index::curve(spec::index::grid_square<std::uint32_t>(i, j, turned != 0, side), side - 1);
      const spec::bake::State truly = exact.state(use.triangle, n, in_planned_order(index, n, use.order))
                                          .value();  // none of a pair varies
      marks |= truly == spec::bake::State::T ? 1u : truly == spec::bake::State::O ? 2u : 3u;
    }
  }
  const vq::State expected = marks == 1 ? vq::State::T : marks == 2 ? vq::State::O : vq::State::C;
  if (got != expected)
    return wrong(fmt::format("state {} of region ({}, {})", static_cast<unsigned>(expected), x, y),
                 fmt::format("{}", static_cast<unsigned>(got)));
  return {marks};
}

/// Regions that are looked at: they span thousands of texels each.
constexpr std::uint64_t regions = 32;

}  // namespace

std::vector<Law> vq_laws(const Data& data, const ExactSurfacesPtr& exact) {
  const auto pairs = [&data] { return std::uint64_t{data.pairs.distinct.size()}; };
  std::vector<Law> laws{
      on_cases(
          {.id = "vq2.conservative",
           .topic = "vq",
           .says =
               "encoding a pair's map turns O and T into themselves or C, and counts its substitutions right",
           .source = "Compressed Opacity Maps, 3"},
          {"pairs", [pairs](Level n) { return n == 4 ? pairs() : 0; },
           [&data](Level, std::uint64_t k) {
             return conservative<spec::vq::Vq2>(data.squares.vq2[k], data.codecs.vq2(data.squares.vq2[k]));
           }}),
      on_cases(
          {.id = "vq4.conservative",
           .topic = "vq",
           .says =
               "encoding a pair's map turns O and T into themselves or C, and counts its substitutions right",
           .source = "Compressed Opacity Maps, 3"},
          {"pairs", [pairs](Level n) { return n == 5 ? pairs() : 0; },
           [&data](Level, std::uint64_t k) {
             return conservative<spec::vq::Vq4>(data.squares.vq4[k], data.codecs.vq4(data.squares.vq4[k]));
           }})};
  Law squares =
      on_cases({.id = "vq.square_map",
                .topic = "vq",
                .says = "a pair's square map is C where its region is mixed, and T or O where all of it is",
                .source = "Compressed Opacity Maps, 3; spec/bake/state.hpp"},
               {"regions drawn from the pairs' maps",
                [pairs](Level n) { return (n == 4 || n == 5) && pairs() != 0 ? regions : 0; },
                [&data, exact, pairs](Level n, std::uint64_t k) {
                  Random random(1, 73, k);
                  const std::uint64_t number = random.below(pairs());
                  const std::uint32_t side = spec::side(n);
                  const auto x = static_cast<std::uint32_t>(random.below(side)),
                             y = static_cast<std::uint32_t>(random.below(side));
                  return exact_region(*exact, data.pairs.distinct[number], n, x, y,
                                      n == 4 ? data.squares.vq2[number][x + side * y]
                                             : data.squares.vq4[number][x + side * y]);
                }});
  squares.method = Method::sample;
  laws.push_back(std::move(squares));
  return laws;
}

}  // namespace mmverify::proofs::scene
