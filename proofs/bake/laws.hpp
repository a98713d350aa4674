// The laws of topic bake, and its subjects.
#pragma once

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

}  // namespace mmverify::proofs::bake
