// Drawn cases with plateaus: one alpha, at the cutoff or a step beside it, but for a part of the texture.
#pragma once

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// Sample k of a level, the same everywhere: a texture of 12 to 64 columns and rows, 1,024 texels at most.  It has one
/// alpha except on a few texels, a block, some rows or a half plane.  That alpha, times the factors, is exactly at the
/// cutoff, as set_cutoff() places it; in one draw of six it is the next texel's, above or below.  A micro-triangle spans
/// at least 6 rows, and at most 40, 24, 16 and 12 at levels 0, 1, 2 and above.  Corners lie anywhere, on lines of texels
/// or of their centres, a step of binary32 beside these, or on a texel that differs.
/// Whoever judges some rows of a micro-triangle, and takes a texel at the cutoff for a sure one, errs here.
Case plateau_sample(std::uint64_t seed, Level n, std::uint64_t k);
const char* plateau_samples_text();

inline constexpr char plateau_begins[] = "plateau-";
/// The sample whose texels "plateau-SEED-LEVEL-NUMBER" stands for in a case's text.  Throws BadCase.
Case plateau_named(const std::string& name);

}  // namespace mmverify::proofs::bake
