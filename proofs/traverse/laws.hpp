// The laws of topic traverse, and its subjects.
#pragma once

#include "proofs/traverse/subject.hpp"

namespace mmverify::proofs::traverse {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

}  // namespace mmverify::proofs::traverse
