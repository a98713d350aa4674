// The laws of topic vq, by what they are about.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::vq {

/// Which vectors there are.
Law vectors_law();
/// The eight transforms.
Law transforms_law();
/// The codes of vectors.
Law codes_law();
/// The bits of blocks.
std::vector<Law> field_laws();
/// Both ways to decode a block.
std::vector<Law> decoder_laws();
/// What encoders may do to a map, and what they promise of it.
std::vector<Law> encoder_laws();

}  // namespace mmverify::proofs::vq
