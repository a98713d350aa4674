// The laws of topic micromap, and its subjects.
#pragma once

#include "proofs/micromap/subject.hpp"

namespace mmverify::proofs::micromap {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

}  // namespace mmverify::proofs::micromap
