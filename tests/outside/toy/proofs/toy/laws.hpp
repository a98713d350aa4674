// The laws of topic toy.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::toy {

std::vector<Law> laws();

}  // namespace mmverify::proofs::toy
