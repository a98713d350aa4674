// The laws of topic tree, and its subjects.
#pragma once

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

}  // namespace mmverify::proofs::tree
