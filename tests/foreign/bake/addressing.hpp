// The address modes of an axis.
#pragma once

#include "tests/foreign/bake/numbers.hpp"

namespace mmverify::tests::foreign::bake {

/// The texel that index i addresses along an axis of `size` texels; -1: the border.
Index wrapped(Index i, Index size, unsigned mode, bool along_u);

struct Range {
  Index low, high;
};
inline constexpr Index endless = Index{1} << 62;

/// Cells [i, i+1] (bilinear: between texel centres; nearest: texels) below low and above high look like low
/// and high themselves.
Range distinct(Index size, unsigned mode, bool nearest);

/// After how many texels an axis repeats itself; endless: never.
Index period(Index size, unsigned mode);

}  // namespace mmverify::tests::foreign::bake
