// The laws of topic tree that do not go through maps one by one.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::tree {

/// The law that a decoder takes, among all byte strings of up to two bytes, exactly the codes of maps.
Law canonical_law();

/// The law of the bits that Algorithm 3 reads of the largest tree, index by index.
Law bits_read_law();

/// The law that the map in which no siblings merge needs the closed form's bits.
Law worst_size_law();

}  // namespace mmverify::proofs::tree
