// Drawn cases with plateaus: most texels have one alpha, exactly at the cutoff or a step beside it.
#pragma once

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// Sample k of a level, the same everywhere: a texture of 12 to 64 columns and rows (1,024 texels at most), of one alpha
/// but for a few texels, a half plane, a block or some rows.  With the factors it is
/// at the cutoff, as set_cutoff() places it, or a step of the texel beside it.  A micro-triangle spans 6 to 40 rows (fewer at levels above 1).  Corners lie anywhere, on
/// lines of texels or of their centres, a step of binary32 beside these, or on a texel that differs.
/// Whoever judges some rows of a micro-triangle, and takes a texel at the cutoff for a sure one, errs here.
Case plateau_sample(std::uint64_t seed, Level n, std::uint64_t k);
const char* plateau_samples_text();

inline constexpr char plateau_begins[] = "plateau-";
/// The sample whose texels "plateau-SEED-LEVEL-NUMBER" stands for in a case's text.  Throws BadCase.
Case plateau_named(const std::string& name);

}  // namespace mmverify::proofs::bake
