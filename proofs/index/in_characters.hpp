// A wrong index as a picture of characters, for a terminal.
#pragma once

#include <string>
#include <vector>

#include "proofs/engine/result.hpp"

namespace mmverify::proofs::index {

/// Lines that show the micro-triangle expected (E) and the one returned (G) among their neighbours, each a
/// character: ^ upright, v upside down; u grows to the right, v upwards. At most 5 rows and a legend.
/// Empty if the law does not compare two indices of a level.
/// Domain: a counterexample of `result`.
std::vector<std::string> in_characters(const Result& result, const Counterexample& c);

}  // namespace mmverify::proofs::index
