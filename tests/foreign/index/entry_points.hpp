// The header's entry points for indices.
#pragma once

#include <cstddef>

#include "tests/foreign/index/numbers.hpp"

namespace mmverify::tests::foreign::index {

template <typename Real>
void indices(Word level, const Real* u, const Real* v, Word* index, std::size_t count);
void corners(Word level, const Word* index, Word* out, std::size_t count);
void row_indices(Word level, const float* u, const float* v, Word* index, std::size_t count);
void row_corners(Word level, const Word* index, Word* out, std::size_t count);

}  // namespace mmverify::tests::foreign::index
