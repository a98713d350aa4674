// Stratified samples: every value of every dimension of a case, and every pair of values, in turn.
//
// A row of the design names one value of each dimension.  The two sides run through all pairs by themselves;
// the others are chosen, row after row, so that as many pairs that no row has yet come together.
#pragma once

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// The dimensions that vary, besides the level.
enum Dimension : std::size_t {
  width_of,
  height_of,
  mips_of,       ///< 1, 2, 3, 5 or the whole chain, as far as the chain goes
  deciding_mip,  ///< all, or only mip 0, 1, 2, 3 or the last: the other mips have one alpha
  texel_of,
  filter_of,
  wrap_u_of,
  wrap_v_of,
  border_of,   ///< 0, the greatest, at the cutoff, a step below it, any
  factor_of,   ///< 1, 1/2, 0.3, 1.25, any 24 bits, 0, very small
  vertex_of,   ///< 1, 1/2, 0.7, any 24 bits, the factor's reciprocal, 0, very large
  cutoff_of,   ///< see Cutoffs
  margin_of,   ///< 0, 1/256, 0.1, 1/4, 1, 2.5 texels
  place_of,    ///< the region of the texture that the triangle's target lies in
  shape_of,    ///< the triangle's shape
  span_of,     ///< the length of a micro-triangle in texels of the deciding mip
  palette_of,  ///< the values of texels
  pattern_of,  ///< the arrangement of these values
  dimensions
};

/// The number of values of each dimension.
const std::array<std::uint8_t, dimensions>& values_of();

/// A side's values, from 1 to 16384, around powers of two and the words that hold rows of bits.
const std::array<std::uint32_t, 22>& sides();

using Row = std::array<std::uint8_t, dimensions>;
/// The design's 22 x 22 rows, always the same.
const std::vector<Row>& design();

/// The most texels of mip 0, in usual rows and in one row of 16 (`large_row`).  A larger texture gets the next
/// shorter sides along one axis.
inline constexpr std::uint64_t usual_texels = std::uint64_t{1} << 17, large_texels = std::uint64_t{1} << 20;
inline constexpr std::uint64_t plain_rows = std::uint64_t{1} << 20;
/// Plain rows with a whole chain of mips, of which any single one decides.
inline constexpr std::uint64_t chain_rows = std::uint64_t{1} << 21;
/// The highest level with rows that are not plain: beyond it, a million states that floats cannot decide take
/// minutes.
inline constexpr Level highest_rows = 9;
constexpr bool large_row(std::uint64_t row) { return row % 16 == 15; }

/// Row `row` of the design (modulo its number of rows; the rest numbers another draw), filled in at random.  A
/// micro-triangle of level n is as long as the row says, and short enough for the specification's speed.  The text of
/// a case with more than 1024 texels names this draw instead of the texels.
/// From `plain_rows` on, rows use the features of a simple baker: 8 bits, bilinear, MASK, one mip, no factors or
/// margins. From `chain_rows` on, they have a chain of mips, and texels on both sides of the cutoff.
/// Domain: seed, row below 2^32.
Case stratified(std::uint64_t seed, Level n, std::uint64_t row);

/// The case whose texels "drawn-SEED-LEVEL-NUMBER" stands for in a case's text.  Throws BadCase.
Case drawn_case(const std::string& name);

/// The number of cases of a level that run through the design once over the fast tier's levels 0..9.  with_plain()
/// adds the plain ones, a fourth of the sum.
std::uint64_t fast_strata(Level n);
constexpr std::uint64_t with_plain(std::uint64_t cases) { return cases + cases / 3; }

/// The row of case k of a level.  Every fourth case is plain, and above level 9 every case.  The others continue from
/// the end of the level below.
std::uint64_t stratum(Level n, std::uint64_t k);

/// The strata's text in the domain of a law, and in that of a law that judges states.
const char* strata_text();
const char* judged_strata_text();

}  // namespace mmverify::proofs::bake
