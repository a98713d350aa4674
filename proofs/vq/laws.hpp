// The laws of topic vq, and its subjects.
#pragma once

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

}  // namespace mmverify::proofs::vq
