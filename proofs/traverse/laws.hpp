// The laws of topic traverse, and its subjects.
#pragma once

#include "proofs/traverse/subject.hpp"

namespace mmverify::proofs::traverse {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// The outcome for a candidate, in every combination.
std::vector<Law> decision_laws();
/// The effects of a lossy substitution of states on a candidate.
std::vector<Law> lossy_laws();
/// Blends of hits into a payload, and the operations that need no order.
std::vector<Law> blend_laws();
/// Blends of whole random payloads and values.
std::vector<Law> blend_sample_laws();
/// Blends with accepted hits among them.
std::vector<Law> order_laws();
/// Blends of up to sixteen hits, accepted ones among them.
std::vector<Law> many_hits_laws();
/// Images along rays, with and without micromaps.
std::vector<Law> image_laws();
/// The payloads of hits that blend, along the same rays.
std::vector<Law> payload_laws();

}  // namespace mmverify::proofs::traverse
