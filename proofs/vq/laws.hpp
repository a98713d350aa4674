// The laws of topic vq, and its subjects.
#pragma once

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// The vectors that exist.
Law vectors_law();
/// The eight transforms.
Law transforms_law();
/// The codes of vectors.
Law codes_law();
/// The bits of blocks.
std::vector<Law> field_laws();
/// Decoding of whole blocks and of single regions.
std::vector<Law> decoder_laws();
/// The changes that encoders may make to a map, and their promises.
std::vector<Law> encoder_laws();

}  // namespace mmverify::proofs::vq
