// Common mistakes of index functions, each as a function that makes this mistake alone.
//
// A vector finds a mistake if the mistaken function answers it wrongly.  The column `finds` of index.points lists them, so
// that a failing vector names its likely cause.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "delivery/vectors/binary32.hpp"
#include "spec/index/index.hpp"

namespace mmverify::vectors::index {

/// A point of a vector: its level, its two binary32 numbers by their bits, and their exact values.
struct Asked {
  spec::Level n;
  std::uint32_t u, v;
  spec::Point<Rational> p;
};

struct Mistake {
  const char* name;                        ///< the name in the set `finds`
  std::uint32_t (*index)(const Asked& a);  ///< right but for this mistake
};

/// All mistakes, in the order of the set's bits.
std::span<const Mistake> mistakes();

/// Their names, in this order.
std::vector<std::string> names_of_mistakes();

/// The mistakes whose function does not give `exact` for the point, bit k for mistake k.
/// Test: VectorsIndex.EachMistakeIsTheOneItsNameSays.
std::uint64_t found_by(const Asked& a, std::uint32_t exact);

}  // namespace mmverify::vectors::index
