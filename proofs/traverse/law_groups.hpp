// The laws of topic traverse, by what they are about.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::traverse {

/// What becomes of a candidate, in every combination.
std::vector<Law> decision_laws();
/// What a lossy substitution of states may do to it.
std::vector<Law> lossy_laws();
/// Values of hits blended into a payload: which operations need no order.
std::vector<Law> blend_laws();
/// Blends of whole random payloads and values.
std::vector<Law> blend_sample_laws();
/// The same where hits are accepted among them.
std::vector<Law> order_laws();
/// The same of up to sixteen hits.
std::vector<Law> many_hits_laws();
/// What rays see, micromaps asked or not.
std::vector<Law> image_laws();
/// What hits that blend leave in a payload, along the same rays.
std::vector<Law> payload_laws();

}  // namespace mmverify::proofs::traverse
