// The arrays that the laws range over: a geometry's maps and how to build them, and a built array with
// something spoilt.
#pragma once

#include "proofs/micromap/subject.hpp"

namespace mmverify::proofs::micromap {

/// Maps of levels up to n, some of them repeated, some but for one state, some uniform, both formats; up to five
/// that the array has before, and a base triangle among those; and options.  Sample k of a seed is the same
/// everywhere.
struct BuildCase {
  std::vector<PackedMap> before, maps;
  Options options;
};
BuildCase sample_build(Level n, std::uint64_t seed, std::uint64_t k);

/// An array as a validator gets it, and what it is held in.  Neither copied nor moved: `in` points into it.
struct Handed {
  Bytes records, data, indices;
  std::vector<UsageCount> array_counts, geometry_counts;
  Input in;

  Handed() = default;
  Handed(const Handed&) = delete;
  Handed& operator=(const Handed&) = delete;
  /// Points `in` at the parts, whatever became of them.
  void point();
};

/// Fills a clean array, as the specification builds a case.
void hand_over(const BuildCase& c, Handed& handed);

/// The clean array of a sample with up to three things spoilt: a byte, a size, a number.
void sample_spoilt(Level n, std::uint64_t seed, std::uint64_t k, Handed& handed);

/// "sample:SEED:K".  Throws BadCase.
std::string text_of(std::uint64_t seed, std::uint64_t k);
std::pair<std::uint64_t, std::uint64_t> sample_from(const std::string& text);

}  // namespace mmverify::proofs::micromap
