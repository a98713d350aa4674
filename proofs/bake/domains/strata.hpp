// Stratified samples: every value of every dimension of a case, and every pair of values, in turn.
//
// A row of the design names one value of each dimension.  The two sides run through all pairs by themselves;
// the others are chosen, row after row, so that as many pairs that no row has yet come together.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// What varies, besides the level.
enum Dimension : std::size_t {
  width_of,
  height_of,
  mips_of,       ///< 1, 2, 3, 5 or the whole chain; no more than the chain has
  deciding_mip,  ///< all, or mip 0, 1, 2, 3 or the last alone: the others have one alpha
  texel_of,
  filter_of,
  wrap_u_of,
  wrap_v_of,
  border_of,   ///< 0, the greatest, at the cutoff, a step below it, hostile
  factor_of,   ///< 1, 1/2, 0.3, 1.25, any 24 bits, 0, very small
  vertex_of,   ///< 1, 1/2, 0.7, any 24 bits, the factor's reciprocal, 0, very large
  cutoff_of,   ///< see Cutoffs
  margin_of,   ///< 0, 1/256, 0.1, 1/4, 1, 2.5 texels
  place_of,    ///< which texels the triangle's target lies among
  shape_of,    ///< of the triangle
  span_of,     ///< texels that a micro-triangle is long, of the mip that decides
  palette_of,  ///< which numbers texels have
  pattern_of,  ///< how they are spread
  dimensions
};

/// How many values each dimension has.
const std::array<std::uint8_t, dimensions>& values_of();

/// A side's values, from 1 to 16384, around powers of two and the words that hold rows of bits.
const std::array<std::uint32_t, 22>& sides();

using Row = std::array<std::uint8_t, dimensions>;
/// 22 x 22 rows, always the same ones.
const std::vector<Row>& design();

/// Textures have up to so many texels in mip 0, in one row of 16 (`large_row`) up to so many.  What has more
/// gets the next shorter of the sides along one axis.
inline constexpr std::uint64_t usual_texels = std::uint64_t{1} << 17, large_texels = std::uint64_t{1} << 20;
inline constexpr std::uint64_t plain_rows = std::uint64_t{1} << 20;
/// Plain, but for a whole chain of mips, of which any one decides alone.
inline constexpr std::uint64_t chain_rows = std::uint64_t{1} << 21;
/// Levels above have plain rows alone: where alpha is undecidable in floats, a million states take minutes.
inline constexpr Level highest_rows = 9;
constexpr bool large_row(std::uint64_t row) { return row % 16 == 15; }

/// Row `row` of the design (of its number of rows, the rest numbers another draw), filled in at random, its
/// micro-triangles of level n as long as the row says and as the specification's pace allows.  Of textures
/// with more than 1024 texels the case's text names this draw in their place.
/// From `plain_rows` on rows are filled in as a simple baker knows them: 8 bits, bilinear, MASK, one mip, without
/// factors and margins; from `chain_rows` on with a chain of mips, and texels on both sides of the cutoff.
/// Domain: seed, row below 2^32.
Case stratified(std::uint64_t seed, Level n, std::uint64_t row);

/// The texels that "drawn-SEED-LEVEL-ROW" stands for in a case's text.  Throws BadCase.
Case drawn_case(const std::string& name);

/// How many cases of a level run through the design once, over the fast tier's levels 0..9; and how many there are
/// with the plain ones, a fourth of all.
std::uint64_t fast_strata(Level n);
constexpr std::uint64_t with_plain(std::uint64_t cases) { return cases + cases / 3; }

/// Which row case k of a level is: every fourth is plain, above level 9 each; the others go on from where the level below ended.
std::uint64_t stratum(Level n, std::uint64_t k);

/// What the domain of a law says of them; of one that judges states.
const char* strata_text();
const char* judged_strata_text();

}  // namespace mmverify::proofs::bake
