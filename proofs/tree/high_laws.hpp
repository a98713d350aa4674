// The laws of topic tree that go to high levels on maps chosen for them.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::tree {

/// Maps of one state but for one node of the curve: all of them up to level 4, chosen ones up to level 12.
Law one_apart_law();
Law one_apart_samples_law();

/// Malformed and non-canonical codes above level 2.
Law damage_samples_law();

}  // namespace mmverify::proofs::tree
