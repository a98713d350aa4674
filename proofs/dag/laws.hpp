// The laws of topic dag, and its subjects.
#pragma once

#include "proofs/dag/subject.hpp"

namespace mmverify::proofs::dag {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

}  // namespace mmverify::proofs::dag
