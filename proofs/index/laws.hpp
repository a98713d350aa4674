// The laws of topic index, and its subjects.
#pragma once

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// The highest level that any law of the topic is defined at.
constexpr Level max_level = 30;

}  // namespace mmverify::proofs::index
