// The laws of topic index that have files of their own.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::index {

/// About the arithmetic: floats, fixed point, and what a representative stands for.
std::vector<Law> arithmetic_laws();

/// About binary32 code: beside exact arithmetic the published code, or either.
std::vector<Law> dialect_laws();

/// About floats: the companions of those over cells.
std::vector<Law> float_laws();

/// About samples of every level up to 16.
std::vector<Law> sample_laws();

/// About levels beyond 16.
std::vector<Law> wide_laws();

/// About what the papers claim.  equals_reference: the law that Algorithm 4's claim is an instance of.
std::vector<Law> paper_laws(const Law& equals_reference);

}  // namespace mmverify::proofs::index
