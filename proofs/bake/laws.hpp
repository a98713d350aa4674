// The laws of topic bake, and its subjects.
#pragma once

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// Laws of single states: each state is true of its micro-triangle.
std::vector<Law> state_laws();
/// The law of large textures: states that single points refute.
Law large_law();
/// Laws of whole meshes in one array.
std::vector<Law> mesh_laws();
/// Laws of coordinates that move and of texels that change.
std::vector<Law> changing_laws();
/// Relations between the maps of one texture.
std::vector<Law> relation_laws();

}  // namespace mmverify::proofs::bake
