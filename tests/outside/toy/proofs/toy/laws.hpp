// The laws of topic toy.
#pragma once

#include "proofs/toy/subject.hpp"

namespace mmverify::proofs::toy {

std::vector<Law> laws();

}  // namespace mmverify::proofs::toy
