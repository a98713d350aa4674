// The cells and points that the laws of topic subdivision range over.
#pragma once

#include "proofs/subdivision/subject.hpp"
#include "spec/fixed.hpp"

namespace mmverify::proofs::subdivision {

using spec::Int128;
using spec::subdivision::side;

/// A cell by its index.
struct Indexed {
  Scheme scheme;
  Level level;
  std::uint64_t index;
};
/// A point of the unit shape, at a level.
struct Placed {
  Scheme scheme;
  Level level;
  Fractions point;
};

/// A law's level n is level n of each scheme, and levels 2n and 2n+1 of the bisection.
struct SchemeLevel {
  Scheme scheme;
  Level level;
};
std::vector<SchemeLevel> scheme_levels(Level n);

/// All cells of a law's level.
std::uint64_t cell_count(Level n);
Indexed cell_number(Level n, std::uint64_t k);

/// Each cell's corners, the midpoints of each two of them, and the mean of all.
std::uint64_t point_count(Level n);
Placed point_number(Level n, std::uint64_t k);

/// Points of all schemes that have this level, of any denominator; half of them lie on facets of cells, more or less.
Placed sample_point(Level n, std::uint64_t seed, std::uint64_t k);

/// "hilbert/3:k=12" and "hilbert/3:1,2,0/12"; the cell or the point of such a text, or BadCase.
std::string text_of(const Indexed& cell);
std::string text_of(const Placed& point);
Indexed cell_of_text(const std::string& text);
Placed point_of_text(const std::string& text);

/// A point in whole numbers, and the unit that they are multiples of at a level.
struct InWholes {
  At<Int128> point;
  Int128 unit;
};
InWholes in_wholes(Scheme scheme, Level n, const Fractions& p);

std::uint64_t specified_index(Scheme scheme, Level n, const Fractions& p);

}  // namespace mmverify::proofs::subdivision
