// The laws of topic subdivision.
#pragma once

#include "proofs/subdivision/subject.hpp"

namespace mmverify::proofs::subdivision {

std::vector<Law> laws();

}  // namespace mmverify::proofs::subdivision
