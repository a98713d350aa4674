// The laws of topic index that have files of their own.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::index {

/// About the arithmetic: floats, fixed point, and what a representative stands for.
std::vector<Law> arithmetic_laws();

/// About levels beyond 16.
std::vector<Law> wide_laws();

/// About what the papers claim.  equals_reference: the law that Algorithm 4's claim is an instance of.
std::vector<Law> paper_laws(const Law& equals_reference);

}  // namespace mmverify::proofs::index
