// Levels of the fast tier, subject by subject.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs {

/// Subjects that the fast tier judges by a law on other levels than Law::fast, and which.
std::vector<std::pair<std::string, Levels>> fast_levels_apart(const Law& law);

/// The levels that the fast tier judges the subject on: its own, or Law::fast.
Levels fast_levels(const Law& law, const Subject& subject);

}  // namespace mmverify::proofs
