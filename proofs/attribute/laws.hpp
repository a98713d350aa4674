// The laws of topic attribute, and its subjects.
#pragma once

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

}  // namespace mmverify::proofs::attribute
