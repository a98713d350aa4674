// The laws of topic bake, by what they are about.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::bake {

/// Laws of single states: each state is true of its micro-triangle.
std::vector<Law> state_laws();
/// The law of large textures: states that single points refute.
Law large_law();
/// Relations between the maps of one texture.
std::vector<Law> relation_laws();

}  // namespace mmverify::proofs::bake
