// The three corners of a micro-triangle.
#pragma once

#include <array>

#include "tests/foreign/index/numbers.hpp"

namespace mmverify::tests::foreign::index {

struct Vertex {
  Word i = 0, j = 0;
};

struct Corners {
  std::array<Vertex, 3> of{};
};

/// Six words.
void write(const Corners& c, Word* out);

}  // namespace mmverify::tests::foreign::index
