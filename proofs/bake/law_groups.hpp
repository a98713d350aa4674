// The laws of topic bake, by what they are about.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::bake {

/// What a state says of its micro-triangle.
std::vector<Law> state_laws();
/// What no state of a large texture may say.
Law large_law();
/// How maps of one texture hang together.
std::vector<Law> relation_laws();

}  // namespace mmverify::proofs::bake
