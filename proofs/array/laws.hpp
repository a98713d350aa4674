// The laws of topic array, and its subjects.
#pragma once

#include "proofs/array/subject.hpp"

namespace mmverify::proofs::array {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

}  // namespace mmverify::proofs::array
