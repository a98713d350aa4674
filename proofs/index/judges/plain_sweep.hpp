// index.equals_reference of `step` the obvious way: what the fast sweep is measured against.
#pragma once

#include "proofs/engine/sweep.hpp"

namespace mmverify::proofs::index {

/// Every cell of the level by itself: its point, Algorithm 4 on it, the reference on it, compared. In 64-bit
/// fixed point, on all threads of the run. The same counts and digest as the law's.
/// Domain: n in 0..16.
Tally plain_sweep(Level n, const Run& run);

}  // namespace mmverify::proofs::index
