// The laws of topic tree that are not about maps one by one.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::tree {

/// Of all byte strings of up to two bytes, those that encode maps are taken, no others.
Law canonical_law();

/// What Algorithm 3 reads of the largest tree, index by index.
Law bits_read_law();

/// The map in which no siblings merge needs the closed form's bits.
Law worst_size_law();

}  // namespace mmverify::proofs::tree
