// The laws of topic tree, and its subjects.
#pragma once

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// The law that a decoder takes, among all byte strings of up to two bytes, exactly the codes of maps.
Law canonical_law();

/// The law of the bits that Algorithm 3 reads of the largest tree, index by index.
Law bits_read_law();

/// The law that the map in which no siblings merge needs the closed form's bits.
Law worst_size_law();

/// A lookup by barycentrics on binary32 numbers that are hard to place.
Law point_exact_on_floats_law();

/// The law, which asks for states at points k/4N: its domain says so, and the law on floats is its companion.
Law with_points_on_floats(Law law);

/// Maps of one state but for one node of the curve: all of them up to level 4, chosen ones up to level 12.
Law one_apart_law();
Law one_apart_samples_law();

/// Malformed and non-canonical codes above level 2.
Law damage_samples_law();

}  // namespace mmverify::proofs::tree
