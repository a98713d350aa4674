// Along the curve: indices from words and by steps.
#pragma once

#include "tests/foreign/index/numbers.hpp"

namespace mmverify::tests::foreign::index {

/// Algorithm 4, for its faults alone.
template <typename Real>
Word step(Word level, Real u, Real v);

/// The bits of the index from the grid square and its half.
Word curve(Word level, Word iu, Word iv, Word iw, bool cold);

}  // namespace mmverify::tests::foreign::index
